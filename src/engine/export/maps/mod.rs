//! Patterns → the maps of a material. Everything works on rows, so a map of any size is computed band by band.
//!
//! [`shares()`] computes how much of each px belongs to each layer, [`Surface`] the height and the roughness from that;
//! [`normals()`] and [`openness()`] are computed from a [`Height`].

mod normal;
mod occlusion;
mod surface;

pub use normal::{Green, encoded, normals};
pub use occlusion::openness;
pub use surface::{Surface, share_of, shares};

use crate::grid::{Edges, Field};

/// Rows of heights, px, with a margin of the neighbouring values on all four sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Height {
    /// px a row, without the margin.
    pub width: usize,
    /// Rows, without the margin.
    pub rows: usize,
    /// Width of the margin, px.
    pub margin: usize,
    values: Vec<f32>,
}

impl Height {
    /// Adds margins left and right to `values` (`width` a row), whose first and last `margin` rows are the margins above and below.
    #[must_use]
    pub fn new(values: &[f32], width: usize, margin: usize, edges: Edges) -> Self {
        let mut values_with_margin = Vec::with_capacity((width + 2 * margin) * (values.len() / width.max(1)));
        for row in values.chunks_exact(width.max(1)) {
            let beyond = |x: usize| row[edges.index(x as isize - margin as isize, width)];
            values_with_margin.extend((0..margin).map(beyond));
            values_with_margin.extend_from_slice(row);
            values_with_margin.extend((margin + width..width + 2 * margin).map(beyond));
        }
        let rows = (values.len() / width.max(1)).saturating_sub(2 * margin);
        Self { width, rows, margin, values: values_with_margin }
    }

    /// The heights of a whole field.
    #[must_use]
    pub fn from_field(field: &Field, margin: usize) -> Self {
        let beyond = -(margin as isize)..(field.height + margin) as isize;
        let row = |y: isize| {
            let start = field.edges.index(y, field.height) * field.width;
            &field.values[start..start + field.width]
        };
        Self::new(&beyond.flat_map(row).copied().collect::<Vec<_>>(), field.width, margin, field.edges)
    }

    /// Distance between the starts of successive rows, in values.
    fn stride(&self) -> usize {
        self.width + 2 * self.margin
    }

    /// The index of column 0 of row `y`.
    fn start(&self, y: usize) -> usize {
        (y + self.margin) * self.stride() + self.margin
    }
}
