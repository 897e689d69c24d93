//! A system with all its coefficients on a grid: what a solver steps.

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::plane::RowLayout;
use super::runs::Runs;

/// Coefficients of every cell, the time step already inside.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The cells.
    pub grid: RowLayout,
    /// The tensor of each cell.
    pub diffusion: Diffusion,
    /// Weights of the isotropic stencil along x and along y.
    pub isotropic: [f32; 2],
    /// dt·D of each cell, by mobility number.
    pub mobility: Coefficients<2>,
    /// dt·s of each cell.
    pub rate: Coefficients<1>,
    /// The lowest of these, before any cell was frozen.
    pub slowest: f32,
    /// Which cells are stepped alike.
    pub runs: Runs,
}

impl Problem {
    /// Puts coefficients together; `isotropic` are the weights of the isotropic stencil along x and along y.
    #[must_use]
    pub fn new(
        grid: RowLayout,
        diffusion: Diffusion,
        isotropic: [f32; 2],
        mobility: Coefficients<2>,
        rate: Coefficients<1>,
        slowest: f32,
    ) -> Self {
        let runs = Runs::new(grid, &diffusion.weights, &mobility, &rate);
        Self { grid, diffusion, isotropic, mobility, rate, slowest, runs }
    }

    /// Weights of the isotropic stencil along x, along y, and of the cell itself.
    #[must_use]
    pub fn isotropic_weights(&self) -> [f32; 3] {
        let [x, y] = self.isotropic;
        [x, y, 2.0 * (x + y)]
    }

    /// Leaves the cells that `frozen` names (`y · nx + x`) as they are from now on. Their neighbours still see them.
    pub fn freeze(&mut self, frozen: &(impl Fn(usize) -> bool + Sync)) {
        // A step adds 0 · what diffusion and reaction would do, which is 0 while that is finite.
        self.mobility = self.mobility.with(self.grid, |cell, own| if frozen(cell) { [0.0; 2] } else { own });
        self.rate = self.rate.with(self.grid, |cell, own| if frozen(cell) { [0.0] } else { own });
        self.runs = Runs::new(self.grid, &self.diffusion.weights, &self.mobility, &self.rate);
    }
}
