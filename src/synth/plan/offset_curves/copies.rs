//! Which mark a cell belongs to, or lies nearest to; on a tile also which of its copies.

use crate::grid::Edges;

/// A grid of cells over a canvas.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// Cells along x and y.
    pub size: [usize; 2],
    /// px a cell along x and y.
    pub cell: [f64; 2],
    /// What lies beyond the border.
    pub edges: Edges,
}

impl Grid {
    /// The cell some columns and rows away, and how many whole canvases away that is; `None` beyond closed edges.
    #[must_use]
    pub fn away(&self, cell: usize, [columns, rows]: [i32; 2]) -> Option<(usize, [i32; 2])> {
        let [nx, ny] = self.size.map(|n| n as i32);
        let (x, y) = (cell as i32 % nx + columns, cell as i32 / nx + rows);
        let beyond = [x.div_euclid(nx), y.div_euclid(ny)];
        if self.edges == Edges::Closed && beyond != [0, 0] {
            return None;
        }
        Some(((y.rem_euclid(ny) * nx + x.rem_euclid(nx)) as usize, beyond))
    }

    /// Cells in all.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The middle of a cell, px.
    #[must_use]
    pub fn middle(&self, cell: usize) -> [f64; 2] {
        let [x, y] = [cell % self.size[0], cell / self.size[0]];
        [(x as f64 + 0.5) * self.cell[0], (y as f64 + 0.5) * self.cell[1]]
    }

    /// px a cell, where cells are as good as square.
    #[must_use]
    pub fn px(&self) -> f64 {
        (self.cell[0] * self.cell[1]).sqrt()
    }
}

/// Half of the eight neighbours of a cell; the others have it as theirs.
const NEIGHBOURS: [[i32; 2]; 4] = [[1, 0], [-1, 1], [0, 1], [1, 1]];

/// Cells that hang together: union–find that also knows how many canvases apart they were seen.
#[derive(Clone, Debug)]
pub struct Copies {
    parent: Vec<u32>,
    /// Canvases to add to a cell's place to get its parent's frame.
    shift: Vec<[i32; 2]>,
    endless: Vec<bool>,
}

impl Copies {
    /// Those of the cells that are `set`.
    #[must_use]
    pub fn of(set: &[bool], grid: &Grid) -> Self {
        let n = set.len();
        let mut copies =
            Self { parent: (0..n as u32).collect(), shift: vec![[0; 2]; n], endless: vec![false; n] };
        for cell in (0..n).filter(|cell| set[*cell]) {
            for (other, beyond) in NEIGHBOURS.iter().filter_map(|offset| grid.away(cell, *offset)) {
                if set[other] {
                    copies.join(cell, other, beyond);
                }
            }
        }
        copies
    }

    /// The cell that stands for all that `cell` hangs together with, and the canvases to add to go to its frame.
    #[must_use]
    pub fn find(&self, cell: usize) -> (usize, [i32; 2]) {
        let (mut at, mut total) = (cell, [0, 0]);
        while self.parent[at] as usize != at {
            total = sum(total, self.shift[at]);
            at = self.parent[at] as usize;
        }
        (at, total)
    }

    /// `a` and `b` are one: `b` is seen `apart` canvases away from where it is.
    pub fn join(&mut self, a: usize, b: usize, apart: [i32; 2]) {
        let ((ra, sa), (rb, sb)) = (self.find(a), self.find(b));
        // A place p of b is p + sb in its root's frame, and p + apart + sa in that of a's root.
        let shift = difference(sum(apart, sa), sb);
        if ra == rb {
            self.endless[ra] |= shift != [0, 0];
            return;
        }
        let (low, high) = (ra.min(rb), ra.max(rb));
        self.parent[high] = low as u32;
        self.shift[high] = if high == rb { shift } else { difference([0, 0], shift) };
        self.endless[low] |= self.endless[high];
        // Both are on the way up from now on: keep it short.
        for (cell, root, found) in [(a, ra, sa), (b, rb, sb)] {
            if cell != root {
                self.parent[cell] = root as u32;
                self.shift[cell] = found;
            }
        }
    }

    /// What the cell `canvases` away belongs to, so that no two different marks, or copies of one, have the same.
    #[must_use]
    pub fn identity(&self, cell: usize, canvases: [i32; 2]) -> (usize, [i32; 2]) {
        let (root, shift) = self.find(cell);
        (root, if self.endless[root] { [0, 0] } else { difference(canvases, shift) })
    }
}

fn sum(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn difference(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(picture: &[&str]) -> (Vec<bool>, Grid) {
        let size = [picture[0].len(), picture.len()];
        let set = picture.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        (set, Grid { size, cell: [1.0; 2], edges: Edges::Wrap })
    }

    #[test]
    fn a_mark_across_the_border_is_one_and_its_copies_are_others() {
        let (set, grid) = cells(&["#...#", ".....", "..#..", "....."]);
        let copies = Copies::of(&set, &grid);
        // Seen from the right end, the left end of the same mark is one canvas to the right.
        assert_eq!(copies.identity(4, [0, 0]), copies.identity(0, [1, 0]));
        assert_ne!(copies.identity(4, [0, 0]), copies.identity(0, [0, 0]));
        assert_ne!(copies.find(12).0, copies.find(0).0);
    }

    #[test]
    fn a_stripe_round_the_tile_is_its_own_copy() {
        let (set, grid) = cells(&[".....", "#####", "....."]);
        let copies = Copies::of(&set, &grid);
        assert_eq!(copies.identity(7, [0, 0]), copies.identity(5, [1, 0]));
    }

    #[test]
    fn closed_edges_end_the_grid() {
        let grid = Grid { size: [3, 2], cell: [1.0; 2], edges: Edges::Closed };
        assert_eq!(grid.away(2, [1, 0]), None);
        assert_eq!(grid.away(2, [-1, 1]), Some((4, [0, 0])));
        let grid = Grid { edges: Edges::Wrap, ..grid };
        assert_eq!(grid.away(2, [1, -1]), Some((3, [1, -1])));
    }
}
