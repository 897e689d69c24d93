//! The Laplacian as rows of numbers for 32 bits: weight ÷ mass, in units of mean cells.

use std::ops::Range;

use crate::surface::Laplacian;

/// A sparse matrix without its diagonal, row by row: L u = Σⱼ wᵢⱼ (uⱼ − uᵢ).
#[derive(Clone, Debug)]
pub struct SparseRows {
    /// Start of each row, and the end of the last.
    pub starts: Vec<u32>,
    /// By entry, the column.
    pub columns: Vec<u32>,
    /// By entry, the weight.
    pub weights: Vec<f32>,
}

impl SparseRows {
    /// The rows of `laplacian` in an order (`order[new] = old`), with the area of a mean cell as the unit; each row is multiplied
    /// by its `factor`.
    #[must_use]
    pub fn new(laplacian: &Laplacian, order: &[u32], unit: f64, factor: impl Fn(usize) -> f64) -> Self {
        let mut places = vec![0; order.len()];
        order.iter().enumerate().for_each(|(new, old)| places[*old as usize] = new as u32);
        let entries = laplacian.columns.len();
        let mut rows = Self {
            starts: vec![0],
            columns: Vec::with_capacity(entries),
            weights: Vec::with_capacity(entries),
        };
        for old in order {
            let old = *old as usize;
            let scale = factor(old) * unit / laplacian.mass[old];
            for entry in laplacian.starts[old] as usize..laplacian.starts[old + 1] as usize {
                rows.columns.push(places[laplacian.columns[entry] as usize]);
                rows.weights.push((scale * laplacian.weights[entry]) as f32);
            }
            rows.starts.push(rows.columns.len() as u32);
        }
        rows
    }

    /// The entries of a row.
    #[must_use]
    pub fn row(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// Number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The sum of the weights of a row.
    #[must_use]
    pub fn sum(&self, row: usize) -> f32 {
        self.weights[self.row(row)].iter().sum()
    }
}
