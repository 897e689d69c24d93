//! The diffusion tensor of every cell as stencil weights, and where which of them are in use.

use super::selling::{OFFSETS, Tensor};

/// Cells whose stencils are looked at together: one row is cut into segments of this length.
pub const SEGMENT: usize = 64;

/// Stencil weights of each cell of a grid of `nx` × `ny` cells.
#[derive(Clone, Debug)]
pub struct Diffusion {
    nx: usize,
    /// `weights[k][y * nx + x]`: weight of `OFFSETS[k]` at that cell.
    pub weights: Vec<Vec<f32>>,
    /// For each segment of each row, bit k is set where some cell gives offset k a weight.
    used: Vec<u8>,
    /// The largest sum of weights of any cell: dt·D·this ≤ ½ keeps an explicit step monotone.
    pub largest: f32,
}

impl Diffusion {
    /// Asks `tensor` for each cell, row by row.
    pub fn new(nx: usize, ny: usize, tensor: impl Fn(usize) -> Tensor + Sync) -> Self {
        use rayon::prelude::*;
        let per_cell: Vec<[f32; OFFSETS.len()]> =
            (0..nx * ny).into_par_iter().map(|cell| tensor(cell).weights()).collect();
        let weights = (0..OFFSETS.len()).map(|k| per_cell.iter().map(|w| w[k]).collect()).collect();
        let mut used = Vec::with_capacity(ny * nx.div_ceil(SEGMENT));
        for row in per_cell.chunks(nx) {
            for segment in row.chunks(SEGMENT) {
                used.push(
                    (0..OFFSETS.len())
                        .fold(0, |bits, k| bits | u8::from(segment.iter().any(|w| w[k] > 0.0)) << k),
                );
            }
        }
        let largest = per_cell.iter().map(|w| w.iter().sum::<f32>()).fold(0.0, f32::max);
        Self { nx, weights, used, largest }
    }

    /// The offsets in use in segment `segment` of row `y`, as bits.
    #[must_use]
    pub fn used(&self, segment: usize, y: usize) -> u8 {
        self.used[y * self.nx.div_ceil(SEGMENT) + segment]
    }
}
