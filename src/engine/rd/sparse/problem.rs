//! The coefficients of a system on sparse rows, as solvers use them.

use std::sync::Arc;

use super::operators::Operators;
use crate::rd::kinetics::MOBILITIES;

/// Coefficients of every row, multiplied by the time step. Rows are padded to whole slices; values in the padding do not change.
#[derive(Clone, Debug)]
pub struct SparseProblem {
    /// The Laplacians.
    pub operators: Arc<Operators>,
    /// dt·D of each row, by mobility number.
    pub mobility: [Vec<f32>; MOBILITIES],
    /// dt·s of each row.
    pub rate: Vec<f32>,
    /// The lowest of these, before any row was frozen.
    pub slowest: f32,
    /// Stages of a super step; 1 = Euler steps.
    pub stages: usize,
}

impl SparseProblem {
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
