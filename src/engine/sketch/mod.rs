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
///
/// ```
/// use dapple_engine::marks::Mark;
/// use dapple_engine::sketch::recognise;
///
/// // A closed curve is a spot, an open one a stripe.
/// let drawn = |turns: f64| -> Vec<[f64; 2]> {
///     let at = |k: i32| (f64::from(k) / 60.0 * turns * std::f64::consts::TAU).sin_cos();
///     (0..=60).map(|k| [50.0 + 12.0 * at(k).1, 40.0 + 6.0 * at(k).0]).collect()
/// };
/// assert!(matches!(recognise(&drawn(1.0), 4.0), Some(Mark::Ellipse(_))));
/// assert!(matches!(recognise(&drawn(0.4), 4.0), Some(Mark::Path(_) | Mark::Line(_))));
/// ```
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

/// The ellipse that a closed stroke is read as, and the share of its area by which the outline differs from it; `None` of an
/// open stroke, and of a blob that is filled by hatching.
///
/// Along the outline, at ρ times the ellipse's radius in direction θ (of the ellipse stretched to a circle), the share is the
/// mean of |1 − ρ²| over θ: exact for outlines that turn about their centre, and large for spirals, whose inner rounds lie
/// far inside.
#[must_use]
pub fn difference_from_ellipse(points: &[[f64; 2]]) -> Option<(Ellipse, f64)> {
    let hull = Hull::new(points)?;
    let path = Path::new(points, hull.diameter());
    let outline = outline::find(&path, &hull)?;
    let outline = &path.points[outline];
    let ellipse = ellipse(outline)?;
    Some((ellipse, difference(outline, &ellipse)?))
}

/// The share of its area by which an outline differs from an ellipse, see [`difference_from_ellipse`].
fn difference(outline: &[[f64; 2]], ellipse: &Ellipse) -> Option<f64> {
    let (s, c) = libm::sincos(ellipse.angle.to_radians());
    let stretched = |[x, y]: [f64; 2]| {
        let [x, y] = [x - ellipse.center[0], y - ellipse.center[1]];
        [(c * x + s * y) / ellipse.radii[0], (c * y - s * x) / ellipse.radii[1]]
    };
    let stretched: Vec<[f64; 2]> = outline.iter().map(|point| stretched(*point)).collect();
    let (mut turned, mut differs) = (0.0, 0.0);
    for pair in stretched.windows(2) {
        let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
        let turn = libm::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1).abs();
        let [x, y] = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
        turned += turn;
        differs += turn * (1.0 - x * x - y * y).abs();
    }
    (turned > 0.0).then(|| differs / turned)
}

/// The corners of a closed stroke's outline, `most` at most, without what overshoots it; `None` of an open stroke, and of a blob that
/// is filled by hatching.
#[must_use]
pub fn closed_outline(points: &[[f64; 2]], most: usize) -> Option<Vec<[f64; 2]>> {
    let hull = Hull::new(points)?;
    let path = Path::new(points, hull.diameter());
    let outline = outline::find(&path, &hull)?;
    let corners = &path.points[outline];
    let step = corners.len().div_ceil(most.max(1)).max(1);
    Some(corners.iter().step_by(step).copied().collect())
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

/// The ellipse of a closed outline, px, and the share of its area by which the outline differs from it; a rectangle becomes the one
/// with its second moments. `None` where it encloses nothing or a coordinate is not a finite number.
#[must_use]
pub fn fit_outline(points: &[[f64; 2]]) -> Option<(Ellipse, f64)> {
    let hull = Hull::new(points)?;
    let outline = Path::new(points, hull.diameter()).points;
    let ellipse = ellipse(&outline)?;
    Some((ellipse, difference(&outline, &ellipse).unwrap_or(0.0)))
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
