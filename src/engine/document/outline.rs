//! Outlines: closed polygons that patches are drawn as.

use crate::document::limits;
use crate::marks::{Ellipse, ellipse_of_outline, largest_loop};
use crate::sketch::closed_outline;

/// A closed polygon that a patch was drawn as.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Its corners in order, px, at least three; the last is joined to the first.
    pub points: Vec<[f64; 2]>,
}

/// Weight of a rotation by one radian against a stretch of one axis by a factor of e. It selects one of the four ways in which an
/// ellipse can become another. Between two frames an outline is usually rotated by a few degrees and stretched by little.
const TURNING: f64 = 0.3;

impl Outline {
    /// The outline of a closed freehand stroke; `None` for an open one, and where a document cannot hold it because it encloses
    /// nothing or crosses itself.
    #[must_use]
    pub fn closed(points: &[[f64; 2]]) -> Option<Self> {
        Self::of(closed_outline(points, limits::MAX_CORNERS)?)
    }

    /// The polygon with these corners, rounded to a thousandth of a px. Corners are left out at equal steps if there are more than
    /// a document can hold. `None` for the outlines that [`Self::closed`] refuses.
    #[must_use]
    pub fn of(corners: Vec<[f64; 2]>) -> Option<Self> {
        let step = corners.len().div_ceil(limits::MAX_CORNERS).max(1);
        let fine = |point: [f64; 2]| point.map(|coordinate| (1e3 * coordinate).round() / 1e3);
        let mut points: Vec<[f64; 2]> = corners.into_iter().step_by(step).map(fine).collect();
        points.dedup();
        let is_wide = |ellipse: Ellipse| ellipse.radii[1] >= limits::MIN_LENGTH;
        let encloses = points.len() >= 3 && ellipse_of_outline(&points).is_some_and(is_wide);
        let crosses = || largest_loop(&points).is_some_and(|(share, _)| share > limits::LOOP);
        (encloses && !crosses()).then_some(Self { points })
    }

    /// This outline under the affine map that takes the axes of the ellipse `from` to those of the ellipse `to`. There are four
    /// such maps; the one that stretches and rotates least is used.
    pub(super) fn carried(&self, from: &Ellipse, to: &Ellipse) -> Self {
        let way = |quarter: i32| {
            let [r, q] = from.radii;
            let radii = if quarter % 2 == 0 { [r, q] } else { [q, r] };
            let angle = from.angle + 90.0 * f64::from(quarter);
            let turned = (to.angle - angle + 180.0).rem_euclid(360.0) - 180.0;
            let stretched = libm::log(to.radii[0] * radii[1] / (radii[0] * to.radii[1]));
            (stretched.abs() + TURNING * turned.to_radians().abs(), Ellipse { radii, angle, ..*from })
        };
        let ways = [0, 1, 2, 3].map(way);
        let from = ways.iter().fold(&ways[0], |best, way| if way.0 < best.0 { way } else { best }).1;
        let [before, after] = [from.angle, to.angle].map(|angle| libm::sincos(angle.to_radians()));
        let stretch = [0, 1].map(|axis| to.radii[axis] / from.radii[axis]);
        let carried = |[x, y]: &[f64; 2]| {
            let ((s, c), [dx, dy]) = (before, [x - from.center[0], y - from.center[1]]);
            let [u, v] = [stretch[0] * (c * dx + s * dy), stretch[1] * (c * dy - s * dx)];
            let (s, c) = after;
            [to.center[0] + c * u - s * v, to.center[1] + s * u + c * v]
        };
        Self { points: self.points.iter().map(carried).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Stroke;
    use crate::marks::Mark;

    #[test]
    fn an_outline_is_carried_as_its_ellipse_moves_turns_and_stretches() {
        let corners = [[40.0, 40.0], [100.0, 40.0], [100.0, 60.0], [70.0, 66.0], [40.0, 60.0]];
        let stroke = Stroke::outline(corners);
        let ellipse = stroke.mark().and_then(|mark| mark.ellipse()).expect("an area");
        let after = |to: Ellipse| match stroke.changed(Mark::Ellipse(to)) {
            Stroke::Outline(outline) => outline.points,
            other => panic!("{other:?}"),
        };
        let near = |found: &[[f64; 2]], expected: &dyn Fn([f64; 2]) -> [f64; 2]| {
            found.iter().zip(corners).all(|(found, corner)| {
                let expected = expected(corner);
                (0..2).all(|axis| (found[axis] - expected[axis]).abs() < 1e-9)
            })
        };
        let [x, y] = ellipse.center;
        let moved = after(Ellipse { center: [x + 5.0, y - 3.0], ..ellipse });
        assert!(near(&moved, &|[u, v]| [u + 5.0, v - 3.0]), "{moved:?}");
        let larger = after(Ellipse { radii: ellipse.radii.map(|r| 2.0 * r), ..ellipse });
        assert!(near(&larger, &|[u, v]| [x + 2.0 * (u - x), y + 2.0 * (v - y)]), "{larger:?}");
        let turned = after(Ellipse { angle: ellipse.angle + 90.0, ..ellipse });
        assert!(near(&turned, &|[u, v]| [x - (v - y), y + (u - x)]), "{turned:?}");
        // The ellipse of before with its axes exchanged.
        let [r, q] = ellipse.radii;
        let same = after(Ellipse { radii: [q, r], angle: ellipse.angle - 90.0, ..ellipse });
        assert!(near(&same, &|at| at), "{same:?}");
    }
}
