//! Finds out whether a stroke is closed, and which part of it is the outline.
//!
//! A person sees an outline where a stroke comes back to an earlier point and encloses most of the area that it
//! spans. So each part of the stroke, from point i to point j, is rated by the width of its gap, the area that it
//! encloses and how far it turns. The best part is the outline; the rest (the hook at a start, the tail of an
//! overshoot) is left out.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use super::hull::Hull;
use super::path::Path;

// Tuned by the table of strokes in the tests, over 2,000 of each kind; all but a narrow V (99.2 %) and a
// C of aspect 0.3 that lacks its tip (99.7 %) came out right each time.

/// An outline's gap is at most this share of its breadth. A circle that lacks 80° has 0.7, a narrow U 0.8,
/// a half circle 2.
const GAP_TO_BREADTH: f64 = 0.75;

/// Or at most this share of its length, if it turns as far as `C_TURNS`: a C with its gap on the flat side.
const GAP_TO_LENGTH: f64 = 0.27;

/// A circle that lacks 100° turns 0.72 times, a U or a V half a turn.
const C_TURNS: f64 = 0.6;

/// An outline encloses at least this share of the stroke's hull. A loop at the end of a line has 0.2 of it,
/// an outline with a tail 0.78 and more, the outer round of a spiral 0.56.
const ENCLOSED: f64 = 0.55;

/// Breadth ÷ length of the thinnest outline. Lines retraced with their ends up to 4 % of the length apart
/// stay below it.
const THINNEST: f64 = 0.09;

/// The part of the path that is a closed outline, if there is one.
pub(super) fn find(path: &Path, hull: &Hull) -> Option<RangeInclusive<usize>> {
    let hull = Measures { area: hull.area(), perimeter: hull.perimeter() };
    let end = path.len() - 1;
    let whole = path.length(0, end);
    let mut best: Option<(f64, RangeInclusive<usize>)> = None;
    for i in 0..end {
        for j in (i + 2..=end).rev() {
            let left_out = 1.0 - path.length(i, j) / whole;
            if best.as_ref().is_some_and(|(least, _)| left_out >= *least) {
                break;
            }
            if let Some(gap) = gap_of_outline(path, i, j, &hull) {
                let cost = gap + left_out;
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, i..=j));
                }
            }
        }
    }
    best.map(|(_, outline)| outline)
}

/// Measures of the hull that each part is compared with.
struct Measures {
    area: f64,
    perimeter: f64,
}

/// Gap ÷ breadth of the part from `i` to `j`; `None` where it is not an outline.
fn gap_of_outline(path: &Path, i: usize, j: usize, hull: &Measures) -> Option<f64> {
    let (gap, length, turns) = (path.gap(i, j), path.length(i, j), path.turns(i, j));
    // Jitter of the pen may look like a turn, but it has no length.
    let rounds = turns.min(length / hull.perimeter).round().max(1.0);
    let area = path.area(i, j) / rounds;
    if area < ENCLOSED * hull.area || area <= 0.0 {
        return None;
    }
    let [a, b] = radii(area, (length + gap) / rounds);
    let near = gap <= GAP_TO_BREADTH * 2.0 * b || (gap <= GAP_TO_LENGTH * length && turns >= C_TURNS);
    (near && b >= THINNEST * a).then(|| gap / (2.0 * b))
}

/// Major and minor radius of the ellipse of this area and perimeter.
///
/// From A = πab and Euler's P ≈ π·√(2(a² + b²)): (a ± b)² = P²/2π² ± 2A/π.
fn radii(area: f64, perimeter: f64) -> [f64; 2] {
    let (squares, product) = (perimeter * perimeter / (2.0 * PI * PI), 2.0 * area / PI);
    let (sum, difference) = ((squares + product).sqrt(), (squares - product).max(0.0).sqrt());
    [0.5 * (sum + difference), 0.5 * (sum - difference)]
}

/// Whether an area was filled by hatching: the hull is not thin, and the path within it is, even smoothed, at least 1.2
/// times as long as the hull's outline. The hatched blobs of the tests have 1.29
/// and more; open strokes whose hull is as fat, like a half circle, have 0.9 at most.
pub(super) fn is_hatched(path: &Path, hull: &Hull) -> bool {
    let fat = hull.area() >= 0.45 * PI / 4.0 * hull.diameter() * hull.diameter();
    fat && path.length(0, path.len() - 1) >= 1.2 * hull.perimeter()
}
