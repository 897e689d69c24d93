//! Connected marks on a tile: which mark a cell belongs to, and which of its copies.

use crate::grid::Grid;

/// Half of the eight neighbours of a cell; of the others it is a neighbour.
const NEIGHBOURS: [[i32; 2]; 4] = [[1, 0], [-1, 1], [0, 1], [1, 1]];

/// Connected cells: union–find that also counts how many canvases apart two cells were joined.
#[derive(Clone, Debug)]
pub struct Copies {
    parent: Vec<u32>,
    /// Canvases to add to a cell's place to get its parent's frame.
    shift: Vec<[i32; 2]>,
    endless: Vec<bool>,
}

impl Copies {
    /// Connects the cells that are `set`.
    #[must_use]
    pub fn connect(set: &[bool], grid: &Grid) -> Self {
        let n = set.len();
        let mut copies =
            Self { parent: (0..n as u32).collect(), shift: vec![[0; 2]; n], endless: vec![false; n] };
        for cell in (0..n).filter(|cell| set[*cell]) {
            for (other, beyond) in NEIGHBOURS.iter().filter_map(|offset| grid.step(cell, *offset)) {
                if set[other] {
                    copies.join(cell, other, beyond);
                }
            }
        }
        copies
    }

    /// The root of the cells that `cell` is connected to, and the canvases to add to come to its frame.
    #[must_use]
    pub fn find(&self, cell: usize) -> (usize, [i32; 2]) {
        let (mut at, mut total) = (cell, [0, 0]);
        while self.parent[at] as usize != at {
            total = sum(total, self.shift[at]);
            at = self.parent[at] as usize;
        }
        (at, total)
    }

    /// Joins `a` and `b`, where `b` lies `apart` canvases away from its own place.
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
        // Shorten both paths.
        for (cell, root, found) in [(a, ra, sa), (b, rb, sb)] {
            if cell != root {
                self.parent[cell] = root as u32;
                self.shift[cell] = found;
            }
        }
    }

    /// The mark of the cell that lies `canvases` away: different for different marks, and for copies of one.
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
    use crate::grid::Edges;

    fn cells(picture: &[&str]) -> (Vec<bool>, Grid) {
        let size = [picture[0].len(), picture.len()];
        let set = picture.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        (set, Grid { size, cell: [1.0; 2], edges: Edges::Wrap })
    }

    #[test]
    fn a_mark_across_the_border_is_one_and_its_copies_are_others() {
        let (set, grid) = cells(&["#...#", ".....", "..#..", "....."]);
        let copies = Copies::connect(&set, &grid);
        // Seen from the right end, the left end of the same mark is one canvas to the right.
        assert_eq!(copies.identity(4, [0, 0]), copies.identity(0, [1, 0]));
        assert_ne!(copies.identity(4, [0, 0]), copies.identity(0, [0, 0]));
        assert_ne!(copies.find(12).0, copies.find(0).0);
    }

    #[test]
    fn a_stripe_round_the_tile_is_its_own_copy() {
        let (set, grid) = cells(&[".....", "#####", "....."]);
        let copies = Copies::connect(&set, &grid);
        assert_eq!(copies.identity(7, [0, 0]), copies.identity(5, [1, 0]));
    }
}
