//! The nodes around each cell of a grid, and values between them: found once for every column and row, not for every cell.

use crate::attributes::regions::RegionGrid;
use crate::grid::Grid;

/// Two nodes along an axis, and the share of the second.
pub type Between = (usize, usize, f64);

/// The nodes of a layout between which the cells of a grid lie.
pub struct CellCorners {
    /// Positions between corners, by column of the grid.
    across: Vec<Between>,
    /// Positions between corners, by row of the grid.
    down: Vec<Between>,
    /// Nodes in a row of the layout.
    columns: usize,
}

impl CellCorners {
    /// The nodes of `layout` around the cells of `grid`, which covers the same canvas.
    #[must_use]
    pub fn new(layout: &RegionGrid, grid: &Grid) -> Self {
        let along = |axis: usize| {
            let between = |i: usize| layout.between(axis, (i as f64 + 0.5) * grid.cell[axis]);
            (0..grid.size[axis]).map(between).collect::<Vec<_>>()
        };
        Self { across: along(0), down: along(1), columns: layout.grid[0] }
    }

    /// The two rows of nodes between which row `y` of the grid lies, each by the index of its first node, and the share of the second.
    #[must_use]
    pub fn rows(&self, y: usize) -> Between {
        let (upper, lower, share) = self.down[y];
        (upper * self.columns, lower * self.columns, share)
    }

    /// Nodes in a row of them.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// For each column of the grid, the two columns of nodes between which it lies, and the share of the second.
    #[must_use]
    pub fn across(&self) -> &[Between] {
        &self.across
    }
}

/// Values of the regions of a layout, between the cells of a grid.
pub struct CellValues<'a> {
    corners: CellCorners,
    values: &'a [f64],
    /// The value of all regions, if it is constant.
    even: Option<f64>,
}

impl<'a> CellValues<'a> {
    /// The `values` by region of `layout`, for the cells of `grid`.
    #[must_use]
    pub fn new(layout: &RegionGrid, grid: &Grid, values: &'a [f64]) -> Self {
        let even = values.iter().all(|one| *one == values[0]).then(|| values[0]);
        Self { corners: CellCorners::new(layout, grid), values, even }
    }

    /// Values interpolated along row `y` of the grid, by column.
    pub fn row(&self, y: usize) -> impl Fn(usize) -> f64 {
        let (upper, lower, share) = self.corners.rows(y);
        let columns = if self.even.is_some() { 0 } else { self.corners.columns };
        let between = |k: usize| (1.0 - share) * self.values[upper + k] + share * self.values[lower + k];
        let between: Vec<f64> = (0..columns).map(between).collect();
        move |x| {
            self.even.unwrap_or_else(|| {
                let (left, right, share) = self.corners.across[x];
                (1.0 - share) * between[left] + share * between[right]
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn values_of_a_row_are_those_between_the_corners_of_each_cell() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let layout = RegionGrid { size: [70.0, 30.0], grid: [5, 3], edges };
            let grid = Grid { size: [31, 17], cell: [70.0 / 31.0, 30.0 / 17.0], edges };
            for values in [(0..15).map(|k| f64::from(k * k)).collect(), vec![3.0; 15]] {
                let rows = CellValues::new(&layout, &grid, &values);
                for cell in 0..31 * 17 {
                    let corners = layout.corners(grid.center_px(cell));
                    let single: f64 = corners.iter().map(|(i, weight)| weight * values[*i]).sum();
                    assert!((rows.row(cell / 31)(cell % 31) - single).abs() < 1e-12, "{edges:?} {cell}");
                }
            }
        }
    }
}
