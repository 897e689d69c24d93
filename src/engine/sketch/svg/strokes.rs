//! Paths of an SVG as polylines, px of the canvas.

use usvg::tiny_skia_path::{Path, PathSegment, Point, Transform};

/// Points along a curved segment.
const FINENESS: u16 = 32;

/// A stroke of a path, px of the canvas.
pub(super) struct Drawn {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) closed: bool,
}

/// The strokes of a path, curves as polylines.
pub(super) fn strokes(path: &Path, transform: Transform, scale: f64) -> Vec<Drawn> {
    let place = |point: Point| {
        let mut point = point;
        transform.map_point(&mut point);
        [f64::from(point.x) * scale, f64::from(point.y) * scale]
    };
    let mut strokes: Vec<Drawn> = Vec::new();
    for segment in path.segments() {
        if let PathSegment::MoveTo(point) = segment {
            strokes.push(Drawn { points: vec![place(point)], closed: false });
            continue;
        }
        let Some(stroke) = strokes.last_mut() else { continue };
        let from = *stroke.points.last().unwrap_or(&[0.0; 2]);
        match segment {
            PathSegment::LineTo(point) => stroke.points.push(place(point)),
            // A quadratic curve is the cubic with handles two thirds of the way to its own.
            PathSegment::QuadTo(a, end) => {
                let (a, end) = (place(a), place(end));
                let near = |p: [f64; 2]| [0, 1].map(|axis| p[axis] + 2.0 / 3.0 * (a[axis] - p[axis]));
                curve([from, near(from), near(end), end], &mut stroke.points);
            }
            PathSegment::CubicTo(a, b, end) => {
                curve([from, place(a), place(b), place(end)], &mut stroke.points);
            }
            PathSegment::Close => stroke.closed = true,
            PathSegment::MoveTo(_) => {}
        }
    }
    strokes.retain(|stroke| stroke.points.len() > 1 && stroke.points.iter().flatten().all(|c| c.is_finite()));
    for stroke in &mut strokes {
        let (first, last) = (stroke.points[0], stroke.points[stroke.points.len() - 1]);
        if stroke.closed && first != last {
            stroke.points.push(first);
        }
        stroke.closed |= stroke.points.len() > 3 && first == last;
    }
    strokes
}

fn curve([p0, p1, p2, p3]: [[f64; 2]; 4], points: &mut Vec<[f64; 2]>) {
    for i in 1..=FINENESS {
        let t = f64::from(i) / f64::from(FINENESS);
        let s = 1.0 - t;
        let [a, b, c, d] = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        points.push([0, 1].map(|axis| a * p0[axis] + b * p1[axis] + c * p2[axis] + d * p3[axis]));
    }
}

/// Whether a point lies in a polygon, by how often a line from it to the right crosses the sides.
pub(super) fn encloses(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |pair: &&[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]];
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    polygon.windows(2).filter(crosses).count() % 2 == 1
}
