//! Connected marks on a tile: which mark a cell belongs to, and which of its copies.

use crate::grid::{Grid, UnionFind};

/// Half of the eight neighbours of a cell; the cell is in turn a neighbour of the other half.
const NEIGHBOURS: [[i32; 2]; 4] = [[1, 0], [-1, 1], [0, 1], [1, 1]];

/// Connected cells: union–find that also counts the number of canvases between two joined cells.
#[derive(Clone, Debug)]
pub struct Copies(UnionFind);

impl Copies {
    /// Connects the cells that are `set`.
    #[must_use]
    pub fn connect(set: &[bool], grid: &Grid) -> Self {
        let mut copies = Self(UnionFind::new(set.len()));
        for cell in (0..set.len()).filter(|cell| set[*cell]) {
            for (other, beyond) in NEIGHBOURS.iter().filter_map(|offset| grid.step(cell, *offset)) {
                if set[other] {
                    copies.join(cell, other, beyond);
                }
            }
        }
        copies
    }

    /// The root of the cells that `cell` is connected to, and the number of canvases to its frame.
    #[must_use]
    pub fn find(&self, cell: usize) -> (usize, [i32; 2]) {
        let (root, shift) = self.0.root(cell as u32);
        (root as usize, shift)
    }

    /// Joins `a` and `b`, where `b` lies `apart` canvases away from its own place.
    pub fn join(&mut self, a: usize, b: usize, apart: [i32; 2]) {
        self.0.join(a as u32, b as u32, apart);
    }

    /// The identity of the mark of a cell that lies `canvases` away: it differs between marks, and between copies of one mark.
    #[must_use]
    pub fn identity(&self, cell: usize, canvases: [i32; 2]) -> (usize, [i32; 2]) {
        let (root, shift) = self.find(cell);
        let endless = self.0.is_endless(root as u32);
        (root, if endless { [0, 0] } else { [canvases[0] - shift[0], canvases[1] - shift[1]] })
    }
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
    fn a_mark_across_the_border_is_one_mark_with_separate_copies() {
        let (set, grid) = cells(&["#...#", ".....", "..#..", "....."]);
        let copies = Copies::connect(&set, &grid);
        // Seen from the right end, the left end of the mark is one canvas to the right.
        assert_eq!(copies.identity(4, [0, 0]), copies.identity(0, [1, 0]));
        assert_ne!(copies.identity(4, [0, 0]), copies.identity(0, [0, 0]));
        assert_ne!(copies.find(12).0, copies.find(0).0);
    }

    #[test]
    fn a_stripe_that_crosses_the_whole_tile_is_its_own_copy() {
        let (set, grid) = cells(&[".....", "#####", "....."]);
        let copies = Copies::connect(&set, &grid);
        assert_eq!(copies.identity(7, [0, 0]), copies.identity(5, [1, 0]));
    }
}
