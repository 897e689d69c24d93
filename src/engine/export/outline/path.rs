//! Functions for paths that kurbo does not have.
//!
//! A path here is one subpath: `MoveTo`, then lines and cubics, then `ClosePath` if it is closed. The last line or cubic of a
//! closed path ends at its start, so every segment is an element of the path. Lengths are px.

use kurbo::{BezPath, PathEl, PathSeg, Point};

/// A stroke from point to point.
#[must_use]
pub fn stroke(from: Point, to: Point) -> BezPath {
    BezPath::from_vec(vec![PathEl::MoveTo(from), PathEl::LineTo(to)])
}

/// Whether a path is closed.
#[must_use]
pub fn is_closed(path: &BezPath) -> bool {
    path.elements().last() == Some(&PathEl::ClosePath)
}

/// The start of a path; the origin for an empty one.
#[must_use]
pub fn start(path: &BezPath) -> Point {
    path.elements().first().and_then(PathEl::end_point).unwrap_or_default()
}

/// The end of a path; the origin for an empty one.
#[must_use]
pub fn end(path: &BezPath) -> Point {
    pieces(path).last().and_then(PathEl::end_point).unwrap_or_else(|| start(path))
}

/// The lines and cubics of a path.
#[must_use]
pub fn pieces(path: &BezPath) -> &[PathEl] {
    let elements = path.elements();
    let elements = elements.split_first().map_or(elements, |(_, rest)| rest);
    elements.strip_suffix(&[PathEl::ClosePath]).unwrap_or(elements)
}

/// Points along a path that lie at most about `tolerance` px from it; those of a closed path end at its start.
#[must_use]
pub fn flattened(path: &BezPath, tolerance: f64) -> Vec<Point> {
    let mut points = Vec::new();
    kurbo::flatten(path, tolerance, |element| points.extend(element.end_point()));
    points
}

/// A closed path that starts at the end of its `first` pieces.
#[must_use]
pub fn started_after(path: BezPath, first: usize) -> BezPath {
    let pieces = pieces(&path);
    let Some(start) = first.checked_sub(1).and_then(|last| pieces.get(last)?.end_point()) else {
        return path;
    };
    let mut elements = Vec::with_capacity(pieces.len() + 2);
    elements.push(PathEl::MoveTo(start));
    elements.extend_from_slice(&pieces[first..]);
    elements.extend_from_slice(&pieces[..first]);
    elements.push(PathEl::ClosePath);
    BezPath::from_vec(elements)
}

/// A closed path without the parts along the border of a canvas of `size` px: open strokes, or the path itself.
#[must_use]
pub fn cut(path: &BezPath, size: [f64; 2]) -> Vec<BezPath> {
    let segments: Vec<PathSeg> = path.segments().collect();
    let along: Vec<bool> = segments.iter().map(|segment| is_on_border(segment, size)).collect();
    let Some(first) = along.iter().position(|along| *along) else { return vec![path.clone()] };
    let mut strokes: Vec<BezPath> = Vec::new();
    let mut open = false;
    for i in (first..first + segments.len()).map(|i| i % segments.len()) {
        if along[i] {
            open = false;
            continue;
        }
        if !open {
            strokes.push(BezPath::from_vec(vec![PathEl::MoveTo(kurbo::ParamCurve::start(&segments[i]))]));
            open = true;
        }
        if let Some(stroke) = strokes.last_mut() {
            stroke.push(segments[i].as_path_el());
        }
    }
    strokes
}

/// Whether a segment is a straight line along the border of a canvas of `size` px.
#[must_use]
pub fn is_on_border(segment: &PathSeg, size: [f64; 2]) -> bool {
    matches!(segment, PathSeg::Line(line) if borders(line.p0, size) & borders(line.p1, size) != 0)
}

/// The borders of a canvas of `size` px on which a point lies: left 1, right 2, top 4, bottom 8.
#[must_use]
pub fn borders(Point { x, y }: Point, [width, height]: [f64; 2]) -> u8 {
    let on = [x <= 0.0, x >= width, y <= 0.0, y >= height];
    on.iter().enumerate().map(|(bit, on)| u8::from(*on) << bit).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{Circle, Shape};

    /// A circle about the origin.
    fn circle(radius: f64) -> BezPath {
        Circle::new(Point::ORIGIN, radius).to_path(1e-6)
    }

    #[test]
    fn a_closed_path_may_start_at_any_of_its_knots() {
        let circle = circle(10.0);
        let turned = started_after(circle.clone(), 2);
        assert_eq!(start(&turned), pieces(&circle)[1].end_point().unwrap());
        assert_eq!(start(&turned), end(&turned));
        assert!((turned.area() - circle.area()).abs() < 1e-9);
        assert_eq!(started_after(circle.clone(), 0), circle);
        assert_eq!(started_after(circle.clone(), 99), circle);
    }

    #[test]
    fn flattened_points_stay_within_the_tolerance() {
        for tolerance in [1.0, 0.1, 0.01] {
            let points = flattened(&circle(10.0), tolerance);
            assert_eq!(points.first(), points.last());
            for pair in points.windows(2) {
                let midpoint = pair[0].midpoint(pair[1]);
                assert!(midpoint.distance(Point::ORIGIN) > 9.99 - tolerance, "{tolerance}: {midpoint:?}");
            }
        }
    }

    #[test]
    fn parts_along_the_border_are_removed() {
        // A half circle at the left border of a canvas.
        let arc = PathEl::CurveTo((4.0, 2.0).into(), (4.0, 8.0).into(), (0.0, 8.0).into());
        let from = PathEl::MoveTo((0.0, 2.0).into());
        let path = BezPath::from_vec(vec![from, arc, PathEl::LineTo((0.0, 2.0).into()), PathEl::ClosePath]);
        assert_eq!(cut(&path, [20.0, 20.0]), [BezPath::from_vec(vec![from, arc])]);
        assert_eq!(cut(&circle(3.0), [50.0, 50.0]).len(), 1);
        let corners = [[20.0, 0.0], [20.0, 20.0], [0.0, 20.0], [0.0, 0.0]];
        let mut frame = vec![PathEl::MoveTo(Point::ORIGIN)];
        frame.extend(corners.map(|[x, y]| PathEl::LineTo(Point::new(x, y))));
        frame.push(PathEl::ClosePath);
        assert_eq!(cut(&BezPath::from_vec(frame), [20.0, 20.0]), []);
    }
}
