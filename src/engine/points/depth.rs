//! How deep places lie inside the edges of a pattern.

use crate::grid::distance::{length, nearest};
use crate::grid::{Field, Grid};

/// The edge of a mark.
const EDGE: f32 = 0.5;

/// The edges of a pattern, 0..1 with its edges at ½.
pub struct Edges<'a> {
    pattern: &'a Field,
    grid: Grid,
    inside: Vec<bool>,
    /// Columns and rows from each cell to the nearest one inside, and to the nearest one outside.
    to: [Vec<[i32; 2]>; 2],
}

impl<'a> Edges<'a> {
    /// The edges of `pattern`; `None` where it has none.
    #[must_use]
    pub fn new(pattern: &'a Field) -> Option<Self> {
        let grid = pattern.grid();
        let inside: Vec<bool> = pattern.values.iter().map(|value| *value >= EDGE).collect();
        let outside: Vec<bool> = inside.iter().map(|inside| !inside).collect();
        let to = [nearest(&inside, &grid)?, nearest(&outside, &grid)?];
        Some(Self { pattern, grid, inside, to })
    }

    /// Whether a cell lies inside a mark.
    #[must_use]
    pub fn is_inside(&self, cell: usize) -> bool {
        self.inside[cell]
    }

    /// The depth of a cell inside the edge, px, negative outside, and the nearest cell on the other side of the edge.
    #[must_use]
    pub fn depth(&self, cell: usize) -> Option<(f64, usize)> {
        let (to, side) = if self.inside[cell] { (&self.to[1], 1.0) } else { (&self.to[0], -1.0) };
        let (beside, _) = self.grid.step(cell, to[cell])?;
        // The edge lies between the two cells, where the pattern is ½.
        let away = length(to[cell], &self.grid);
        let depth = (away - self.beyond(beside)).max(0.0);
        // Next to the edge, the nearest cell on its other side may lie along it rather than across.
        let next = away < 1.5 * self.grid.px_a_cell();
        Some((side * if next { depth.min(self.beyond(cell)) } else { depth }, beside))
    }

    /// The distance of the edge from a cell that lies beside it, px.
    fn beyond(&self, cell: usize) -> f64 {
        let pattern = self.pattern;
        let [x, y] = [cell % pattern.width, cell / pattern.width].map(|k| k as isize);
        let slope = |before: f32, after: f32, px: f64| f64::from(after - before) / (2.0 * px);
        let across = slope(pattern.get(x - 1, y), pattern.get(x + 1, y), pattern.cell[0]);
        let down = slope(pattern.get(x, y - 1), pattern.get(x, y + 1), pattern.cell[1]);
        let steep = (across * across + down * down).sqrt();
        let most = pattern.cell[0].max(pattern.cell[1]);
        (f64::from((pattern.values[cell] - EDGE).abs()) / steep.max(1e-6)).min(most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges as Borders;

    #[test]
    fn depths_inside_and_outside_of_a_disc_are_exact_within_a_cell() {
        let depth = |[x, y]: [f64; 2]| 20.3 - libm::hypot(x - 32.2, y - 31.6);
        let disc = Field::from_fn([64, 64], [1.0, 1.0], Borders::Closed, |at| {
            (0.5 + depth(at) / 8.0).clamp(0.0, 1.0) as f32
        });
        let edges = Edges::new(&disc).unwrap();
        for cell in 0..disc.values.len() {
            let at = disc.grid().center_px(cell);
            let (found, beside) = edges.depth(cell).unwrap();
            assert_eq!(edges.is_inside(cell), depth(at) >= 0.0);
            assert_ne!(edges.is_inside(cell), edges.is_inside(beside));
            // The nearest cell on the other side is not quite in the direction of the nearest place of the edge.
            assert!((found - depth(at)).abs() < 0.75, "{at:?}: {found} {}", depth(at));
        }
    }

    #[test]
    fn a_pattern_of_one_value_has_no_edges() {
        for value in [0.2, 0.7] {
            let flat = Field::from_fn([8, 8], [1.0, 1.0], Borders::Wrap, |_| value);
            assert!(Edges::new(&flat).is_none());
        }
    }
}
