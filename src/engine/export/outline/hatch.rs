//! Shapes → parallel strokes that fill them.

use super::Shape;
use super::path::stroke;
use super::pen_ends::PenEnds;
use kurbo::common::solve_quadratic;
use kurbo::{Affine, BezPath, ParamCurve, ParamCurveDeriv, PathSeg, Point};
use std::collections::BTreeMap;

/// Parallel strokes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// Distance between them, px; above 0.
    pub spacing: f64,
    /// Their direction, degrees from x towards y.
    pub angle: f64,
}

impl Hatch {
    /// Smallest spacing, px: a finer hatch would be a filled area.
    pub const FINEST: f64 = 0.1;

    /// The nearest hatch that continues across the seams of a tile of `size` px. With spacing s and angle α, the lines
    /// y cos α − x sin α = (k + ½)s meet themselves across the seams if m = width·sin α/s and n = height·cos α/s are integers.
    /// The spacing changes by about s/(2·side) at most, and the angle by as many radians.
    #[must_use]
    pub fn seamless(self, [width, height]: [f64; 2]) -> Self {
        let radians = self.angle.to_radians();
        let exact = [width * libm::sin(radians), height * libm::cos(radians)].map(|side| side / self.spacing);
        let mut whole = exact.map(f64::round);
        if whole == [0.0, 0.0] {
            // At least one line a tile.
            let larger = usize::from(exact[1].abs() >= exact[0].abs());
            whole[larger] = 1.0_f64.copysign(exact[larger]);
        }
        let [a, b] = [whole[0] / width, whole[1] / height];
        Self { spacing: 1.0 / (a * a + b * b).sqrt(), angle: libm::atan2(a, b).to_degrees() }
    }
}

/// Strokes shorter than this share of the spacing are left out: they would be dots.
const SHORTEST: f64 = 0.05;
/// Number of bisections that find a crossing, to 2⁻⁴⁰ of a segment.
const HALVINGS: usize = 40;

/// A crossing of a line and an outline.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    /// Place along the line.
    u: f64,
    /// du ÷ dv of the outline there: v is the coordinate across the lines.
    slope: f64,
}

/// The strokes of a shape: the parts inside it of parallel lines `spacing` apart. The lines are counted from the canvas' corner, so
/// the strokes of all shapes are aligned. With a `pen` of width 0 they end on the Beziers themselves. A wider pen (px) has round
/// ends; its strokes end before the Beziers, so that the area drawn outside of the shape equals the area left free inside.
#[must_use]
pub fn hatch(shape: &Shape, hatch: Hatch, pen: f64) -> Vec<BezPath> {
    let (sin, cos) = (libm::sin(hatch.angle.to_radians()), libm::cos(hatch.angle.to_radians()));
    // Coordinates (u, v) in which the lines run along u, at v = (k + ½)·spacing.
    let turned = Affine::new([cos, -sin, sin, cos, 0.0, 0.0]);
    let mut crossings: BTreeMap<i64, Vec<Crossing>> = BTreeMap::new();
    for segment in shape.paths().flat_map(BezPath::segments) {
        cross(&(turned * segment), hatch.spacing, &mut crossings);
    }
    let ends = PenEnds { pen, spacing: hatch.spacing };
    let mut strokes = Vec::new();
    let mut longest: Option<([f64; 2], f64)> = None;
    for (line, mut along) in crossings {
        along.sort_by(|a, b| a.u.total_cmp(&b.u));
        let v = (line as f64 + 0.5) * hatch.spacing;
        for pair in along.chunks_exact(2) {
            let part = [pair[0].u, pair[1].u];
            if part[1] - part[0] <= SHORTEST * hatch.spacing {
                continue;
            }
            let drawn = ends.drawn(part, [pair[0].slope, pair[1].slope]);
            strokes.extend(drawn.map(|part| (part, v)));
            if longest.is_none_or(|([from, to], _)| part[1] - part[0] > to - from) {
                longest = Some((part, v));
            }
        }
    }
    if strokes.is_empty() {
        // A shape that is thinner than the pen is a dot.
        strokes.extend(longest.map(|(part, v)| (ends.dot(part), v)));
    }
    let back = |u: f64, v: f64| Point::new(u * cos - v * sin, u * sin + v * cos);
    strokes.into_iter().map(|([from, to], v)| stroke(back(from, v), back(to, v))).collect()
}

/// Adds the places where a segment crosses the lines. The segment is split at the extrema of v; each part crosses a line once if
/// its ends are on different sides of it. An end on the line counts as above it. Therefore a closed path crosses each line an even
/// number of times, even if it only touches it.
fn cross(segment: &PathSeg, spacing: f64, crossings: &mut BTreeMap<i64, Vec<Crossing>>) {
    let mut parts = vec![0.0];
    parts.extend(turns(segment));
    parts.push(1.0);
    // Exact ends, which neighbouring segments share.
    let point = |t: f64| match t {
        0.0 => segment.start(),
        1.0 => segment.end(),
        t => segment.eval(t),
    };
    for pair in parts.windows(2) {
        let (low, high) = (point(pair[0]), point(pair[1]));
        let first = |v: f64| (v / spacing - 0.5).ceil() as i64;
        let (from, to) = (first(low.y), first(high.y));
        for line in from.min(to)..from.max(to) {
            let v = (line as f64 + 0.5) * spacing;
            let t = t_at(point, [pair[0], pair[1]], low.y < high.y, v);
            let along = segment.to_cubic().deriv().eval(t).to_vec2();
            let slope = if along.y == 0.0 { 0.0 } else { along.x / along.y };
            crossings.entry(line).or_default().push(Crossing { u: point(t).x, slope });
        }
    }
}

/// The parameters, ascending, of the extrema of v: B′(t) = 0.
fn turns(segment: &PathSeg) -> Vec<f64> {
    let PathSeg::Cubic(cubic) = segment else { return Vec::new() };
    let [a, b, c] = {
        let slope = cubic.deriv();
        [slope.p0.y, slope.p1.y, slope.p2.y]
    };
    let mut turns = solve_quadratic(a, 2.0 * (b - a), a - 2.0 * b + c).to_vec();
    turns.retain(|t| *t > 0.0 && *t < 1.0);
    turns.sort_by(f64::total_cmp);
    turns.dedup();
    turns
}

/// The parameter between two others at which a segment reaches `v`.
fn t_at(point: impl Fn(f64) -> Point, [mut low, mut high]: [f64; 2], rises: bool, v: f64) -> f64 {
    for _ in 0..HALVINGS {
        let midpoint = 0.5 * (low + high);
        if (point(midpoint).y < v) == rises {
            low = midpoint;
        } else {
            high = midpoint;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::outline::path::{end, start};
    use kurbo::{Circle, ParamCurveNearest, PathEl, Shape as _};

    fn ring(corners: &[[f64; 2]]) -> BezPath {
        let at = |corner: &[f64; 2]| Point::new(corner[0], corner[1]);
        let mut path = vec![PathEl::MoveTo(at(&corners[0]))];
        path.extend(corners[1..].iter().chain(&corners[..1]).map(|corner| PathEl::LineTo(at(corner))));
        path.push(PathEl::ClosePath);
        BezPath::from_vec(path)
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> BezPath {
        stroke(Point::new(from[0], from[1]), Point::new(to[0], to[1]))
    }

    #[test]
    fn a_square_with_a_hole_is_hatched_around_it() {
        let outer = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
        let hole = ring(&[[4.0, 4.0], [4.0, 6.0], [6.0, 6.0], [6.0, 4.0]]);
        let strokes = hatch(&Shape { outer, holes: vec![hole] }, Hatch { spacing: 1.0, angle: 0.0 }, 0.0);
        assert_eq!(strokes.len(), 12);
        assert_eq!(strokes[0], line([0.0, 0.5], [10.0, 0.5]));
        let ends = [[4.0, 4.5], [6.0, 4.5]];
        assert!(strokes.contains(&line([0.0, 4.5], ends[0])));
        assert!(strokes.contains(&line(ends[1], [10.0, 4.5])));
    }

    #[test]
    fn a_seamless_hatch_is_near_the_given_one_and_meets_itself_across_the_seams() {
        let size = [200.0, 130.0];
        for asked in [(1.0, 0.0), (1.3, 45.0), (0.7, -100.0), (3.0, 90.0), (3.0, 359.0), (2.2, 178.0)] {
            let asked = Hatch { spacing: asked.0, angle: asked.1 };
            let found = asked.seamless(size);
            let [sin, cos] = [found.angle.to_radians().sin(), found.angle.to_radians().cos()];
            for lines in [size[0] * sin / found.spacing, size[1] * cos / found.spacing] {
                assert!((lines - lines.round()).abs() < 1e-9, "{asked:?} {found:?}");
            }
            let turned = (found.angle - asked.angle + 180.0).rem_euclid(360.0) - 180.0;
            let most = asked.spacing / size[1];
            assert!((found.spacing / asked.spacing - 1.0).abs() < most, "{asked:?} {found:?}");
            assert!(turned.abs().to_radians() < most, "{asked:?} {found:?}");
        }
        // Wider than the tile.
        let one = Hatch { spacing: 900.0, angle: 90.0 }.seamless(size);
        assert!((one.spacing - 200.0).abs() < 1e-9 && (one.angle - 90.0).abs() < 1e-9, "{one:?}");
    }

    #[test]
    fn lines_through_corners_and_along_sides_cover_the_whole_area() {
        // Sides lie on lines, and lines go through the corners.
        let outer = ring(&[[0.5, 0.5], [5.5, 0.5], [5.5, 5.5], [3.0, 2.5], [0.5, 5.5]]);
        for angle in [0.0, 45.0, 90.0, 180.0, 270.0, -1e6] {
            let area: f64 = outer.area();
            let strokes =
                hatch(&Shape { outer: outer.clone(), holes: vec![] }, Hatch { spacing: 0.01, angle }, 0.0);
            let covered: f64 = strokes.iter().map(|path| start(path).distance(end(path)) * 0.01).sum();
            assert!((covered / area - 1.0).abs() < 0.01, "{angle}: {covered} of {area}");
        }
    }

    #[test]
    fn a_wide_pen_draws_the_area_of_the_shape() {
        // A disc and a slanting bar: the area within half a pen of the strokes, counted on a fine grid.
        let disc = Circle::new(Point::new(10.0, 10.0), 8.0).to_path(1e-6);
        let bar = ring(&[[2.0, 2.0], [4.0, 2.0], [17.0, 16.0], [15.0, 16.0]]);
        for (outer, angle) in [(&disc, 20.0), (&bar, 0.0), (&bar, 90.0), (&bar, 45.0 + 80.0)] {
            let pen = 0.6;
            let strokes =
                hatch(&Shape { outer: outer.clone(), holes: vec![] }, Hatch { spacing: 0.5, angle }, pen);
            let is_drawn = |at: Point| {
                strokes.iter().any(|path| {
                    let line = kurbo::Line::new(start(path), end(path));
                    line.nearest(at, 1e-9).distance_sq <= 0.25 * pen * pen
                })
            };
            let cells = (0..400 * 400).map(|k| Point::new(0.05 * (k % 400) as f64, 0.05 * (k / 400) as f64));
            let drawn = cells.filter(|at| is_drawn(*at)).count() as f64 * 0.05 * 0.05;
            let area = outer.area().abs();
            assert!((drawn / area - 1.0).abs() < 0.03, "{angle}: {drawn} of {area}");
        }
    }

    #[test]
    fn a_shape_that_is_thinner_than_the_pen_is_a_dot() {
        let outer = Circle::new(Point::new(10.0, 10.25), 0.12).to_path(1e-6);
        let strokes = hatch(&Shape { outer, holes: vec![] }, Hatch { spacing: 0.5, angle: 0.0 }, 0.8);
        assert_eq!(strokes.len(), 1);
    }

    #[test]
    fn strokes_end_on_the_curve() {
        let outer = Circle::new(Point::ORIGIN, 10.0).to_path(1e-6);
        let strokes = hatch(&Shape { outer, holes: vec![] }, Hatch { spacing: 0.7, angle: 33.0 }, 0.0);
        assert_eq!(strokes.len(), 28);
        for stroke in strokes {
            for end in [start(&stroke), end(&stroke)] {
                assert!((end.distance(Point::ORIGIN) - 10.0).abs() < 0.003, "{end:?}");
            }
        }
    }
}
