//! The coefficients of a system on a surface, as its solvers use them.

use std::sync::Arc;

use super::operators::Operators;
use super::slices::ROWS;
use crate::rd::definition::System;
use crate::rd::growth::DIFFUSION_LIMIT;
use crate::rd::kinetics::{MOBILITIES, Spreading, tensors};
use crate::rd::maps::Parameters;
use crate::rd::super_step;

/// Coefficients of every row, multiplied by the time step. Rows are filled up to whole slices; what is filled up stands still.
#[derive(Clone, Debug)]
pub struct SurfaceProblem {
    /// The Laplacians.
    pub operators: Arc<Operators>,
    /// dt·D of each row, by mobility number.
    pub mobility: [Vec<f32>; MOBILITIES],
    /// dt·s of each row.
    pub rate: Vec<f32>,
    /// The lowest of these, of rows that are not frozen.
    pub slowest: f32,
    /// Stages of a super step; 1 = Euler steps.
    pub stages: usize,
}

impl SurfaceProblem {
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

    /// Keeps the vertices that `frozen` names constant from now on. They still affect their neighbours.
    pub fn freeze(&mut self, frozen: impl Fn(usize) -> bool) {
        // A step adds 0 × (diffusion and reaction), which is 0 as long as these are finite.
        for (row, vertex) in self.operators.order.iter().enumerate() {
            if frozen(*vertex as usize) {
                self.mobility.iter_mut().for_each(|mobility| mobility[row] = 0.0);
                self.rate[row] = 0.0;
            }
        }
    }
}
