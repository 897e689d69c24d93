//! One chemical on the grid, with a margin for stencils at the border.

use bytemuck::{Pod, Zeroable, cast_slice, cast_slice_mut};

use crate::grid::{Edges, Grid};

/// Cells that are stepped at once: one vector of AVX-512, two of AVX2, four of SSE or NEON.
pub const LANES: usize = 16;

/// [`LANES`] cells side by side, aligned so that a vector never lies across two cache lines.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Lanes(pub [f32; LANES]);

/// Columns of memory before the first cell of a row, and at least as many after the last: more than a stencil
/// reaches, so that cells stay aligned.
pub const MARGIN: usize = LANES;

/// Layout of the rows of a grid in memory: a margin of [`MARGIN`] columns, `nx` cells, a margin again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowLayout {
    /// Cells in a row.
    pub nx: usize,
    /// Rows.
    pub ny: usize,
    /// Continuation beyond the border.
    pub edges: Edges,
}

impl RowLayout {
    /// The layout of a grid's rows.
    #[must_use]
    pub fn new(grid: &Grid) -> Self {
        let [nx, ny] = grid.size;
        Self { nx, ny, edges: grid.edges }
    }

    /// Groups of [`LANES`] columns in a row of memory, margins included.
    ///
    /// The number is odd, so that one column of successive rows is not mapped to the same few lines of the cache.
    #[must_use]
    pub fn groups(&self) -> usize {
        (self.nx + 2 * MARGIN).div_ceil(LANES) | 1
    }

    /// The groups that hold cells.
    #[must_use]
    pub fn inner(&self) -> std::ops::Range<usize> {
        MARGIN / LANES..(MARGIN + self.nx).div_ceil(LANES)
    }

    /// Values from one row to the next.
    #[must_use]
    pub fn stride(&self) -> usize {
        self.groups() * LANES
    }

    /// The cell whose value stands at place `at` of a row of memory.
    #[must_use]
    pub fn column(&self, at: usize) -> usize {
        self.edges.index(at as isize - MARGIN as isize, self.nx)
    }

    /// The cells (`y · nx + x`) whose values stand in group `group` of row `y`.
    #[must_use]
    pub fn cells(&self, group: usize, y: usize) -> [usize; LANES] {
        let (first, row) = (group * LANES, y * self.nx);
        // Most groups hold no margin and need no division.
        if first >= MARGIN && first + LANES <= MARGIN + self.nx {
            return std::array::from_fn(|j| row + first + j - MARGIN);
        }
        std::array::from_fn(|j| row + self.column(first + j))
    }

    /// The row that stands in for row `y`, which may lie beyond the border.
    #[must_use]
    pub fn row(&self, y: isize) -> usize {
        // Most rows are inside and need no division.
        if (0..self.ny as isize).contains(&y) { y as usize } else { self.edges.index(y, self.ny) }
    }

    /// Writes the cells of one row of memory, and its margins.
    fn write_row(&self, cells: &[f32], row: &mut [f32]) {
        row[MARGIN..MARGIN + self.nx].copy_from_slice(cells);
        self.fill_margins(row);
    }

    /// Writes the margins of one row of memory from its cells, by the rule of the edges.
    pub fn fill_margins(&self, row: &mut [f32]) {
        let end = MARGIN + self.nx;
        if self.nx < MARGIN {
            for at in (0..MARGIN).chain(end..end + MARGIN) {
                row[at] = row[MARGIN + self.column(at)];
            }
        } else if self.edges == Edges::Wrap {
            row.copy_within(end - MARGIN..end, 0);
            row.copy_within(MARGIN..2 * MARGIN, end);
        } else {
            row.copy_within(MARGIN..2 * MARGIN, 0);
            row[..MARGIN].reverse();
            row.copy_within(end - MARGIN..end, end);
            row[end..end + MARGIN].reverse();
        }
    }
}

/// Concentrations of one chemical.
#[derive(Clone, Debug)]
pub struct Plane {
    grid: RowLayout,
    rows: Vec<Lanes>,
}

impl Plane {
    /// A plane of one concentration everywhere.
    #[must_use]
    pub fn flat(grid: RowLayout, value: f32) -> Self {
        Self { grid, rows: vec![Lanes([value; LANES]); grid.groups() * grid.ny] }
    }

    /// The given `nx · ny` cells; `None` for another number of them.
    #[must_use]
    pub fn from_cells(grid: RowLayout, cells: &[f32]) -> Option<Self> {
        if cells.len() != grid.nx * grid.ny {
            return None;
        }
        let mut row = vec![Lanes([0.0; LANES]); grid.groups()];
        let mut rows = Vec::with_capacity(grid.groups() * grid.ny);
        for cells in cells.chunks_exact(grid.nx) {
            grid.write_row(cells, cast_slice_mut(&mut row));
            rows.extend_from_slice(&row);
        }
        Some(Self { grid, rows })
    }

    /// Layout of its rows in memory.
    #[must_use]
    pub fn grid(&self) -> RowLayout {
        self.grid
    }

    /// The cells of row `y`.
    #[must_use]
    pub fn row(&self, y: usize) -> &[f32] {
        &self.memory(y)[MARGIN..MARGIN + self.grid.nx]
    }

    /// Row `y` with its margins.
    #[must_use]
    pub fn memory(&self, y: usize) -> &[f32] {
        let groups = self.grid.groups();
        cast_slice(&self.rows[y * groups..(y + 1) * groups])
    }

    /// All rows with their margins.
    pub fn memory_mut(&mut self) -> &mut [f32] {
        cast_slice_mut(&mut self.rows)
    }

    /// Writes the cells of row `y`, and its margins.
    pub fn set_row(&mut self, y: usize, cells: &[f32]) {
        let (grid, stride) = (self.grid, self.grid.stride());
        grid.write_row(cells, &mut self.memory_mut()[y * stride..(y + 1) * stride]);
    }

    /// Changes the cells of row `y`, and writes its margins.
    pub fn change_row(&mut self, y: usize, change: impl FnOnce(&mut [f32])) {
        let (grid, stride) = (self.grid, self.grid.stride());
        let row = &mut self.memory_mut()[y * stride..(y + 1) * stride];
        change(&mut row[MARGIN..MARGIN + grid.nx]);
        grid.fill_margins(row);
    }

    /// The cells, row by row.
    #[must_use]
    pub fn cells(&self) -> Vec<f32> {
        let mut cells = Vec::with_capacity(self.grid.nx * self.grid.ny);
        (0..self.grid.ny).for_each(|y| cells.extend_from_slice(self.row(y)));
        cells
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn margins_hold_the_values_beyond_the_border() {
        for (nx, edges) in
            [(3, Edges::Wrap), (3, Edges::Closed), (16, Edges::Wrap), (21, Edges::Wrap), (21, Edges::Closed)]
        {
            let grid = RowLayout { nx, ny: 1, edges };
            let cells: Vec<f32> = (0..nx).map(|x| x as f32).collect();
            let plane = Plane::from_cells(grid, &cells).expect("nx cells");
            for (at, value) in plane.memory(0).iter().enumerate().take(2 * MARGIN + nx) {
                let x = edges.index(at as isize - MARGIN as isize, nx);
                assert_eq!(*value, x as f32, "{edges:?} {nx} {at}");
            }
        }
    }
}
