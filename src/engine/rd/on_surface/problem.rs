//! The coefficients of a system on a surface.

use std::sync::Arc;

use crate::rd::definition::System;
use crate::rd::growth::DIFFUSION_LIMIT;
use crate::rd::kinetics::{Spreading, tensors};
use crate::rd::parameter_field::Parameters;
use crate::rd::sparse::{Operators, ROWS, SparseProblem};
use crate::rd::super_step;

impl SparseProblem {
    /// Coefficients with the largest Euler step that is stable, and super steps as long as the reactions allow.
    #[must_use]
    pub fn new(system: System, operators: Arc<Operators>, parameters: &[Parameters]) -> Self {
        let definition = system.definition();
        let isotropic = tensors(definition.spread);
        let (mut diffusion, mut rates) = (f32::MIN_POSITIVE, [f32::INFINITY, f32::MIN_POSITIVE]);
        for (row, vertex) in operators.order.iter().enumerate() {
            let own = &parameters[*vertex as usize];
            let mobilities = (definition.mobilities)(own);
            for spreading in definition.spread {
                let (operator, mobility) = match *spreading {
                    Spreading::Tensor { tensor, mobility } => (tensor, mobility),
                    Spreading::Isotropic { mobility } => (isotropic, mobility),
                    Spreading::Still => continue,
                };
                diffusion = diffusion.max(mobilities[mobility] * operators.rows[operator].sum(row));
            }
            rates = [rates[0].min(own.rate), rates[1].max(own.rate)];
        }
        // The stencils of grids count each weight for two neighbours.
        let scale = (2.0 * DIFFUSION_LIMIT / diffusion).min(definition.reaction_limit / rates[1]);
        let filled = operators.order.len().next_multiple_of(ROWS);
        let of = |value: &dyn Fn(&Parameters) -> f32| {
            let mut values: Vec<f32> =
                operators.order.iter().map(|vertex| scale * value(&parameters[*vertex as usize])).collect();
            values.resize(filled, 0.0);
            values
        };
        Self {
            mobility: std::array::from_fn(|m| of(&|p| (definition.mobilities)(p)[m])),
            rate: of(&|p| p.rate),
            slowest: scale * rates[0],
            stages: super_step::suited(scale * rates[1], definition.super_step_limit),
            operators,
        }
    }
}
