//! The diffusion tensor of every cell as stencil weights, and where which of them are in use.

use super::coefficients::Coefficients;
use super::plane::{Grid, LANES, MARGIN};
use super::selling::{OFFSETS, REACH, Tensor};
use crate::field::Edges;

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
    /// Where the runs of each row begin in `runs`.
    rows: Vec<u32>,
    runs: Vec<Run>,
}

/// Groups of one row that are stepped alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The first group after it.
    pub end: u32,
    /// The offsets that they use, as bits.
    pub used: u8,
    /// Whether all their weights are 1: isotropic diffusion on square cells.
    pub unit: bool,
    /// Whether something beyond a closed edge is within reach.
    pub edge: bool,
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
        let (mut rows, mut runs) = (vec![], vec![]);
        for y in 0..grid.ny {
            let row = runs_of(grid, y, &weights);
            let above = rows.last().map_or(0, |first| *first as usize);
            if runs[above..] != row {
                rows.push(runs.len() as u32);
                runs.extend_from_slice(&row);
            } else {
                rows.push(above as u32);
            }
        }
        Self { weights, largest, reach, rows, runs }
    }

    /// The runs of row `y` and of the rows after it, from the first group on; those of a row end with its last group.
    #[must_use]
    pub fn runs(&self, y: usize) -> &[Run] {
        &self.runs[self.rows[y] as usize..]
    }
}

fn runs_of(grid: Grid, y: usize, weights: &Coefficients<{ CENTER + 1 }>) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for group in 0..grid.groups() {
        let (kept, packs) = weights.of(group, y);
        // The bits of the offsets, without that of the centre.
        let used = (kept & ((1 << CENTER) - 1)) as u8;
        let unit = used == 0b11 && packs[..2].iter().all(|pack| pack.0 == [1.0; LANES]);
        let left = group * LANES < MARGIN + REACH;
        let right = (group + 1) * LANES + REACH > MARGIN + grid.nx;
        let near = left || right || y < REACH || y + REACH >= grid.ny;
        let edge = near && grid.edges == Edges::Closed;
        match runs.last_mut() {
            Some(last) if (last.used, last.unit, last.edge) == (used, unit, edge) => {
                last.end = group as u32 + 1;
            }
            _ => runs.push(Run { end: group as u32 + 1, used, unit, edge }),
        }
    }
    runs
}
