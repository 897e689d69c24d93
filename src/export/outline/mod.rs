//! Patterns → outlines for plotters, cutters and drawing programs.
//!
//! ```text
//!  rows of a pattern ─▶ trace ─▶ level lines ─▶ shapes ─▶ closed Beziers with holes ─▶ strokes, hatching ─▶ route ─▶ svg | dxf
//! ```
//! All lengths are px until they are written.

mod draw;
pub mod dxf;
mod fit;
mod hatch;
mod labels;
mod path;
mod route;
mod shapes;
pub mod svg;
#[cfg(test)]
mod tests;
mod trace;

pub use draw::{Ends, Group, Style, Travel, draw};
pub use hatch::{Hatch, hatch};
pub use path::{Path, Piece};
pub use route::{Route, route};

use super::Stopped;
use crate::grid::{Edges, Field};
use std::ops::Range;

/// The endings that a file of outlines may have.
pub const FORMATS: [&str; 2] = ["svg", "dxf"];

/// Farthest that a fitted curve lies from the traced points, in steps between the traced values. At 0.04 a circle through
/// exact points has its area within 0.8 % ÷ its radius, of at most eight cubics.
const TOLERANCE: f64 = 0.04;

/// An island of the pattern.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its boundary, closed; clockwise on a canvas where y runs down.
    pub outer: Path,
    /// The boundaries of its holes, closed; counter-clockwise. So shapes are filled alike by either fill rule.
    pub holes: Vec<Path>,
}

impl Shape {
    /// Its boundaries.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        std::iter::once(&self.outer).chain(&self.holes)
    }

    /// The area that it covers, px².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.paths().map(Path::area).sum()
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

/// A pattern that is asked for row by row.
pub struct Source<'a> {
    /// Values in a row, and rows.
    pub size: [usize; 2],
    /// The canvas that they cover, px.
    pub extent: [f64; 2],
    /// What lies beyond its border.
    pub edges: Edges,
    /// Gives the values of some rows.
    pub rows: &'a mut dyn FnMut(Range<usize>) -> Result<Vec<f32>, Stopped>,
}

/// The shapes where a pattern is at least `level`. Values that are no number are ground.
///
/// # Errors
/// What its rows say.
pub fn outline(source: &mut Source, level: f64, smallest: Smallest) -> Result<Vec<Shape>, Stopped> {
    let Source { size, extent, edges, .. } = *source;
    let traced = trace::trace(size, extent, edges, level, source.rows)?;
    let step = (extent[0] / size[0].max(1) as f64).min(extent[1] / size[1].max(1) as f64);
    Ok(shapes::shapes(&traced, extent, edges == Edges::Wrap, smallest, TOLERANCE * step))
}

/// The same for a field in memory.
#[must_use]
pub fn of_field(field: &Field, level: f64, smallest: Smallest) -> Vec<Shape> {
    let mut rows =
        |range: Range<usize>| Ok(field.values[range.start * field.width..range.end * field.width].to_vec());
    let mut source = Source {
        size: [field.width, field.height],
        extent: field.extent(),
        edges: field.edges,
        rows: &mut rows,
    };
    // Rows in memory never stop.
    outline(&mut source, level, smallest).unwrap_or_default()
}
