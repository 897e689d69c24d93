//! Points on a smooth line → cubic Beziers.
//!
//! Between two points whose tangents t̂₁, t̂₂ are known, the handles p₀ + α₁t̂₁ and p₃ + α₂t̂₂ are those with the least
//! squared distance to the points between, whose parameters then move to the nearest places on the curve; where that
//! leaves a point too far off, the line is parted there. Schneider, "An algorithm for automatically fitting digitized
//! curves", Graphics Gems (1990).

use super::path::{Path, Piece, borders, cubic, distance};

/// Most points that one cubic is fitted to: no cubic follows more than a turn or so, and trying costs.
const MOST: usize = 48;
/// Times that the parameters are moved.
const MOVES: usize = 3;

type P = [f64; 2];

/// The closed path through the points of a ring on a canvas of `size` px, off by at most `tolerance` px; what lies
/// on the border is straight.
#[must_use]
pub fn ring(points: &[P], size: [f64; 2], tolerance: f64) -> Path {
    let n = points.len();
    let along = |i: usize| borders(points[i % n], size) & borders(points[(i + 1) % n], size) != 0;
    let Some(first) = (0..n).find(|i| along(*i) && !along(i + 1)) else {
        return if n > 0 && along(0) { straight(points, size) } else { around(points, tolerance) };
    };
    // From where it leaves the border, round to there.
    let mut path = Path { start: points[(first + 1) % n], pieces: Vec::new(), closed: true };
    let mut i = first + 1;
    while i < first + 1 + n {
        let run = along(i);
        let from = i;
        while i < first + 1 + n && along(i) == run {
            i += 1;
        }
        let points: Vec<P> = (from..=i).map(|i| points[i % n]).collect();
        if run {
            border(&points, size, &mut path.pieces);
        } else {
            open(&points, tolerance, &mut path.pieces);
        }
    }
    path
}

/// A ring that never leaves the border: the frame of the canvas.
fn straight(points: &[P], size: [f64; 2]) -> Path {
    let corner = |point: &P| borders(*point, size).count_ones() > 1;
    let first = points.iter().position(corner).unwrap_or(0);
    let mut turned = points.to_vec();
    turned.rotate_left(first);
    turned.push(turned[0]);
    let mut path = Path { start: turned[0], pieces: Vec::new(), closed: true };
    border(&turned, size, &mut path.pieces);
    path
}

/// Straight lines along the border, from corner to corner.
fn border(points: &[P], size: [f64; 2], pieces: &mut Vec<Piece>) {
    for (i, point) in points.iter().enumerate().skip(1) {
        if i + 1 == points.len() || borders(*point, size).count_ones() > 1 {
            pieces.push(Piece::Line(*point));
        }
    }
}

/// A smooth closed path.
fn around(points: &[P], tolerance: f64) -> Path {
    let n = points.len();
    let chunks = n.div_ceil(MOST).max(2);
    let tangent = |i: usize| tangent(points[(i + n - 1) % n], points[i % n], points[(i + 1) % n]);
    let wide = |i: usize| {
        let reach = if n >= 12 { 2 } else { 1 };
        self::tangent(points[(i + n - reach) % n], points[i % n], points[(i + reach) % n])
    };
    let knot = |chunk: usize| chunk * n / chunks;
    let mut path = Path { start: points[0], pieces: Vec::new(), closed: true };
    for chunk in 0..chunks {
        let (from, to) = (knot(chunk), knot(chunk + 1));
        if from == to {
            continue;
        }
        let span: Vec<P> = (from..=to).map(|i| points[i % n]).collect();
        let ends = if n >= 6 { [wide(from), wide(to)] } else { [tangent(from), tangent(to)] };
        split(&span, ends, tolerance, &mut path.pieces);
    }
    path
}

/// A smooth path from the first point to the last.
fn open(points: &[P], tolerance: f64, pieces: &mut Vec<Piece>) {
    let last = points.len() - 1;
    let chunks = last.div_ceil(MOST).max(1);
    let knot = |chunk: usize| chunk * last / chunks;
    let direction = |i: usize| match i {
        0 => end_tangent(points, [0, 1, 2]),
        i if i == last => {
            end_tangent(points, [last, last.saturating_sub(1), last.saturating_sub(2)]).map(|t| -t)
        }
        i => tangent(points[i.saturating_sub(2)], points[i], points[(i + 2).min(last)]),
    };
    for chunk in 0..chunks {
        let (from, to) = (knot(chunk), knot(chunk + 1));
        split(&points[from..=to], [direction(from), direction(to)], tolerance, pieces);
    }
}

/// The direction at the first of three points, towards the second: that of the parabola through them.
fn end_tangent(points: &[P], [a, b, c]: [usize; 3]) -> P {
    let last = points.len() - 1;
    let (a, b, c) = (points[a], points[b.min(last)], points[c.min(last)]);
    let (g, h) = (distance(a, b), distance(b, c));
    if g <= 0.0 || h <= 0.0 {
        return unit([b[0] - a[0], b[1] - a[1]]);
    }
    let there = [0, 1].map(|axis| {
        let (d, e) = ((b[axis] - a[axis]) / g, (c[axis] - b[axis]) / h);
        d - (e - d) * g / (g + h)
    });
    unit(there)
}

/// The direction at the middle one of three points: that of the parabola through them.
fn tangent(before: P, at: P, after: P) -> P {
    let (g, h) = (distance(before, at), distance(at, after));
    if g <= 0.0 || h <= 0.0 {
        return unit([after[0] - before[0], after[1] - before[1]]);
    }
    unit([0, 1].map(|axis| (at[axis] - before[axis]) / g * h + (after[axis] - at[axis]) / h * g))
}

fn unit(v: P) -> P {
    let length = distance([0.0, 0.0], v);
    if length > 0.0 { v.map(|part| part / length) } else { [0.0, 0.0] }
}

/// Fits one cubic, or parts the points where it is off most.
fn split(points: &[P], tangents: [P; 2], tolerance: f64, pieces: &mut Vec<Piece>) {
    let mut spans = vec![(0, points.len() - 1, tangents)];
    while let Some((from, to, [begin, end])) = spans.pop() {
        let span = &points[from..=to];
        let (fitted, worst, off) = fit(span, begin, end);
        if off <= tolerance || span.len() <= 3 {
            pieces.push(Piece::Cubic([fitted[1], fitted[2], fitted[3]]));
            continue;
        }
        // Not at the very ends, where the tangents of both halves would be one.
        let middle = from + worst.clamp(1, span.len() - 2);
        let reach = (middle - from).min(to - middle).min(2);
        let through = tangent(points[middle - reach], points[middle], points[middle + reach]);
        spans.push((middle, to, [through, end]));
        spans.push((from, middle, [begin, through]));
    }
}

/// The cubic, which of the points it misses most, and by how much.
fn fit(points: &[P], begin: P, end: P) -> ([P; 4], usize, f64) {
    let mut t = vec![0.0];
    for pair in points.windows(2) {
        t.push(t[t.len() - 1] + distance(pair[0], pair[1]));
    }
    let whole = t[t.len() - 1];
    t.iter_mut().for_each(|t| *t /= if whole > 0.0 { whole } else { 1.0 });
    let mut fitted = least_squares(points, &t, begin, end, whole);
    let mut found = farthest(points, &t, fitted);
    for _ in 0..MOVES {
        let moved: Vec<f64> = points.iter().zip(&t).map(|(point, t)| nearer(fitted, *point, *t)).collect();
        let refitted = least_squares(points, &moved, begin, end, whole);
        let next = farthest(points, &moved, refitted);
        if next.1 >= found.1 {
            break;
        }
        (fitted, found, t) = (refitted, next, moved);
    }
    (fitted, found.0, found.1)
}

/// The α₁ and α₂ with the least squared distances; a third of the length where these lead nowhere.
fn least_squares(points: &[P], t: &[f64], begin: P, end: P, length: f64) -> [P; 4] {
    let (first, last) = (points[0], points[points.len() - 1]);
    let (mut c00, mut c01, mut c11, mut x0, mut x1) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let dot = |a: P, b: P| a[0] * b[0] + a[1] * b[1];
    for (point, &t) in points.iter().zip(t) {
        let s = 1.0 - t;
        let [b0, b1, b2, b3] = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        let (a0, a1) = (begin.map(|part| part * b1), end.map(|part| -part * b2));
        let left = [0, 1].map(|axis| point[axis] - first[axis] * (b0 + b1) - last[axis] * (b2 + b3));
        c00 += dot(a0, a0);
        c01 += dot(a0, a1);
        c11 += dot(a1, a1);
        x0 += dot(a0, left);
        x1 += dot(a1, left);
    }
    let determinant = c00 * c11 - c01 * c01;
    let solved = [(x0 * c11 - x1 * c01) / determinant, (x1 * c00 - x0 * c01) / determinant];
    // Handles that turn back or shoot over make loops.
    let sound = solved.iter().all(|alpha| *alpha > 1e-3 * length && *alpha < length);
    let [a, b] = if sound { solved } else { [length / 3.0; 2] };
    let handle = |from: P, way: P, by: f64| [0, 1].map(|axis| from[axis] + by * way[axis]);
    [first, handle(first, begin, a), handle(last, end, -b), last]
}

/// One step of Newton's method towards the parameter where the curve is nearest to a point.
fn nearer(p: [P; 4], point: P, t: f64) -> f64 {
    let s = 1.0 - t;
    let step = |i: usize, axis: usize| p[i + 1][axis] - p[i][axis];
    let at = cubic(p, t);
    let (mut up, mut down) = (0.0, 0.0);
    for axis in 0..2 {
        let away = at[axis] - point[axis];
        let d = 3.0 * (s * s * step(0, axis) + 2.0 * s * t * step(1, axis) + t * t * step(2, axis));
        let dd = 6.0 * (s * (step(1, axis) - step(0, axis)) + t * (step(2, axis) - step(1, axis)));
        up += away * d;
        down += d * d + away * dd;
    }
    let moved = t - up / down;
    if moved.is_finite() { moved.clamp(0.0, 1.0) } else { t }
}

fn farthest(points: &[P], t: &[f64], p: [P; 4]) -> (usize, f64) {
    let mut worst = (0, 0.0);
    for (i, (point, t)) in points.iter().zip(t).enumerate() {
        let off = distance(cubic(p, *t), *point);
        if off > worst.1 {
            worst = (i, off);
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(n: usize, at: impl Fn(f64) -> P) -> Vec<P> {
        (0..n).map(|i| at(std::f64::consts::TAU * i as f64 / n as f64)).collect()
    }

    #[test]
    fn a_circle_becomes_a_few_cubics_that_follow_it() {
        for (radius, n) in [(1.0, 8), (5.0, 40), (30.0, 250)] {
            let points = points(n, |a| [50.0 + radius * libm::cos(a), 50.0 + radius * libm::sin(a)]);
            let path = ring(&points, [100.0, 100.0], 0.04);
            let area = std::f64::consts::PI * radius * radius;
            let off = path.area() / area - 1.0;
            assert!(off.abs() < 0.008 / radius, "{radius}: {off}");
            assert!(path.pieces.len() <= 8, "{radius}: {} pieces", path.pieces.len());
            assert_eq!(path.end(), path.start);
        }
    }

    #[test]
    fn pieces_meet_without_a_kink() {
        let points = points(400, |a| {
            let r = 30.0 + 6.0 * libm::sin(5.0 * a);
            [50.0 + r * libm::cos(a), 50.0 + r * libm::sin(a)]
        });
        let path = ring(&points, [100.0, 100.0], 0.04);
        let steps: Vec<(P, Piece)> = path.steps().collect();
        for i in 0..steps.len() {
            let (Piece::Cubic([_, b, end]), Piece::Cubic([a, ..])) =
                (steps[i].1, steps[(i + 1) % steps.len()].1)
            else {
                panic!("a line in a smooth path");
            };
            let (into, out) = (unit([end[0] - b[0], end[1] - b[1]]), unit([a[0] - end[0], a[1] - end[1]]));
            assert!(into[0] * out[0] + into[1] * out[1] > 0.9999, "{into:?} {out:?}");
        }
        for point in &points {
            let off = path.flat(1e-5).iter().map(|near| distance(*near, *point)).fold(f64::MAX, f64::min);
            assert!(off < 0.06, "{off}");
        }
    }

    #[test]
    fn a_few_points_in_one_place_are_no_trouble() {
        for n in 3..8 {
            let path = ring(&vec![[5.0, 5.0]; n], [10.0, 10.0], 0.04);
            assert!(path.flat(0.1).iter().flatten().all(|number| number.is_finite()));
        }
        let diamond = [[5.0, 4.5], [5.5, 5.0], [5.0, 5.5], [4.5, 5.0]];
        let path = ring(&diamond, [10.0, 10.0], 0.04);
        assert!((0.4..0.9).contains(&path.area()), "{}", path.area());
    }
}
