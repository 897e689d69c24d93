//! Reduces the outline of a freehand stroke to what a hand can draw, so that links with outlines are short.

use crate::document::{Outline, Stroke};
use crate::marks::Path;

/// A corner is left out where it lies within this distance of a line between other corners, px. Hands and screens are
/// less exact.
const FINE: f64 = 0.1;
/// In small outlines, which the window shows enlarged, a corner is left out where its distance from a line between
/// others is below this share of the longer side.
const SHARE: f64 = 1.0 / 250.0;

/// A simplified outline: corners that lie within a tenth of a px of a line between others are left out, and the rest
/// are rounded to a tenth of a px. Small outlines are ten times finer. `None` where a document cannot hold the outline.
#[must_use]
pub fn outline(mut corners: Vec<[f64; 2]>) -> Option<Outline> {
    corners.push(*corners.first()?);
    let ring = Path { points: corners, width: 0.0 };
    let [low, high] = ring.bounds();
    let tolerance = FINE.min(SHARE * (high[0] - low[0]).max(high[1] - low[1]));
    let steps = if tolerance < FINE { 100.0 } else { 10.0 };
    let rounded = |point: [f64; 2]| point.map(|coordinate| (steps * coordinate).round() / steps);
    let mut points: Vec<[f64; 2]> = ring.simplified(tolerance).points.into_iter().map(rounded).collect();
    // The first corner is repeated at the end.
    points.pop();
    Outline::of(points)
}

/// The stroke, with the corners of its outline rounded to a thousandth of a px. Turned and scaled corners have many
/// more digits.
#[must_use]
pub fn rounded(stroke: Stroke) -> Stroke {
    let rounded = |outline: Outline| {
        let fine = |point: [f64; 2]| point.map(|coordinate| (1e3 * coordinate).round() / 1e3);
        Outline { points: outline.points.into_iter().map(fine).collect() }
    };
    match stroke {
        Stroke::Outline(outline) => Stroke::Outline(rounded(outline)),
        Stroke::Fitted { ellipse, outline } => Stroke::Fitted { ellipse, outline: rounded(outline) },
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::{distance_to_segment, ellipse_of_outline};

    /// A dented outline around a place, as the pen draws it: 125 corners with all their digits.
    fn drawn(radius: f64) -> Vec<[f64; 2]> {
        let at = |k: usize| std::f64::consts::TAU * k as f64 / 125.0;
        let wide = |t: f64| {
            radius * (1.0 + 0.08 * (2.0 * t).sin() - 0.12 * (3.0 * t).cos() + 0.01 * (9.0 * t).sin())
        };
        (0..125).map(at).map(|t| [200.0 + 1.6 * wide(t) * t.cos(), 150.0 + wide(t) * t.sin()]).collect()
    }

    fn area(corners: &[[f64; 2]]) -> f64 {
        let next = corners.iter().cycle().skip(1);
        0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
    }

    #[test]
    fn an_outline_stays_where_it_was_drawn_to_a_fifth_of_a_px_and_small_ones_finer() {
        for (radius, farthest) in [(2.0, 0.035), (15.0, 0.2), (80.0, 0.2)] {
            let drawn = drawn(radius);
            let kept = outline(drawn.clone()).unwrap().points;
            let sides = || kept.iter().zip(kept.iter().cycle().skip(1));
            for corner in &drawn {
                let near = sides()
                    .map(|(a, b)| distance_to_segment(*corner, [*a, *b]))
                    .fold(f64::INFINITY, f64::min);
                assert!(near < farthest, "{radius}: {near}");
            }
            let relative = area(&kept) / area(&drawn) - 1.0;
            assert!(relative.abs() < 0.01, "{radius}: {relative}");
            let [before, after] = [&drawn, &kept].map(|corners| ellipse_of_outline(corners).unwrap());
            for axis in 0..2 {
                assert!((after.radii[axis] / before.radii[axis] - 1.0).abs() < 0.006, "{before:?} {after:?}");
            }
        }
    }

    #[test]
    fn outlines_of_spots_take_less_than_a_third_of_the_digits() {
        let digits = |corners: &[[f64; 2]]| format!("{corners:?}").len();
        for radius in [2.0, 4.0, 8.0, 15.0] {
            let drawn: Vec<_> =
                drawn(radius).iter().map(|point| point.map(|x| (1e3 * x).round() / 1e3)).collect();
            let kept = outline(drawn.clone()).unwrap().points;
            assert!(
                kept.iter().flatten().all(|x| (100.0 * x - (100.0 * x).round()).abs() < 1e-6),
                "{kept:?}"
            );
            assert!(3 * digits(&kept) < digits(&drawn), "{} of {}", digits(&kept), digits(&drawn));
        }
    }

    #[test]
    fn a_stroke_that_encloses_no_area_has_no_outline() {
        assert_eq!(outline(Vec::new()), None);
        assert_eq!(outline(vec![[1.0, 2.0]; 40]), None);
        assert_eq!(outline(vec![[1.0, 2.0], [60.0, 2.0], [30.0, 2.0]]), None);
    }
}
