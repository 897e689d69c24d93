//! Sparse rows in slices of [`ROWS`], column by column, so that vector instructions step all rows of a slice at once.
//!
//! Kreutzer, Hager, Wellein, Fehske & Bishop, "A unified sparse matrix data format for efficient general sparse matrix-vector
//! multiplication on modern processors with wide SIMD units", SIAM J. Sci. Comput. 36 (2014): SELL-C-σ, with C = [`ROWS`] and σ =
//! [`SORTED`].

use super::sparse_rows::SparseRows;
use crate::surface::Laplacian;

/// Rows of a slice.
pub const ROWS: usize = 16;
/// Number of rows that are sorted by their length together, so that the rows of a slice have about one length. In longer sequences
/// neighbours would be separated.
const SORTED: usize = 8 * ROWS;

/// The entries of one column of a slice.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// By row, its weight; 0 beyond the end of a row.
    pub weights: [f32; ROWS],
    /// By row, the index of the concentrations that the weight multiplies; beyond the end of a row the index of the row itself.
    pub at: [u32; ROWS],
}

/// Sparse rows by slice.
#[derive(Clone, Debug)]
pub struct Slices {
    /// Start of the columns of each slice, and the end of the last.
    pub starts: Vec<u32>,
    /// The columns of all slices.
    pub columns: Vec<Column>,
}

/// The order of rows in slices (`order[new] = old`): longer rows first, but none leaves its own [`SORTED`].
#[must_use]
pub fn order(laplacian: &Laplacian) -> Vec<u32> {
    let length = |row: u32| laplacian.starts[row as usize + 1] - laplacian.starts[row as usize];
    let mut order: Vec<u32> = (0..laplacian.mass.len() as u32).collect();
    // Stable: rows of the same length keep their order.
    order.chunks_mut(SORTED).for_each(|rows| rows.sort_by_key(|row| std::cmp::Reverse(length(*row))));
    order
}

impl Slices {
    /// The `rows` in slices. The last slice is padded with empty rows.
    #[must_use]
    pub fn new(rows: &SparseRows) -> Self {
        let mut slices = Self { starts: vec![0], columns: Vec::new() };
        for first in (0..rows.count()).step_by(ROWS) {
            let entries =
                |lane: usize| if first + lane < rows.count() { rows.row(first + lane) } else { 0..0 };
            let width = (0..ROWS).map(|lane| entries(lane).len()).max().unwrap_or(0);
            for k in 0..width {
                let at = std::array::from_fn(|lane| entries(lane).nth(k));
                slices.columns.push(Column {
                    weights: at.map(|at: Option<usize>| at.map_or(0.0, |at| rows.weights[at])),
                    at: std::array::from_fn(|lane| {
                        at[lane].map_or((first + lane) as u32, |at| rows.columns[at])
                    }),
                });
            }
            slices.starts.push(slices.columns.len() as u32);
        }
        slices
    }

    /// The columns of a slice.
    #[must_use]
    #[inline(always)]
    pub fn of(&self, slice: usize) -> &[Column] {
        &self.columns[self.starts[slice] as usize..self.starts[slice + 1] as usize]
    }
}
