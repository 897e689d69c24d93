//! The nodes around each cell of a grid: found once for every column and row, not for every cell.

use crate::attributes::regions::RegionGrid;
use crate::grid::Grid;

/// Two nodes along an axis, and the share of the second.
type Between = (usize, usize, f64);

/// The nodes of a layout between which the cells of a grid lie.
pub struct CellCorners {
    /// By column of the grid.
    across: Vec<Between>,
    /// By row of the grid.
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

    /// As [`RegionGrid::corners`] at the centre of a cell.
    #[inline]
    #[must_use]
    pub fn of(&self, cell: usize) -> [(usize, f64); 4] {
        let (left, right, fx) = self.across[cell % self.across.len()];
        let (upper, lower, fy) = self.down[cell / self.across.len()];
        let row = self.columns;
        [
            (upper * row + left, (1.0 - fx) * (1.0 - fy)),
            (upper * row + right, fx * (1.0 - fy)),
            (lower * row + left, (1.0 - fx) * fy),
            (lower * row + right, fx * fy),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn the_corners_of_a_cell_are_those_of_its_centre() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let layout = RegionGrid { size: [70.0, 30.0], grid: [5, 3], edges };
            let grid = Grid { size: [31, 17], cell: [70.0 / 31.0, 30.0 / 17.0], edges };
            let corners = CellCorners::new(&layout, &grid);
            for cell in 0..31 * 17 {
                assert_eq!(corners.of(cell), layout.corners(grid.center_px(cell)));
            }
        }
    }
}
