//! A system with all its coefficients on a grid: what a solver steps.

use super::diffusion::Diffusion;
use crate::field::Edges;

/// Coefficients of every cell, the time step already inside.
#[derive(Clone, Debug)]
pub struct Problem {
    /// Cells in a row.
    pub nx: usize,
    /// Rows.
    pub ny: usize,
    /// What lies beyond the border.
    pub edges: Edges,
    /// The tensor of each cell.
    pub diffusion: Diffusion,
    /// Weights of the isotropic stencil along x and along y.
    pub isotropic: [f32; 2],
    /// dt·D of each cell, by mobility number.
    pub mobility: [Vec<f32>; 2],
    /// dt·s of each cell.
    pub rate: Vec<f32>,
}
