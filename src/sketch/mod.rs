//! Strokes → marks: ellipses, lines and paths drawn by hand.
//!
//! A freehand stroke is a list of pen positions. [`recognise`] classifies it as a person would: a closed outline is an
//! ellipse, an open stroke a path, or a line where it is straight.

mod bend;
mod hull;
mod outline;
mod path;
pub mod svg;

use crate::marks::{Ellipse, Mark, fit};
use bend::Bend;
use hull::Hull;
use path::Path;

/// A fitted ellipse whose area or length lies outside this range of ratios to that of the outline's hull is
/// rejected. Fits of the outlines in the tests lie in 0.78..1.2: a hull cuts the gap off an
/// open C, and wraps round the jitter and around all rounds of a scribble.
const PLAUSIBLE: std::ops::Range<f64> = 0.7..1.4;

/// The mark that a freehand stroke stands for: an ellipse if it is closed; if open a path (of `width`, px), or a line
/// where it departs from one by less than half its width.
///
/// `points` are in px, in the order drawn; how fast the pen moved does not matter. A stroke is
/// closed where it comes back near its start, overshoots it, goes round several times or lacks a small piece, and encloses
/// an area; a blob that is filled by hatching is closed too. A line that is drawn over several times is a line: the total
/// least squares one, as long as the stroke along it. A path follows the stroke, smoothed over a third of its width.
///
/// `None` where the stroke has no extent or a coordinate is not a finite number.
#[must_use]
pub fn recognise(points: &[[f64; 2]], width: f64) -> Option<Mark> {
    match closed(points)? {
        Ok(ellipse) => Some(Mark::Ellipse(ellipse)),
        Err(_) => bend::bend(points, width).map(|bend| match bend {
            Bend::Line(line) => Mark::Line(line),
            Bend::Path(path) => Mark::Path(path),
        }),
    }
}

/// The mark that a freehand stroke stood for in documents of version 1: any open one was a line, in the direction of the
/// total least squares line and as long as the stroke's extent along it.
#[must_use]
pub fn recognise_straight(points: &[[f64; 2]], width: f64) -> Option<Mark> {
    match closed(points)? {
        Ok(ellipse) => Some(Mark::Ellipse(ellipse)),
        Err(path) => fit::line(&path.points, width).map(Mark::Line),
    }
}

/// The ellipse of a closed stroke, or the path of an open one; `None` of a stroke without extent.
fn closed(points: &[[f64; 2]]) -> Option<Result<Ellipse, Path>> {
    let hull = Hull::new(points)?;
    let path = Path::new(points, hull.diameter());
    if let Some(outline) = outline::find(&path, &hull) {
        return ellipse(&path.points[outline]).map(Ok);
    }
    if outline::is_hatched(&path, &hull) {
        return hull.ellipse().map(Ok);
    }
    Some(Err(path))
}

/// The ellipse of a closed outline, px; a rectangle becomes the one with its second moments. `None` where it encloses
/// nothing or a coordinate is not a finite number.
#[must_use]
pub fn fit_outline(points: &[[f64; 2]]) -> Option<Ellipse> {
    let hull = Hull::new(points)?;
    ellipse(&Path::new(points, hull.diameter()).points)
}

/// The ellipse of an outline: the direct least squares one, or, where that is not plausible, the one with the
/// second moments of the outline's hull.
fn ellipse(outline: &[[f64; 2]]) -> Option<Ellipse> {
    let rough = Hull::new(outline)?.ellipse()?;
    let plausible = |fitted: &Ellipse| {
        PLAUSIBLE.contains(&(fitted.area() / rough.area()))
            && PLAUSIBLE.contains(&(fitted.radii[0] / rough.radii[0]))
    };
    Some(fit::ellipse(outline).filter(plausible).unwrap_or(rough))
}

#[cfg(test)]
mod tests;
