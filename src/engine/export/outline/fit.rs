//! Points on a smooth line → cubic Beziers, fitted by kurbo.
//!
//! A cubic Hermite spline is laid through the points, with the directions of parabolas through their neighbours. Then
//! [`kurbo::fit_to_bezpath`] replaces stretches of it by single cubics with the same area and first moment, so marks keep
//! their area. R. Levien, "Simplifying Bézier paths" (2023).

use kurbo::simplify::SimplifyBezPath;
use kurbo::{BezPath, PathEl, Point, Vec2};

use super::path::borders;

/// Number of points of a ring from which on a direction is computed over two points on each side, to average out the rounding of
/// single points.
const MANY: usize = 12;

/// The closed path through the points of a ring on a canvas of `size` px, within about `tolerance` px of them. Parts on the border
/// are straight.
#[must_use]
pub fn ring(points: &[Point], size: [f64; 2], tolerance: f64) -> BezPath {
    let n = points.len();
    let along = |i: usize| borders(points[i % n], size) & borders(points[(i + 1) % n], size) != 0;
    let Some(first) = (0..n).find(|i| along(*i) && !along(i + 1)) else {
        return if n > 0 && along(0) { frame(points, size) } else { closed_curve(points, tolerance) };
    };
    // Once around, starting where the ring leaves the border.
    let mut path = started_at(points[(first + 1) % n]);
    let mut i = first + 1;
    while i < first + 1 + n {
        let on_border = along(i);
        let from = i;
        while i < first + 1 + n && along(i) == on_border {
            i += 1;
        }
        let run: Vec<Point> = (from..=i).map(|i| points[i % n]).collect();
        if on_border {
            border(&run, size, &mut path);
        } else {
            curve(&run, &open_directions(&run), tolerance, &mut path);
        }
    }
    path.close_path();
    path
}

fn started_at(point: Point) -> BezPath {
    BezPath::from_vec(vec![PathEl::MoveTo(point)])
}

/// A ring that never leaves the border: the frame of the canvas.
fn frame(points: &[Point], size: [f64; 2]) -> BezPath {
    let corner = |point: &Point| borders(*point, size).count_ones() > 1;
    let first = points.iter().position(corner).unwrap_or(0);
    let mut ring = points.to_vec();
    ring.rotate_left(first);
    ring.push(ring[0]);
    let mut path = started_at(ring[0]);
    border(&ring, size, &mut path);
    path.close_path();
    path
}

/// Straight lines along the border, from corner to corner.
fn border(points: &[Point], size: [f64; 2], path: &mut BezPath) {
    for (i, point) in points.iter().enumerate().skip(1) {
        if i + 1 == points.len() || borders(*point, size).count_ones() > 1 {
            path.line_to(*point);
        }
    }
}

/// A smooth closed path.
fn closed_curve(points: &[Point], tolerance: f64) -> BezPath {
    let n = points.len();
    let reach = if n >= MANY { 2 } else { 1 };
    let direction = |i: usize| direction(points[(i + n - reach) % n], points[i % n], points[(i + reach) % n]);
    let directions: Vec<Vec2> = (0..=n).map(direction).collect();
    let ring: Vec<Point> = (0..=n).map(|i| points[i % n]).collect();
    let mut path = started_at(points[0]);
    curve(&ring, &directions, tolerance, &mut path);
    path.close_path();
    path
}

/// Adds a smooth curve through `points`, from the first to the last, with the given directions.
fn curve(points: &[Point], directions: &[Vec2], tolerance: f64, path: &mut BezPath) {
    let mut spline = started_at(points[0]);
    for (points, directions) in points.windows(2).zip(directions.windows(2)) {
        let third = points[0].distance(points[1]) / 3.0;
        spline.curve_to(points[0] + third * directions[0], points[1] - third * directions[1], points[1]);
    }
    let fitted = kurbo::fit_to_bezpath(&SimplifyBezPath::new(&spline), tolerance);
    path.extend(fitted.elements().iter().skip(1).copied());
    // Fitted ends are rounded; on the border, and where a ring is closed, they must be exact.
    let (last, end) = (path.elements_mut().last_mut(), points[points.len() - 1]);
    if let Some(PathEl::CurveTo(.., fitted)) = last {
        *fitted = end;
    }
}

/// The directions along points that do not form a ring.
fn open_directions(points: &[Point]) -> Vec<Vec2> {
    let last = points.len() - 1;
    let at = |i: usize| match i {
        0 => end_direction(points[0], points[1.min(last)], points[2.min(last)]),
        i if i == last => {
            -end_direction(points[last], points[last.saturating_sub(1)], points[last.saturating_sub(2)])
        }
        i => direction(points[i.saturating_sub(2)], points[i], points[(i + 2).min(last)]),
    };
    (0..=last).map(at).collect()
}

/// The direction at the first of three points, towards the second: the direction of the parabola through them.
fn end_direction(a: Point, b: Point, c: Point) -> Vec2 {
    let (g, h) = (a.distance(b), b.distance(c));
    if g <= 0.0 || h <= 0.0 {
        return unit(b - a);
    }
    let (d, e) = ((b - a) / g, (c - b) / h);
    unit(d - (e - d) * (g / (g + h)))
}

/// The direction at the middle one of three points: the direction of the parabola through them.
fn direction(before: Point, at: Point, after: Point) -> Vec2 {
    let (g, h) = (before.distance(at), at.distance(after));
    if g <= 0.0 || h <= 0.0 {
        return unit(after - before);
    }
    unit((at - before) * (h / g) + (after - at) * (g / h))
}

/// The vector of length 1 with this direction; zero stays zero.
fn unit(vector: Vec2) -> Vec2 {
    let length = vector.hypot();
    if length > 0.0 { vector / length } else { Vec2::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::outline::path::{end, pieces, start};
    use kurbo::{ParamCurveNearest, Shape};

    fn points(n: usize, at: impl Fn(f64) -> [f64; 2]) -> Vec<Point> {
        let point = |i| {
            let [x, y] = at(std::f64::consts::TAU * i as f64 / n as f64);
            Point::new(x, y)
        };
        (0..n).map(point).collect()
    }

    #[test]
    fn a_circle_becomes_a_few_cubics_that_follow_it() {
        for (radius, n) in [(1.0, 8), (5.0, 40), (30.0, 250)] {
            let points = points(n, |a| [50.0 + radius * libm::cos(a), 50.0 + radius * libm::sin(a)]);
            let path = ring(&points, [100.0, 100.0], 0.04);
            let area = std::f64::consts::PI * radius * radius;
            let off = path.area() / area - 1.0;
            assert!(off.abs() < 0.008 / radius, "{radius}: {off}");
            assert!(pieces(&path).len() <= 8, "{radius}: {} pieces", pieces(&path).len());
            assert_eq!(end(&path), start(&path));
        }
    }

    #[test]
    fn pieces_meet_without_a_kink() {
        let points = points(400, |a| {
            let r = 30.0 + 6.0 * libm::sin(5.0 * a);
            [50.0 + r * libm::cos(a), 50.0 + r * libm::sin(a)]
        });
        let path = ring(&points, [100.0, 100.0], 0.04);
        let cubics: Vec<[Point; 3]> = pieces(&path)
            .iter()
            .map(|piece| match piece {
                PathEl::CurveTo(a, b, end) => [*a, *b, *end],
                other => panic!("{other:?} in a smooth path"),
            })
            .collect();
        for (i, [_, b, end]) in cubics.iter().enumerate() {
            let [a, ..] = cubics[(i + 1) % cubics.len()];
            let (into, out) = (unit(*end - *b), unit(a - *end));
            assert!(into.dot(out) > 0.9999, "{into:?} {out:?}");
        }
        for point in &points {
            let off = path.segments().map(|segment| segment.nearest(*point, 1e-6).distance_sq.sqrt());
            let off = off.fold(f64::MAX, f64::min);
            assert!(off < 0.05, "{off}");
        }
    }

    #[test]
    fn a_few_points_in_one_place_give_a_finite_path() {
        for n in 3..8 {
            let path = ring(&vec![Point::new(5.0, 5.0); n], [10.0, 10.0], 0.04);
            assert!(path.is_finite());
        }
        let diamond = [(5.0, 4.5), (5.5, 5.0), (5.0, 5.5), (4.5, 5.0)].map(Point::from);
        let path = ring(&diamond, [10.0, 10.0], 0.04);
        assert!((0.4..0.9).contains(&path.area()), "{}", path.area());
    }
}
