//! An open stroke → the path that was meant: without the jitter of the pen, and with few points.

use super::path::{even, smoothed};
use crate::marks::{Line, Path, distance_to_segment, fit};

/// Steps along a stroke, ÷ its width: several points in the length over which it is smoothed.
const STEP: f64 = 0.25;
/// The shortest step, px: pens move from px to px.
const LEAST_STEP: f64 = 0.5;
/// The most steps; a longer stroke has longer ones.
const MOST_STEPS: f64 = 4000.0;
/// Rounds of (¼, ½, ¼) that smooth a stroke: a Gaussian of 1.4 steps, so of a third of the width.
const ROUNDS: usize = 4;
/// A path departs from the smoothed stroke by at most this share of its width, or by half a px.
const TOLERANCE: f64 = 0.05;
const LEAST_TOLERANCE: f64 = 0.5;
/// Half the breadth of a stroke that goes to and fro along a line, ÷ the length of the line.
const RETRACED: f64 = 0.06;

/// The path of an open stroke of `width` px, or a line where it departs from one by less than half its width.
pub(super) enum Bend {
    /// A straight one.
    Line(Line),
    /// One that bends.
    Path(Path),
}

/// What was meant by the `points` of an open stroke; `None` where they have no extent or are not finite.
pub(super) fn bend(points: &[[f64; 2]], width: f64) -> Option<Bend> {
    let length: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    if !(length.is_finite() && length > 0.0) {
        return None;
    }
    let step = (STEP * width).max(LEAST_STEP).min(length / 8.0).max(length / MOST_STEPS);
    let points = even(points, step, MOST_STEPS);
    let line = fit::line(&points, width)?;
    let departure =
        points.iter().map(|point| distance_to_segment(*point, [line.from, line.to])).fold(0.0, f64::max);
    let is_retraced = length > 1.6 * line.length() && departure < RETRACED * line.length();
    if departure < 0.5 * width || is_retraced {
        return Some(Bend::Line(line));
    }
    let smooth = (0..ROUNDS).fold(points, |points, _| smoothed(&points));
    let path = Path { points: smooth, width };
    Some(Bend::Path(path.simplified((TOLERANCE * width).max(LEAST_TOLERANCE))))
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [x, y] = [a[0] - b[0], a[1] - b[1]];
    (x * x + y * y).sqrt()
}
