//! The pattern of a field that is above ½ inside areas: patches, cells, streaks, cracks, fields of points.

use std::ops::Range;

use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};
use crate::synth::pattern::PatternRows;

/// The pattern of areas at any size.
pub struct AreaPattern {
    grid: [usize; 2],
    extent: [f64; 2],
    edges: Edges,
    surface: Spline,
}

impl AreaPattern {
    /// The pattern of a field that is above ½ inside areas.
    #[must_use]
    pub fn new(field: &Field) -> Self {
        Self {
            grid: [field.width, field.height],
            extent: field.extent(),
            edges: field.edges,
            surface: Spline::new(field),
        }
    }

    /// Cells along x and y of the grid that they grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.grid
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut values = self.surface.rows(rows, width, height);
        // The spline overshoots where the field reaches 0 and 1.
        values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
        values
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        let cell = [self.extent[0] / width as f64, self.extent[1] / height as f64];
        Field { width, height, cell, edges: self.edges, values: self.rows(0..height, width, height) }
    }
}

impl PatternRows for AreaPattern {
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
