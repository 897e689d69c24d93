//! The sheets of a surface in a cell of a lattice (Nielson 2004): if two pass through one cell, they must not share a vertex.

/// No sheet.
const NONE: u8 = u8::MAX;

/// The sheets of a surface in a cell.
pub struct Sheets {
    /// By edge: the number of the sheet that crosses it, or [`NONE`].
    pub of_edge: [u8; 12],
    /// Number of sheets.
    pub count: u8,
}

/// The number of the edge of a cell that leaves a corner along an axis; the corner has bits for x, y and z.
pub fn edge(axis: usize, corner: usize) -> usize {
    4 * axis + (corner >> ((axis + 1) % 3) & 1) + 2 * (corner >> ((axis + 2) % 3) & 1)
}

/// The edges of a cell: axis and lower corner.
pub fn edges() -> impl Iterator<Item = (usize, usize)> {
    (0..3).flat_map(|axis| {
        (0..8).filter(move |corner| corner >> axis & 1 == 0).map(move |corner| (axis, corner))
    })
}

impl Sheets {
    /// The sheets of a cell whose corners are `inside` or not. Two edges are crossed by one sheet if a line on a side of the cell
    /// joins them. If all four edges of a side are crossed, the lines go around the corners that are inside, in both cells that
    /// share the side.
    pub fn new(inside: [bool; 8]) -> Self {
        let mut sheets = Self { of_edge: [NONE; 12], count: 0 };
        let is_crossed = |(axis, corner): (usize, usize)| inside[corner] != inside[corner | 1 << axis];
        for (axis, corner) in edges().filter(|edge| is_crossed(*edge)) {
            sheets.of_edge[edge(axis, corner)] = edge(axis, corner) as u8;
        }
        if sheets.of_edge == [NONE; 12] {
            return sheets;
        }
        for (normal, side) in (0..3).flat_map(|normal| [(normal, 0), (normal, 1 << normal)]) {
            let [u, v] = [(normal + 1) % 3, (normal + 2) % 3];
            let around = [(u, side), (v, side), (u, side | 1 << v), (v, side | 1 << u)];
            let crossed: Vec<usize> = around
                .into_iter()
                .filter(|edge| is_crossed(*edge))
                .map(|(axis, corner)| edge(axis, corner))
                .collect();
            match crossed[..] {
                [a, b] => sheets.unite(a, b),
                [_, _, _, _] => {
                    let corners = [side, side | 1 << u, side | 1 << v, side | 1 << u | 1 << v];
                    for corner in corners.into_iter().filter(|corner| inside[*corner]) {
                        sheets.unite(edge(u, corner & !(1 << u)), edge(v, corner & !(1 << v)));
                    }
                }
                _ => {}
            }
        }
        sheets.number();
        sheets
    }

    fn unite(&mut self, a: usize, b: usize) {
        let [from, to] = [self.of_edge[a], self.of_edge[b]];
        self.of_edge.iter_mut().filter(|sheet| **sheet == from).for_each(|sheet| *sheet = to);
    }

    /// Numbers from 0 in the order of the edges.
    fn number(&mut self) {
        let before = self.of_edge;
        for at in (0..12).filter(|at| before[*at] != NONE) {
            let first = before.iter().position(|sheet| *sheet == before[at]).unwrap_or(at);
            if first == at {
                self.of_edge[at] = self.count;
                self.count += 1;
            } else {
                self.of_edge[at] = self.of_edge[first];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of sheets for the corners that are inside.
    fn count(corners: &[usize]) -> u8 {
        let mut inside = [false; 8];
        corners.iter().for_each(|corner| inside[*corner] = true);
        Sheets::new(inside).count
    }

    #[test]
    fn a_sheet_goes_around_each_group_of_corners_that_share_edges() {
        assert_eq!([count(&[]), count(&[0, 1, 2, 3, 4, 5, 6, 7])], [0, 0]);
        assert_eq!(
            [count(&[5]), count(&[0, 1]), count(&[0, 1, 2, 3]), count(&[0, 1, 2, 3, 4, 5, 6])],
            [1; 4]
        );
        // Corners at opposite ends of the diagonal of a side, or of the cell.
        assert_eq!([count(&[0, 3]), count(&[0, 7]), count(&[0, 3, 5])], [2, 2, 3]);
        // Two corners outside are cut off by one sheet if the inside is connected between them on a side.
        assert_eq!([count(&[0, 3, 5, 6]), count(&[1, 2, 3, 4, 5, 6])], [4, 2]);
    }

    #[test]
    fn every_crossed_edge_belongs_to_a_sheet_and_no_other_does() {
        for corners in 0..256_usize {
            let inside = std::array::from_fn(|corner| corners >> corner & 1 == 1);
            let sheets = Sheets::new(inside);
            for (axis, corner) in edges() {
                let is_crossed = inside[corner] != inside[corner | 1 << axis];
                assert_eq!(sheets.of_edge[edge(axis, corner)] < sheets.count, is_crossed, "{corners:08b}");
            }
        }
    }
}
