//! The Laplacians that chemicals spread by, as rows and as slices.

use super::slices::{Slices, order};
use super::sparse_rows::SparseRows;
use crate::surface::Laplacian;

/// The Laplacians of one system on one surface, for given stretches and directions. Growths with other rates and ratios can use
/// them, too.
#[derive(Clone, Debug)]
pub struct Operators {
    /// The vertex of each row (`order[row] = vertex`).
    pub(in crate::rd) order: Vec<u32>,
    /// The rows of each tensor, then those of isotropic diffusion if the system needs it.
    pub(in crate::rd) rows: Vec<SparseRows>,
    /// The rows of each operator in slices.
    pub(in crate::rd) slices: Vec<Slices>,
}

impl Operators {
    /// Operators of given Laplacians, each with a factor for each row, and the area of a mean cell.
    ///
    /// # Panics
    /// If their numbers of rows or of factors differ.
    #[must_use]
    pub fn of(laplacians: &[(Laplacian, Vec<f64>)], cell: f64) -> Self {
        let order = laplacians.first().map_or_else(Vec::new, |(laplacian, _)| order(laplacian));
        let rows: Vec<SparseRows> = laplacians
            .iter()
            .map(|(laplacian, factors)| SparseRows::new(laplacian, &order, cell, |row| factors[row]))
            .collect();
        Self { slices: rows.iter().map(Slices::new).collect(), rows, order }
    }

    /// Values by vertex, in the order of the rows; `None` for another number of them.
    #[must_use]
    pub fn by_row(&self, values: &[f32]) -> Option<Vec<f32>> {
        let fits = values.len() == self.order.len();
        fits.then(|| self.order.iter().map(|vertex| values[*vertex as usize]).collect())
    }

    /// Values in the order of the rows, by vertex.
    #[must_use]
    pub fn by_vertex(&self, rows: &[f32]) -> Vec<f32> {
        let mut values = vec![0.0; rows.len()];
        for (vertex, value) in self.order.iter().zip(rows) {
            values[*vertex as usize] = *value;
        }
        values
    }

    /// Number of vertices.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.order.len()
    }
}
