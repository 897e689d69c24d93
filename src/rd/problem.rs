//! A system with all its coefficients on a grid: what a solver steps.

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::plane::Grid;

/// Coefficients of every cell, the time step already inside.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The cells.
    pub grid: Grid,
    /// The tensor of each cell.
    pub diffusion: Diffusion,
    /// Weights of the isotropic stencil along x and along y.
    pub isotropic: [f32; 2],
    /// dt·D of each cell, by mobility number.
    pub mobility: Coefficients<2>,
    /// dt·s of each cell.
    pub rate: Coefficients<1>,
    /// The lowest of these.
    pub slowest: f32,
}
