//! Whether any part of a mark lies on a canvas, the rectangle from (0, 0) to its size.

use super::{Ellipse, Mark, Path, distance_to_segment};

impl Mark {
    /// Whether any part of it lies on a canvas of `size` px: of a line or path as wide as it is, with round ends.
    #[must_use]
    pub fn is_on(&self, size: [f64; 2]) -> bool {
        match self {
            Self::Ellipse(ellipse) => ellipse_is_on(ellipse, size),
            Self::Line(line) => path_is_on(&Path::from(*line), size),
            Self::Path(path) => path_is_on(path, size),
        }
    }
}

/// Seen from the ellipse as the unit circle, the canvas is a parallelogram.
fn ellipse_is_on(ellipse: &Ellipse, size: [f64; 2]) -> bool {
    if holds(size, ellipse.center) {
        return true;
    }
    let (s, c) = libm::sincos(ellipse.angle.to_radians());
    let seen = |corner: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| corner[axis] - ellipse.center[axis]);
        [(c * x + s * y) / ellipse.radii[0], (c * y - s * x) / ellipse.radii[1]]
    };
    sides(size).iter().any(|side| distance_to_segment([0.0; 2], side.map(seen)) < 1.0)
}

fn path_is_on(path: &Path, size: [f64; 2]) -> bool {
    path.points.windows(2).any(|pair| distance_from([pair[0], pair[1]], size) < 0.5 * path.width)
}

/// Whether any part of a closed polygon lies on a canvas of `size` px; its last corner is joined to the first.
#[must_use]
pub fn polygon_is_on(corners: &[[f64; 2]], size: [f64; 2]) -> bool {
    let side = |k: usize| [corners[k], corners[(k + 1) % corners.len()]];
    let crosses = |[a, b]: [[f64; 2]; 2]| {
        // The canvas lies inside where a ray from its corner crosses an odd number of sides.
        (a[1] > 0.0) != (b[1] > 0.0) && 0.0 < a[0] - a[1] / (b[1] - a[1]) * (b[0] - a[0])
    };
    let all = 0..corners.len();
    all.clone().any(|k| enters(side(k), size)) || all.filter(|k| crosses(side(*k))).count() % 2 == 1
}

/// Whether a point lies on the canvas or its border.
fn holds(size: [f64; 2], point: [f64; 2]) -> bool {
    (0..2).all(|axis| (0.0..=size[axis]).contains(&point[axis]))
}

/// The sides of the canvas.
fn sides([x, y]: [f64; 2]) -> [[[f64; 2]; 2]; 4] {
    let corners = [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]];
    [0, 1, 2, 3].map(|k| [corners[k], corners[(k + 1) % 4]])
}

/// The distance of a segment from the canvas, px; 0 where they meet.
fn distance_from(segment: [[f64; 2]; 2], size: [f64; 2]) -> f64 {
    if enters(segment, size) {
        return 0.0;
    }
    // Then the ends and the corners are the nearest points of the two.
    let of_end = |end: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| end[axis] - end[axis].clamp(0.0, size[axis]));
        libm::hypot(x, y)
    };
    let corners = sides(size).map(|side| distance_to_segment(side[0], segment));
    corners.into_iter().chain(segment.map(of_end)).fold(f64::INFINITY, f64::min)
}

/// Whether a segment and the canvas have a point in common (Liang and Barsky, "A new concept and method for line clipping", ACM
/// Transactions on Graphics 3(1), 1984).
fn enters([from, to]: [[f64; 2]; 2], size: [f64; 2]) -> bool {
    let mut inside = [0.0_f64, 1.0_f64];
    for axis in 0..2 {
        let way = to[axis] - from[axis];
        if way == 0.0 {
            if !(0.0..=size[axis]).contains(&from[axis]) {
                return false;
            }
            continue;
        }
        let [a, b] = [-from[axis] / way, (size[axis] - from[axis]) / way];
        inside = [inside[0].max(a.min(b)), inside[1].min(a.max(b))];
    }
    inside[0] <= inside[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::Line;

    const CANVAS: [f64; 2] = [100.0, 60.0];

    fn ellipse(center: [f64; 2], angle: f64) -> Mark {
        Mark::Ellipse(Ellipse { center, radii: [20.0, 5.0], angle })
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> Mark {
        Mark::Line(Line { from, to, width: 8.0 })
    }

    #[test]
    fn an_ellipse_is_on_the_canvas_as_far_as_it_reaches_that_way() {
        for (center, angle, on) in [
            ([-19.9, 30.0], 0.0, true),
            ([-20.1, 30.0], 0.0, false),
            ([-5.1, 30.0], 90.0, false),
            ([50.0, 64.9], 0.0, true),
            // Beyond a corner: its box touches the canvas, it does not.
            ([-13.0, -13.0], 135.0, false),
            ([-13.0, -13.0], 45.0, true),
            ([100.0, 60.0], 10.0, true),
        ] {
            assert_eq!(ellipse(center, angle).is_on(CANVAS), on, "{center:?} {angle}");
        }
        // One that is larger than the canvas and has its centre beyond it.
        let large = Mark::Ellipse(Ellipse { center: [-80.0, 30.0], radii: [300.0, 300.0], angle: 0.0 });
        assert!(large.is_on(CANVAS));
    }

    #[test]
    fn a_line_is_on_the_canvas_as_wide_as_it_is() {
        assert!(line([-40.0, -3.9], [140.0, -3.9]).is_on(CANVAS));
        assert!(!line([-40.0, -4.1], [140.0, -4.1]).is_on(CANVAS));
        // Across a corner, and past it.
        assert!(line([-9.0, 12.0], [12.0, -9.0]).is_on(CANVAS));
        assert!(!line([-30.0, 12.0], [12.0, -30.0]).is_on(CANVAS));
        let hook = Path { points: vec![[-50.0, -50.0], [-50.0, 30.0], [1.0, 30.0]], width: 2.0 };
        assert!(Mark::Path(hook.clone()).is_on(CANVAS));
        assert!(!Mark::Path(hook.shifted([-3.0, 0.0])).is_on(CANVAS));
    }

    #[test]
    fn a_polygon_is_on_the_canvas_also_where_no_side_of_it_is() {
        let square = |from: f64, to: f64| [[from, from], [to, from], [to, to], [from, to]];
        assert!(polygon_is_on(&square(-10.0, 200.0), CANVAS));
        assert!(polygon_is_on(&square(-10.0, 1.0), CANVAS));
        assert!(polygon_is_on(&square(20.0, 30.0), CANVAS));
        assert!(!polygon_is_on(&square(-10.0, -1.0), CANVAS));
        // A frame about two sides of the canvas.
        let frame = [[-9.0, -9.0], [200.0, -9.0], [200.0, -5.0], [-5.0, -5.0], [-5.0, 200.0], [-9.0, 200.0]];
        assert!(!polygon_is_on(&frame, CANVAS));
    }
}
