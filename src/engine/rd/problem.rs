//! The coefficients of a system on a grid, as solvers use them.

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::kinetics::MOBILITIES;
use super::plane::RowLayout;
use super::runs::Runs;

/// Coefficients of every cell, multiplied by the time step.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The cells.
    pub grid: RowLayout,
    /// The tensors of each cell, by number; at least one.
    pub tensors: Vec<Diffusion>,
    /// Largest component of the offsets of all these tensors, cells.
    pub reach: usize,
    /// Weights of the isotropic stencil along x and along y.
    pub isotropic: [f32; 2],
    /// dt·D of each cell, by mobility number.
    pub mobility: Coefficients<MOBILITIES>,
    /// dt·s of each cell.
    pub rate: Coefficients<1>,
    /// The lowest of these, before any cell was frozen.
    pub slowest: f32,
    /// Groups of cells that are stepped in one way.
    pub runs: Runs,
    /// Stages of a super step; 1 = Euler steps.
    pub stages: usize,
}

impl Problem {
    /// A problem for Euler steps: at least one tensor; `isotropic` are the weights of the isotropic stencil along x and along y.
    #[must_use]
    pub fn new(
        grid: RowLayout,
        tensors: Vec<Diffusion>,
        isotropic: [f32; 2],
        mobility: Coefficients<MOBILITIES>,
        rate: Coefficients<1>,
        slowest: f32,
    ) -> Self {
        let runs = Runs::new(grid, &tensors, &mobility, &rate);
        let reach = tensors.iter().map(|tensor| tensor.reach).fold(1, usize::max);
        Self { grid, tensors, reach, isotropic, mobility, rate, slowest, runs, stages: 1 }
    }

    /// Weights of the isotropic stencil along x, along y, and of the cell itself.
    #[must_use]
    pub fn isotropic_weights(&self) -> [f32; 3] {
        let [x, y] = self.isotropic;
        [x, y, 2.0 * (x + y)]
    }

    /// Keeps the cells that `frozen` names (`y · nx + x`) constant from now on. They still affect their neighbours.
    pub fn freeze(&mut self, frozen: &(impl Fn(usize) -> bool + Sync)) {
        // A step adds 0 × (diffusion and reaction), which is 0 as long as these are finite.
        self.mobility =
            self.mobility.with(self.grid, |cell, own| if frozen(cell) { [0.0; MOBILITIES] } else { own });
        self.rate = self.rate.with(self.grid, |cell, own| if frozen(cell) { [0.0] } else { own });
        self.runs = Runs::new(self.grid, &self.tensors, &self.mobility, &self.rate);
    }
}
