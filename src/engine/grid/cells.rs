//! A regular grid of cells over the canvas.

use std::ops::Range;

use super::domain::Domain;
use super::edges::{Bounds, Edges};

/// A regular grid of cells that covers the canvas exactly.
///
/// Cells are numbered row by row: the cell at [column, row] has the index row · columns + column. Places on the grid are
/// in cells, x to the right and y down: the cell at [column, row] has its centre at [column + ½, row + ½].
/// [`Self::to_px`] and [`Self::to_cells`] convert them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Cells along x and y, at least 1 each.
    pub size: [usize; 2],
    /// px a cell along x and y; nearly but not always equal, so that whole cells cover the canvas.
    pub cell: [f64; 2],
    /// What lies beyond the border.
    pub edges: Edges,
}

impl Grid {
    /// A grid of square cells of one px.
    ///
    /// ```
    /// use dapple_engine::grid::{Edges, Grid};
    ///
    /// let grid = Grid::unit([8, 4], Edges::Closed);
    /// assert_eq!((grid.index([3, 2]), grid.position(19)), (19, [3, 2]));
    /// ```
    #[must_use]
    pub fn unit(size: [usize; 2], edges: Edges) -> Self {
        Self { size, cell: [1.0; 2], edges }
    }

    /// The grid with another number of cells over the same canvas.
    #[must_use]
    pub fn resized(&self, size: [usize; 2]) -> Self {
        let cell = |axis: usize| self.cell[axis] * (self.size[axis] as f64 / size[axis] as f64);
        Self { size, cell: [cell(0), cell(1)], edges: self.edges }
    }

    /// The index of the cell at [column, row].
    #[must_use]
    pub fn index(&self, [column, row]: [usize; 2]) -> usize {
        row * self.size[0] + column
    }

    /// [column, row] of a cell.
    #[must_use]
    pub fn position(&self, cell: usize) -> [usize; 2] {
        [cell % self.size[0], cell / self.size[0]]
    }

    /// Sides of the grid, cells, with its edges.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds { size: self.size.map(|n| n as f64), edges: self.edges }
    }

    /// The canvas, px, with its edges.
    #[must_use]
    pub fn bounds_px(&self) -> Bounds {
        Bounds { size: self.to_px(self.bounds().size), edges: self.edges }
    }

    /// Where a place on the grid lies on the canvas, px.
    #[must_use]
    pub fn to_px(&self, place: [f64; 2]) -> [f64; 2] {
        [place[0] * self.cell[0], place[1] * self.cell[1]]
    }

    /// Where a point of the canvas, px, lies on the grid.
    ///
    /// ```
    /// use dapple_engine::grid::{Edges, Grid};
    ///
    /// let grid = Grid { size: [50, 30], cell: [2.0, 2.0], edges: Edges::Wrap };
    /// assert_eq!(grid.to_cells([30.0, 10.0]), [15.0, 5.0]);
    /// assert_eq!(grid.to_px([15.0, 5.0]), [30.0, 10.0]);
    /// ```
    #[must_use]
    pub fn to_cells(&self, point: [f64; 2]) -> [f64; 2] {
        [point[0] / self.cell[0], point[1] / self.cell[1]]
    }

    /// The centre of a cell, px.
    #[must_use]
    pub fn center_px(&self, cell: usize) -> [f64; 2] {
        self.to_px(self.center(cell))
    }

    /// Side of a square of a cell's area, px.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        (self.cell[0] * self.cell[1]).sqrt()
    }

    /// The cell some columns and rows away, and how many whole canvases away that is; `None` beyond closed edges.
    #[must_use]
    pub fn step(&self, cell: usize, [columns, rows]: [i32; 2]) -> Option<(usize, [i32; 2])> {
        let [nx, ny] = self.size.map(|n| n as i32);
        let (x, y) = (cell as i32 % nx + columns, cell as i32 / nx + rows);
        // Most are inside, and need no further division.
        if (0..nx).contains(&x) && (0..ny).contains(&y) {
            return Some(((y * nx + x) as usize, [0, 0]));
        }
        let beyond = [x.div_euclid(nx), y.div_euclid(ny)];
        if self.edges == Edges::Closed && beyond != [0, 0] {
            return None;
        }
        Some(((y.rem_euclid(ny) * nx + x.rem_euclid(nx)) as usize, beyond))
    }

    /// Cells of the range `among` whose centres lie in the rectangle from `low` to `high`, by rows and columns, each with
    /// its centre. On a wrapped grid the rectangle may reach across the border; centres are given as they lie in it.
    pub fn within(
        &self,
        [low, high]: [[f64; 2]; 2],
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> + use<> {
        self.window(low.map(|at| at - 0.5), high.map(|at| at - 0.5), among)
    }

    /// The cells of [`Self::within`] for corners given in columns and rows, half a cell nearer to the origin: from `low` to
    /// `high`.
    pub(super) fn window(
        &self,
        low: [f64; 2],
        high: [f64; 2],
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> + use<> {
        let ([nx, ny], edges) = (self.size, self.edges);
        let [columns, rows] = [0, 1].map(|axis| {
            let span = low[axis].ceil() as isize..(high[axis].floor() as isize).saturating_add(1);
            match edges {
                Edges::Wrap => span,
                Edges::Closed => span.start.max(0)..span.end.min(self.size[axis] as isize),
            }
        });
        rows.flat_map(move |row| {
            let start = edges.index(row, ny) * nx;
            let columns = if start < among.end && among.start < start + nx { columns.clone() } else { 0..0 };
            let among = among.clone();
            let cells = columns.map(move |column| {
                // Most are inside, and need no division.
                let inside = (0..nx as isize).contains(&column);
                let x = if inside { column as usize } else { edges.index(column, nx) };
                (start + x, [column as f64 + 0.5, row as f64 + 0.5])
            });
            cells.filter(move |(cell, _)| among.contains(cell))
        })
    }

    /// The cells of [`Self::window`] as runs along the rows, each with the centre of its first cell.
    pub(super) fn window_runs(
        &self,
        low: [f64; 2],
        high: [f64; 2],
        among: Range<usize>,
    ) -> impl Iterator<Item = (Range<usize>, [f64; 2])> + use<> {
        let ([nx, ny], edges) = (self.size.map(|n| n as isize), self.edges);
        let [columns, rows] = [0, 1].map(|axis| {
            let span = low[axis].ceil() as isize..(high[axis].floor() as isize).saturating_add(1);
            match edges {
                Edges::Wrap => span,
                Edges::Closed => span.start.max(0)..span.end.min(self.size[axis] as isize),
            }
        });
        rows.flat_map(move |row| {
            // The images of the row's cells, a canvas apart from each other.
            let first = columns.start.div_euclid(nx);
            let images =
                if columns.is_empty() { first..first } else { first..(columns.end - 1).div_euclid(nx) + 1 };
            let start = row.rem_euclid(ny) * nx;
            let (columns, among) = (columns.clone(), among.clone());
            images.filter_map(move |image| {
                let shift = start - image * nx;
                let from = columns.start.max(image * nx).max(among.start as isize - shift);
                let to = columns.end.min((image + 1) * nx).min(among.end as isize - shift);
                let center = [from as f64 + 0.5, row as f64 + 0.5];
                (from < to).then(|| ((from + shift) as usize..(to + shift) as usize, center))
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_edges_end_the_grid_and_wrapped_ones_lead_round() {
        let grid = Grid::unit([3, 2], Edges::Closed);
        assert_eq!(grid.step(2, [1, 0]), None);
        assert_eq!(grid.step(2, [-1, 1]), Some((4, [0, 0])));
        assert_eq!(grid.neighbours(0).collect::<Vec<_>>(), [1, 3, 4]);
        let grid = Grid { edges: Edges::Wrap, ..grid };
        assert_eq!(grid.step(2, [1, -1]), Some((3, [1, -1])));
        assert_eq!(grid.displacement([0.5, 0.5], [2.5, 0.5]), [-1.0, 0.0]);
    }

    #[test]
    fn a_cell_s_centre_lies_in_that_cell() {
        let grid = Grid { size: [5, 4], cell: [2.0, 3.0], edges: Edges::Closed };
        for cell in 0..grid.cells() {
            assert_eq!(grid.cell_at(grid.center(cell)), cell);
            assert_eq!(grid.index(grid.position(cell)), cell);
            assert_eq!(grid.to_cells(grid.center_px(cell)), grid.center(cell));
        }
        assert_eq!((grid.cell_at([-1.0, 9.0]), grid.cell_at([9.0, -1.0])), (15, 4));
        assert_eq!(grid.resized([10, 2]).cell, [1.0, 6.0]);
    }

    /// A cell and the displacement to it.
    type Seen = (usize, [f64; 2]);

    /// The cells within `reach`, found by asking all cells, and on a tile all their images nearby.
    fn slow(grid: &Grid, place: [f64; 2], reach: f64) -> Vec<Seen> {
        let images: &[f64] = if grid.edges == Edges::Wrap { &[-2.0, -1.0, 0.0, 1.0, 2.0] } else { &[0.0] };
        let mut found = Vec::new();
        for cell in 0..grid.cells() {
            let [x, y] = grid.center(cell);
            for down in images {
                for across in images {
                    let at = [x + across * grid.size[0] as f64, y + down * grid.size[1] as f64];
                    let displacement = [at[0] - place[0], at[1] - place[1]];
                    if displacement.iter().all(|displacement| displacement.abs() <= reach) {
                        found.push((cell, displacement));
                    }
                }
            }
        }
        found
    }

    #[test]
    fn cells_near_a_place_equal_those_of_a_full_search() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let grid = Grid::unit([7, 5], edges);
            for (place, reach) in
                [([0.25, 4.75], 1.5), ([3.5, 2.5], 2.0), ([6.9, 0.1], 6.0), ([3.0, 3.0], 0.1)]
            {
                let sorted = |mut cells: Vec<Seen>| {
                    cells.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
                    cells
                };
                let all = sorted(grid.near(place, reach, 0..35).collect());
                let expected = sorted(slow(&grid, place, reach));
                let near = |(a, b): (&Seen, &Seen)| {
                    a.0 == b.0 && (0..2).all(|axis| (a.1[axis] - b.1[axis]).abs() < 1e-12)
                };
                assert!(
                    all.len() == expected.len() && all.iter().zip(&expected).all(near),
                    "{edges:?} {place:?}"
                );
                let run = |(cells, [x, y]): (Range<usize>, [f64; 2])| {
                    let first = cells.start;
                    cells.map(move |cell| (cell, [x + (cell - first) as f64, y]))
                };
                let runs = sorted(grid.runs_near(place, reach, 0..35).flat_map(run).collect());
                assert!(runs.len() == all.len() && runs.iter().zip(&all).all(near), "{edges:?} {place:?}");
                let some: Vec<Seen> = grid.runs_near(place, reach, 7..16).flat_map(run).collect();
                assert_eq!(some.len(), grid.near(place, reach, 7..16).count());
                // Ranges of cells, whole rows or not, have each their own part.
                let parts =
                    [0..7, 7..16, 16..35].map(|part| grid.near(place, reach, part).collect::<Vec<_>>());
                assert_eq!(sorted(parts.concat()), all);
            }
        }
    }

    #[test]
    fn dilation_goes_across_the_border_of_a_tile_only() {
        let mut set = vec![false; 15];
        set[5] = true;
        let seen = |edges| {
            let grid = Grid::unit([5, 3], edges).dilated(&set, |_| 1.0);
            grid.iter().enumerate().filter(|(_, set)| **set).map(|(cell, _)| cell).collect::<Vec<_>>()
        };
        assert_eq!(seen(Edges::Closed), [0, 5, 6, 10]);
        assert_eq!(seen(Edges::Wrap), [0, 5, 6, 9, 10]);
    }
}
