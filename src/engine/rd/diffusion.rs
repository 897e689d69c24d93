//! The diffusion tensor of every cell as stencil weights.

use super::coefficients::Coefficients;
use super::plane::{LANES, Lanes, RowLayout};
use super::selling::{OFFSETS, PrincipalAxes};
use super::stencil_lanes::StencilLanes;

/// Stencil weights of each cell of a grid.
#[derive(Clone, Debug)]
pub struct Diffusion {
    /// The weight of each of [`OFFSETS`]; a group of cells stores only the weights that some cell of it uses.
    pub weights: Coefficients<{ OFFSETS.len() }>,
    /// The largest sum of weights of any cell: an explicit step is monotone if dt·D·(this sum) ≤ ½.
    pub largest: f32,
    /// Longest reach of the offsets in use, cells.
    pub reach: usize,
}

impl Diffusion {
    /// The weights of the tensor of each cell, by its number `y · nx + x`, on cells that are `cell[0]` wide and `cell[1]` high (in any
    /// common unit).
    pub fn new(grid: RowLayout, cell: [f64; 2], axes: impl Fn(usize) -> PrincipalAxes + Sync) -> Self {
        let weights = Coefficients::sparse(grid, || {
            let mut lanes = StencilLanes::new(cell);
            let axes = &axes;
            move |cells, weights: &mut [Lanes; OFFSETS.len()]| lanes.write(&cells.map(axes), weights)
        });
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
