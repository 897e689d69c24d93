//! Means over wide neighbourhoods: sums over blocks of cells, blurred, and interpolated between the blocks.

use crate::grid::Edges;
use crate::grid::blur::gaussian;
use rayon::prelude::*;

/// Blocks per standard deviation of the blur: coarser blocks become visible in the interpolated values.
const BLOCKS: f64 = 6.0;

/// A field of blocks of cells.
#[derive(Clone, Debug)]
pub struct Coarse {
    /// Columns and rows of blocks.
    pub size: [usize; 2],
    /// Cells per block along each side.
    pub block: usize,
    /// One value for each block.
    pub values: Vec<f32>,
}

/// The layout of blocks of cells.
#[derive(Clone, Copy, Debug)]
pub struct Blocks {
    cells: [usize; 2],
    size: [usize; 2],
    block: usize,
    sigma: f64,
}

impl Blocks {
    /// Blocks for means over a Gaussian of `sigma` cells on a grid of `cells`.
    #[must_use]
    pub fn new(cells: [usize; 2], sigma: f64) -> Self {
        let block = ((sigma / BLOCKS) as usize).max(1);
        Self { cells, size: cells.map(|side| side.div_ceil(block)), block, sigma }
    }

    /// Number of blocks.
    #[must_use]
    pub fn len(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// Cells a block.
    #[must_use]
    pub fn cells_a_block(&self) -> usize {
        self.block * self.block
    }

    /// The sums over the blocks of `N` numbers per cell, each blurred. `of` takes the index of a cell, its column and its row.
    #[must_use]
    pub fn blurred<const N: usize, R>(
        &self,
        row: impl Fn(usize) -> R + Sync,
        of: impl Fn(&R, usize, usize) -> [f32; N] + Sync,
    ) -> [Vec<f32>; N] {
        let mut sums = vec![[0.0_f32; N]; self.len()];
        sums.par_chunks_mut(self.size[0]).enumerate().for_each(|(band, sums)| {
            for y in band * self.block..((band + 1) * self.block).min(self.cells[1]) {
                let row = row(y);
                for x in 0..self.cells[0] {
                    let sum = &mut sums[x / self.block];
                    let more = of(&row, x, y * self.cells[0] + x);
                    (0..N).for_each(|k| sum[k] += more[k]);
                }
            }
        });
        let sigma = self.sigma / self.block as f64;
        std::array::from_fn(|k| {
            let plane: Vec<f32> = sums.iter().map(|sum| sum[k]).collect();
            gaussian(&plane, self.size, sigma, Edges::Closed)
        })
    }

    /// A field with these values, one a block.
    #[must_use]
    pub fn field(&self, values: Vec<f32>) -> Coarse {
        Coarse { size: self.size, block: self.block, values }
    }
}

impl Coarse {
    /// The values along a row of cells, by linear interpolation between the rows of blocks: one a column of blocks.
    #[must_use]
    pub fn row(&self, y: usize) -> Vec<f32> {
        let (above, below, share) = self.between(y, self.size[1]);
        let [above, below] =
            [above, below].map(|row| &self.values[row * self.size[0]..(row + 1) * self.size[0]]);
        above.iter().zip(below).map(|(above, below)| above + share * (below - above)).collect()
    }

    /// The value in a column of cells of such a row.
    #[must_use]
    pub fn in_row(&self, row: &[f32], x: usize) -> f32 {
        let (left, right, share) = self.between(x, self.size[0]);
        row[left] + share * (row[right] - row[left])
    }

    /// The blocks before and after a cell, and the share of the second.
    fn between(&self, cell: usize, blocks: usize) -> (usize, usize, f32) {
        let at = ((cell as f32 + 0.5) / self.block as f32 - 0.5).max(0.0);
        let low = (at as usize).min(blocks - 1);
        (low, (low + 1).min(blocks - 1), at - low as f32)
    }

    /// The value of each cell of a grid of `cells`.
    #[must_use]
    pub fn cells(&self, cells: [usize; 2]) -> Vec<f32> {
        let mut values = vec![0.0; cells[0] * cells[1]];
        values.par_chunks_mut(cells[0].max(1)).enumerate().for_each(|(y, out)| {
            let row = self.row(y);
            out.iter_mut().enumerate().for_each(|(x, out)| *out = self.in_row(&row, x));
        });
        values
    }
}

/// `values` on `size` cells, blurred by a wide Gaussian of `sigma` cells, accurate to about a hundredth of their variation.
#[must_use]
pub fn wide(values: &[f32], size: [usize; 2], sigma: f64) -> Vec<f32> {
    let blocks = Blocks::new(size, sigma);
    let [sum, count] = blocks.blurred(|_| (), |(), _, cell| [values[cell], 1.0]);
    blocks.field(sum.iter().zip(&count).map(|(sum, count)| sum / count).collect()).cells(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wide_blur_is_the_gaussian_one_nearly() {
        let size = [90, 70];
        let wave = |k: usize| (0.1 * (k % 90) as f32).sin() + (0.07 * (k / 90) as f32).cos();
        let values: Vec<f32> = (0..size[0] * size[1]).map(wave).collect();
        let exact = gaussian(&values, size, 14.0, Edges::Closed);
        let off =
            wide(&values, size, 14.0).iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 0.02, "{off}");
    }
}
