//! Patterns → the maps of a material: pure arithmetic on rows, so that a map of any size is made band by band.
//!
//! [`shares()`] says how much of each px belongs to each layer, [`Surface`] what that makes of height and roughness;
//! [`normals()`] and [`openness()`] are what light does with a [`Height`].

mod normal;
mod occlusion;
mod surface;

pub use normal::{Green, encoded, normals};
pub use occlusion::openness;
pub use surface::{Surface, shares};

use crate::grid::{Edges, Field};

/// Rows of a height, px, with a rim on all four sides of what lies beyond them.
#[derive(Clone, Debug, PartialEq)]
pub struct Height {
    /// px a row, without the rim.
    pub width: usize,
    /// Rows, without the rim.
    pub rows: usize,
    /// How wide the rim is, px.
    pub rim: usize,
    values: Vec<f32>,
}

impl Height {
    /// Puts a rim left and right of `values`, `width` a row, whose first and last `rim` rows are the rim above and below.
    #[must_use]
    pub fn new(values: &[f32], width: usize, rim: usize, edges: Edges) -> Self {
        let mut rimmed = Vec::with_capacity((width + 2 * rim) * (values.len() / width.max(1)));
        for row in values.chunks_exact(width.max(1)) {
            let beyond = |x: usize| row[edges.index(x as isize - rim as isize, width)];
            rimmed.extend((0..rim).map(beyond));
            rimmed.extend_from_slice(row);
            rimmed.extend((rim + width..width + 2 * rim).map(beyond));
        }
        let rows = (values.len() / width.max(1)).saturating_sub(2 * rim);
        Self { width, rows, rim, values: rimmed }
    }

    /// All of a field.
    #[must_use]
    pub fn of(field: &Field, rim: usize) -> Self {
        let beyond = -(rim as isize)..(field.height + rim) as isize;
        let row = |y: isize| {
            let start = field.edges.index(y, field.height) * field.width;
            &field.values[start..start + field.width]
        };
        Self::new(&beyond.flat_map(row).copied().collect::<Vec<_>>(), field.width, rim, field.edges)
    }

    /// Places from one row to the next.
    fn stride(&self) -> usize {
        self.width + 2 * self.rim
    }

    /// The place of column 0 of row `y`.
    fn start(&self, y: usize) -> usize {
        (y + self.rim) * self.stride() + self.rim
    }
}
