//! Patterns → outlines for plotters, cutters and drawing programs.
//!
//! ```text
//! rows of a pattern ─▶ trace ─▶ level lines ─▶ shapes ─▶ closed Beziers with holes ─▶ strokes, hatching ─▶ route ─▶ svg | dxf
//! ```
//! All lengths are px until they are written.

mod draw;
pub mod dxf;
mod fit;
mod hatch;
pub mod path;
mod pen_ends;
mod route;
mod shapes;
pub mod svg;
#[cfg(test)]
mod tests;
mod trace;

pub use kurbo::BezPath;

pub use draw::{Ends, Group, Style, Travel, draw};
pub use hatch::{Hatch, hatch};
pub use route::{Route, route};

use super::Stopped;
use crate::grid::{Edges, Field};
use std::ops::Range;

/// The file name endings of outline formats.
pub const FORMATS: [&str; 2] = ["svg", "dxf"];

/// Approximate largest distance of a fitted curve from the traced points, in steps between the traced values. Measured over the
/// examples: at most 0.05, and areas within 0.03 %.
const TOLERANCE: f64 = 0.04;

/// An island of the pattern.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its boundary, closed; clockwise on a canvas where y runs down.
    pub outer: BezPath,
    /// The boundaries of its holes, closed; counter-clockwise, so that both fill rules give the same area.
    pub holes: Vec<BezPath>,
}

impl Shape {
    /// Its boundary and the boundaries of its holes.
    pub fn paths(&self) -> impl Iterator<Item = &BezPath> {
        std::iter::once(&self.outer).chain(&self.holes)
    }

    /// The area it covers, px².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.paths().map(kurbo::Shape::area).sum()
    }
}

/// Islands and holes smaller than this are left out; 0 = none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Smallest {
    /// Width, px: the diameter of a disc, the width of a stripe.
    pub width: f64,
    /// Area, px².
    pub area: f64,
}

/// A pattern that is read row by row.
pub struct Source<'a> {
    /// Number of values in a row, and number of rows.
    pub size: [usize; 2],
    /// Size of the canvas that they cover, px.
    pub extent: [f64; 2],
    /// Continuation of the pattern beyond its border.
    pub edges: Edges,
    /// Returns the values of some rows.
    pub rows: &'a mut dyn FnMut(Range<usize>) -> Result<Vec<f32>, Stopped>,
}

/// The shapes where a pattern is at least `level`; NaN counts as below it.
///
/// # Errors
/// The error of [`Source::rows`].
pub fn outline(source: &mut Source, level: f64, smallest: Smallest) -> Result<Vec<Shape>, Stopped> {
    let Source { size, extent, edges, .. } = *source;
    let traced = trace::trace(size, extent, edges, level, source.rows)?;
    let step = (extent[0] / size[0].max(1) as f64).min(extent[1] / size[1].max(1) as f64);
    Ok(shapes::shapes(&traced, extent, edges == Edges::Wrap, smallest, TOLERANCE * step))
}

/// The shapes where a `field` in memory is at least `level`; NaN counts as below it.
///
/// ```
/// use dapple_engine::export::outline::{Smallest, outline_field};
/// use dapple_engine::grid::{Edges, Field};
///
/// let depth = |[x, y]: [f64; 2]| (10.0 - (x - 20.0).hypot(y - 24.0)) as f32;
/// let disc = Field::from_fn([48, 48], [1.0, 1.0], Edges::Closed, depth);
/// let shapes = outline_field(&disc, 0.0, Smallest::default());
/// assert_eq!(shapes.len(), 1);
/// assert!((shapes[0].area() / (100.0 * std::f64::consts::PI) - 1.0).abs() < 0.03);
/// ```
#[must_use]
pub fn outline_field(field: &Field, level: f64, smallest: Smallest) -> Vec<Shape> {
    let mut rows =
        |range: Range<usize>| Ok(field.values[range.start * field.width..range.end * field.width].to_vec());
    let mut source = Source {
        size: [field.width, field.height],
        extent: field.extent(),
        edges: field.edges,
        rows: &mut rows,
    };
    // Reading rows in memory cannot fail.
    outline(&mut source, level, smallest).unwrap_or_default()
}
