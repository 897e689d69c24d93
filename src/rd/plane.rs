//! One chemical on the grid, with a margin so that a stencil may look beyond the border.

use super::selling::REACH;
use crate::field::Edges;

/// Concentrations of one chemical: `ny` rows of `nx` cells inside a margin of [`REACH`] cells.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Cells in a row, margin left out.
    pub nx: usize,
    /// Rows, margin left out.
    pub ny: usize,
    /// Margin included: `(ny + 2·REACH)` rows of `stride` values.
    pub values: Vec<f32>,
}

impl Plane {
    /// The same concentration everywhere.
    #[must_use]
    pub fn flat(nx: usize, ny: usize, value: f32) -> Self {
        Self { nx, ny, values: vec![value; (nx + 2 * REACH) * (ny + 2 * REACH)] }
    }

    /// The given `nx · ny` cells, margin filled as `edges` says; `None` for another number of them.
    #[must_use]
    pub fn from_cells(nx: usize, ny: usize, cells: &[f32], edges: Edges) -> Option<Self> {
        let mut plane = Self::flat(nx, ny, 0.0);
        if cells.len() != nx * ny {
            return None;
        }
        for (y, row) in cells.chunks_exact(nx).enumerate() {
            let start = plane.at(0, y);
            plane.values[start..start + nx].copy_from_slice(row);
        }
        plane.fill_margin(edges);
        Some(plane)
    }

    /// Values from one row to the next.
    #[must_use]
    pub fn stride(&self) -> usize {
        self.nx + 2 * REACH
    }

    /// Where the cell at column `x` of row `y` lies in `values`.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> usize {
        (y + REACH) * self.stride() + x + REACH
    }

    /// The cells of row `y`, margin left out.
    #[must_use]
    pub fn row(&self, y: usize) -> &[f32] {
        let start = self.at(0, y);
        &self.values[start..start + self.nx]
    }

    /// Writes the margin from the cells inside, as `edges` says.
    pub fn fill_margin(&mut self, edges: Edges) {
        for y in 0..self.ny {
            let start = (y + REACH) * self.stride();
            fill_row_margin(&mut self.values[start..start + self.nx + 2 * REACH], edges);
        }
        self.fill_margin_rows(edges);
    }

    /// Writes only the rows of the margin, where the columns of it are up to date.
    pub fn fill_margin_rows(&mut self, edges: Edges) {
        let (stride, reach) = (self.stride(), REACH as isize);
        for beyond in (-reach..0).chain(self.ny as isize..self.ny as isize + reach) {
            let from = (edges.index(beyond, self.ny) + REACH) * stride;
            let to = (beyond + reach) as usize * stride;
            self.values.copy_within(from..from + stride, to);
        }
    }

    /// The cells without the margin, row by row.
    #[must_use]
    pub fn cells(&self) -> Vec<f32> {
        (0..self.ny).flat_map(|y| self.row(y).iter().copied()).collect()
    }
}

/// Writes the margin of one row (margin included in `row`) from the cells inside it.
pub fn fill_row_margin(row: &mut [f32], edges: Edges) {
    let nx = row.len() - 2 * REACH;
    for i in 0..REACH {
        row[i] = row[REACH + edges.index(i as isize - REACH as isize, nx)];
        row[REACH + nx + i] = row[REACH + edges.index((nx + i) as isize, nx)];
    }
}
