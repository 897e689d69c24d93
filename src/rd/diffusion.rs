//! The diffusion tensor of every cell as stencil weights.

use super::coefficients::Coefficients;
use super::plane::{LANES, RowLayout};
use super::selling::{OFFSETS, Tensor};

/// Stencil weights of each cell of a grid.
#[derive(Clone, Debug)]
pub struct Diffusion {
    /// The weight of each of [`OFFSETS`]; of a group of cells only those that some cell of it uses.
    pub weights: Coefficients<{ OFFSETS.len() }>,
    /// The largest sum of weights of any cell: dt·D·this ≤ ½ keeps an explicit step monotone.
    pub largest: f32,
    /// How far the offsets in use reach, cells.
    pub reach: usize,
}

impl Diffusion {
    /// Computes the weights of the `tensor` of each cell, as [`Coefficients::new`] does.
    pub fn new<K: Copy + PartialEq>(
        grid: RowLayout,
        key: impl Fn(usize) -> K + Sync,
        tensor: impl Fn(K) -> Tensor + Sync,
    ) -> Self {
        let weights = Coefficients::sparse(grid, key, |key| tensor(key).stencil());
        let (mut largest, mut reach) = (0.0f32, 1);
        for (used, packs) in weights.groups_in_use() {
            for j in 0..LANES {
                largest = largest.max(packs.iter().map(|pack| pack.0[j]).sum());
            }
            for (k, [dx, dy]) in OFFSETS.into_iter().enumerate() {
                if used & (1 << k) != 0 {
                    reach = reach.max(dx.unsigned_abs()).max(dy.unsigned_abs());
                }
            }
        }
        Self { weights, largest, reach }
    }
}
