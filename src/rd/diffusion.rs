//! The diffusion tensor of every cell as stencil weights.

use super::coefficients::Coefficients;
use super::plane::{Grid, LANES};
use super::selling::{OFFSETS, Tensor};

/// The place of 2 Σₖ wₖ among a cell's numbers, after the weights.
pub const CENTER: usize = OFFSETS.len();

/// Stencil weights of each cell of a grid.
#[derive(Clone, Debug)]
pub struct Diffusion {
    /// The weight of each of [`OFFSETS`], of a group of cells only those that some cell of it uses; and, at
    /// [`CENTER`], twice their sum, the weight of the cell itself.
    pub weights: Coefficients<{ CENTER + 1 }>,
    /// The largest sum of weights of any cell: dt·D·this ≤ ½ keeps an explicit step monotone.
    pub largest: f32,
    /// How far the offsets in use reach, cells.
    pub reach: usize,
}

impl Diffusion {
    /// Asks `tensor` for each cell, as [`Coefficients::new`] does.
    pub fn new<K: Copy + PartialEq>(
        grid: Grid,
        key: impl Fn(usize) -> K + Sync,
        tensor: impl Fn(K) -> Tensor + Sync,
    ) -> Self {
        let weights = Coefficients::new(grid, true, key, |key| {
            let weights = tensor(key).weights();
            let mut numbers = [0.0; CENTER + 1];
            numbers[..CENTER].copy_from_slice(&weights);
            numbers[CENTER] = 2.0 * weights.iter().sum::<f32>();
            numbers
        });
        let (mut largest, mut reach) = (0.0f32, 1);
        for (used, packs) in weights.groups_in_use() {
            let center = packs.last().map_or([0.0; LANES], |pack| pack.0);
            largest = center.iter().fold(largest, |largest, center| largest.max(0.5 * center));
            for (k, [dx, dy]) in OFFSETS.into_iter().enumerate() {
                if used & (1 << k) != 0 {
                    reach = reach.max(dx.unsigned_abs()).max(dy.unsigned_abs());
                }
            }
        }
        Self { weights, largest, reach }
    }
}
