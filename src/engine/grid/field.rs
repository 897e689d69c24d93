//! Numbers on a grid: a concentration, a pattern, a picture's lightness.

use super::cells::Grid;
use super::edges::Edges;

/// Values on a `width` × `height` grid of cells that covers the canvas exactly.
///
/// The value `values[y * width + x]` belongs to the cell's centre, ((x + ½)·`cell[0]`, (y + ½)·`cell[1]`) px.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Cells in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// px a cell, along x and along y; nearly but not always equal, so that whole cells cover the canvas.
    pub cell: [f64; 2],
    /// What lies beyond the border.
    pub edges: Edges,
    /// `width * height` numbers, row by row from the top.
    pub values: Vec<f32>,
}

impl Field {
    /// A field of one value everywhere, one px a cell.
    ///
    /// ```
    /// use dapple_engine::grid::{Edges, Field};
    ///
    /// let field = Field::flat(8, 4, Edges::Closed, 0.5);
    /// assert_eq!((field.values.len(), field.extent()), (32, [8.0, 4.0]));
    /// ```
    #[must_use]
    pub fn flat(width: usize, height: usize, edges: Edges, value: f32) -> Self {
        Self { width, height, cell: [1.0, 1.0], edges, values: vec![value; width * height] }
    }

    /// A field whose values are those of `f` at each cell's centre, px.
    pub fn from_fn(
        [width, height]: [usize; 2],
        cell: [f64; 2],
        edges: Edges,
        mut f: impl FnMut([f64; 2]) -> f32,
    ) -> Self {
        let mut values = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                values.push(f([(x as f64 + 0.5) * cell[0], (y as f64 + 0.5) * cell[1]]));
            }
        }
        Self { width, height, cell, edges, values }
    }

    /// A field with these values, one a cell of `grid`.
    #[must_use]
    pub fn new(grid: &Grid, values: Vec<f32>) -> Self {
        let [width, height] = grid.size;
        Self { width, height, cell: grid.cell, edges: grid.edges, values }
    }

    /// The cells that it has values of.
    #[must_use]
    pub fn grid(&self) -> Grid {
        Grid { size: [self.width, self.height], cell: self.cell, edges: self.edges }
    }

    /// Width and height of the canvas it covers, px.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        [self.width as f64 * self.cell[0], self.height as f64 * self.cell[1]]
    }

    /// The value of the cell at column `x`, row `y`, which may lie beyond the border.
    ///
    /// ```
    /// use dapple_engine::grid::{Edges, Field};
    ///
    /// let ramp = Field::from_fn([4, 1], [1.0, 1.0], Edges::Wrap, |[x, _]| x.floor() as f32);
    /// assert_eq!((ramp.get(1, 0), ramp.get(-1, 0)), (1.0, 3.0));
    /// ```
    #[must_use]
    pub fn get(&self, x: isize, y: isize) -> f32 {
        self.values[self.edges.index(y, self.height) * self.width + self.edges.index(x, self.width)]
    }

    /// The smallest and the largest of the four values around a point, px, which may lie beyond the border.
    #[must_use]
    pub fn range_around(&self, [x, y]: [f64; 2]) -> [f32; 2] {
        let [x, y] = [x / self.cell[0] - 0.5, y / self.cell[1] - 0.5].map(|place| place.floor() as isize);
        let four = [self.get(x, y), self.get(x + 1, y), self.get(x, y + 1), self.get(x + 1, y + 1)];
        four.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], value| {
            [low.min(*value), high.max(*value)]
        })
    }
}

/// The 16-bit step nearest to a pattern value: 0..1 becomes 0..65535. Values outside become the nearer end, NaN becomes 0.
/// Patterns and colours are written with it.
///
/// ```
/// use dapple_engine::grid::to_u16;
///
/// assert_eq!([0.0, 1.0, 2.0].map(to_u16), [0, 65_535, 65_535]);
/// ```
#[must_use]
pub fn to_u16(value: f32) -> u16 {
    // In f64 the half is added exactly; the cast rounds down and turns NaN into 0.
    (f64::from(value.clamp(0.0, 1.0)) * 65535.0 + 0.5) as u16
}

#[cfg(test)]
mod tests {
    use crate::grid::*;

    #[test]
    fn pattern_values_go_to_the_nearest_of_65536_steps() {
        for step in 0..=u16::MAX {
            assert_eq!(to_u16(f32::from(step) / 65535.0), step);
        }
        assert_eq!([-0.1, f32::NAN, 0.5, 1.1].map(to_u16), [0, 0, 32768, 65535]);
        assert_eq!([0.49, 0.51].map(|part| to_u16((7.0 + part) / 65535.0)), [7, 8]);
    }
}
