//! The pattern of a layer that a picture drives.

use std::ops::Range;

use rayon::prelude::*;

use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};
use crate::synth::pattern::{PatternRows, share};
use crate::synth::tone::grown::relief::HEIGHTS;

/// Least distance of thresholds from the heights that count as ground and as the middle of a mark.
const MARGIN: f32 = 0.03;

/// A relief and the threshold of each px, at any size.
pub struct TonePattern<'a> {
    grid: [usize; 2],
    extent: [f64; 2],
    edges: Edges,
    surface: Spline,
    levels: Levels<'a>,
}

/// The thresholds of the edges.
#[derive(Clone, Copy)]
pub enum Levels<'a> {
    /// One height everywhere.
    Even(f32),
    /// The heights of a field over the canvas.
    Each {
        /// The heights.
        levels: &'a Field,
        /// Factors by which the heights above and below are stretched.
        gains: &'a Field,
    },
}

impl<'a> TonePattern<'a> {
    /// The pattern of a relief with these thresholds.
    #[must_use]
    pub fn new(relief: &Field, levels: Levels<'a>) -> Self {
        Self {
            grid: [relief.width, relief.height],
            extent: relief.extent(),
            edges: relief.edges,
            surface: Spline::new(relief),
            levels,
        }
    }

    /// Cells along x and y of the grid that it grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.grid
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut values = self.surface.rows(rows.clone(), width, height);
        values.par_chunks_mut(width.max(1)).zip(rows.into_par_iter()).for_each(|(row, y)| {
            match self.levels {
                Levels::Even(level) => row.iter_mut().for_each(|value| *value = cut(*value, level)),
                Levels::Each { levels, gains } => {
                    let [level, gain] = [levels, gains].map(|field| between(field, y, height, width));
                    row.iter_mut().enumerate().for_each(|(x, value)| {
                        let level = level(x);
                        *value = cut(level + gain(x) * (*value - level), level);
                    });
                }
            }
        });
        values
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        let cell = [self.extent[0] / width as f64, self.extent[1] / height as f64];
        Field { width, height, cell, edges: self.edges, values: self.rows(0..height, width, height) }
    }
}

impl PatternRows for TonePattern<'_> {
    fn grid(&self) -> [usize; 2] {
        self.grid()
    }

    fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        self.rows(rows, width, height)
    }

    fn field(&self, width: usize, height: usize) -> Field {
        self.field(width, height)
    }
}

/// The pattern value of a height of the relief with the threshold `level`.
fn cut(height: f32, level: f32) -> f32 {
    let (low, high) = (HEIGHTS[0].min(level - MARGIN), HEIGHTS[1].max(level + MARGIN));
    let of = |value: f32| (value - low) / (high - low);
    share(of(height), of(level))
}

/// A field at the px of row `y` of a picture of `width` × `height` px, bilinear: thresholds change abruptly where the picture does,
/// and a smoother interpolation would overshoot.
fn between(field: &Field, y: usize, height: usize, width: usize) -> impl Fn(usize) -> f32 + use<'_> {
    let place = |at: usize, cells: usize, px: usize| {
        let place = (at as f32 + 0.5) * cells as f32 / px as f32 - 0.5;
        let first = place.floor();
        let cell = |k: isize| field.edges.index(k, cells);
        (cell(first as isize), cell(first as isize + 1), place - first)
    };
    let (upper, lower, v) = place(y, field.height, height);
    let [upper, lower] = [upper, lower].map(|row| &field.values[row * field.width..(row + 1) * field.width]);
    move |x| {
        let (left, right, u) = place(x, field.width, width);
        let of_row = |row: &[f32]| row[left] + u * (row[right] - row[left]);
        of_row(upper) + v * (of_row(lower) - of_row(upper))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_lies_at_the_level_and_the_middle_of_thin_lines_is_one() {
        for level in [0.05, 0.2, 0.5, 0.84, 0.95] {
            assert!((cut(level, level) - 0.5).abs() < 1e-5, "{level}");
        }
        assert!(cut(0.85, 0.82) > 0.99 && cut(0.15, 0.18) < 0.01);
        assert!(cut(0.4, 0.5) < 0.5 && cut(0.6, 0.5) > 0.5);
    }

    #[test]
    fn levels_are_read_where_they_lie() {
        let values = vec![0.2, 0.4, 0.6, 0.8];
        let field = Field { width: 4, height: 1, cell: [1.0; 2], edges: Edges::Closed, values };
        let level = between(&field, 0, 1, 8);
        assert!((level(3) - 0.45).abs() < 1e-6 && (level(0) - 0.2).abs() < 1e-6, "{} {}", level(3), level(0));
    }
}
