//! Operations on a mark: move, turn, scale, hit test, keep within bounds.

use crate::document::limits::MIN_LENGTH;
use crate::marks::{Ellipse, Line, Mark, Path, distance_to_segment};

/// The smallest radius or width of a drawn mark, px.
pub const SMALLEST: f64 = 0.5;
/// Distance from the edge at which a centre beyond it is put, px: more than rounding, less than anyone sees.
const ROUNDING: f64 = 1e-9;

/// The centre of a mark, px.
#[must_use]
pub fn center(mark: &Mark) -> [f64; 2] {
    mark.center()
}

/// The mark moved by `by` px.
#[must_use]
pub fn moved(mark: &Mark, by: [f64; 2]) -> Mark {
    mark.shifted(by)
}

/// The mark turned by `degrees` around `pivot`.
#[must_use]
pub fn turned(mark: &Mark, degrees: f64, pivot: [f64; 2]) -> Mark {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let turn = |p: [f64; 2]| {
        let [x, y] = [p[0] - pivot[0], p[1] - pivot[1]];
        [pivot[0] + cos * x - sin * y, pivot[1] + sin * x + cos * y]
    };
    match mark {
        Mark::Ellipse(ellipse) => Mark::Ellipse(Ellipse {
            center: turn(ellipse.center),
            angle: (ellipse.angle + degrees).rem_euclid(180.0),
            ..*ellipse
        }),
        Mark::Line(line) => Mark::Line(Line { from: turn(line.from), to: turn(line.to), ..*line }),
        Mark::Path(path) => Mark::Path(path.with_points(turn)),
    }
}

/// The mark with all its lengths and its distance from `pivot` multiplied by `factor`.
#[must_use]
pub fn scaled(mark: &Mark, factor: f64, pivot: [f64; 2]) -> Mark {
    let place = |p: [f64; 2]| [0, 1].map(|axis| pivot[axis] + factor * (p[axis] - pivot[axis]));
    match mark {
        Mark::Ellipse(ellipse) => Mark::Ellipse(Ellipse {
            center: place(ellipse.center),
            radii: ellipse.radii.map(|radius| factor * radius),
            ..*ellipse
        }),
        Mark::Line(line) => {
            Mark::Line(Line { from: place(line.from), to: place(line.to), width: factor * line.width })
        }
        Mark::Path(path) => Mark::Path(Path { width: factor * path.width, ..path.with_points(place) }),
    }
}

/// A point in the frame of a mark with this centre and angle: coordinates along the angle and across it, px.
#[must_use]
pub fn into_frame(point: [f64; 2], center: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let [x, y] = [point[0] - center[0], point[1] - center[1]];
    [cos * x + sin * y, cos * y - sin * x]
}

/// The inverse of [`into_frame`].
#[must_use]
pub fn out_of_frame(point: [f64; 2], center: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [center[0] + cos * point[0] - sin * point[1], center[1] + sin * point[0] + cos * point[1]]
}

/// Distance of `point` from the area of the mark, px; 0 inside. Outside an ellipse it is measured along the ray from
/// its centre, which is exact enough for a pointer.
#[must_use]
pub fn distance(mark: &Mark, point: [f64; 2]) -> f64 {
    match mark {
        Mark::Ellipse(ellipse) => {
            let [x, y] = into_frame(point, ellipse.center, ellipse.angle);
            let share = (x / ellipse.radii[0]).hypot(y / ellipse.radii[1]);
            if share <= 1.0 { 0.0 } else { x.hypot(y) * (1.0 - 1.0 / share) }
        }
        Mark::Line(line) => (distance_to_segment(point, [line.from, line.to]) - 0.5 * line.width).max(0.0),
        Mark::Path(path) => {
            let distances = path.points.windows(2).map(|pair| distance_to_segment(point, [pair[0], pair[1]]));
            (distances.fold(f64::INFINITY, f64::min) - 0.5 * path.width).max(0.0)
        }
    }
}

/// The mark limited to a canvas of `size` px: its centre on the canvas, no thicker than the canvas.
#[must_use]
pub fn bounded(mark: &Mark, size: [u32; 2]) -> Mark {
    let thickest = f64::from(size[0].max(size[1]));
    let thick = |length: f64| length.clamp(SMALLEST.min(thickest), thickest);
    let inside = |p: [f64; 2]| [0, 1].map(|axis| p[axis].clamp(0.0, f64::from(size[axis])));
    match mark {
        Mark::Ellipse(ellipse) => Mark::Ellipse(Ellipse {
            center: inside(ellipse.center),
            radii: ellipse.radii.map(thick),
            angle: ellipse.angle,
        }),
        Mark::Line(line) => {
            let end = |p: [f64; 2]| {
                [0, 1].map(|axis| p[axis].clamp(-f64::from(size[axis]), 2.0 * f64::from(size[axis])))
            };
            let mut line = Line { from: end(line.from), to: end(line.to), width: thick(line.width) };
            if line.length() < MIN_LENGTH {
                line.to[0] += SMALLEST;
            }
            on_canvas(&Mark::Line(line), size)
        }
        Mark::Path(path) => bounded_path(Path { width: thick(path.width), ..path.clone() }, size),
    }
}

/// The mark moved until its centre is on a canvas of `size` px.
fn on_canvas(mark: &Mark, size: [u32; 2]) -> Mark {
    let size = size.map(f64::from);
    let is_on = |mark: &Mark| (0..2).all(|axis| (0.0..=size[axis]).contains(&mark.center()[axis]));
    let moved = |mark: &Mark, rim: f64| {
        let center = mark.center();
        mark.shifted([0, 1].map(|axis| center[axis].clamp(rim, size[axis] - rim) - center[axis]))
    };
    if is_on(mark) {
        return mark.clone();
    }
    let moved_once = moved(mark, 0.0);
    // The centre is rounded: on the very edge it may lie beyond, and a move along one side may round it along the other.
    if is_on(&moved_once) { moved_once } else { moved(&moved_once, ROUNDING) }
}

/// The path moved until its centre is on a canvas of `size` px, and shrunk around it until no point is farther from the
/// canvas than a side of it.
fn bounded_path(path: Path, size: [u32; 2]) -> Mark {
    let path = Path { points: extended(path.points), ..path };
    let moved = on_canvas(&Mark::Path(path), size);
    let center = moved.center();
    let Mark::Path(path) = &moved else { return moved };
    let fits = path.points.iter().flat_map(|point| [0, 1].map(|axis| (axis, point[axis] - center[axis])));
    let factor = fits.fold(1.0, |least: f64, (axis, reach)| {
        let side = f64::from(size[axis]);
        let room = if reach < 0.0 { center[axis] + side } else { 2.0 * side - center[axis] };
        least.min((1.0 - 1e-9) * room / reach.abs())
    });
    if factor >= 1.0 - 1e-9 {
        return moved;
    }
    let place = |point: [f64; 2]| [0, 1].map(|axis| center[axis] + factor * (point[axis] - center[axis]));
    on_canvas(&Mark::Path(path.with_points(place)), size)
}

/// The points of a path; where all are at one place, the last a little beside it.
fn extended(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let first = points.first().copied().unwrap_or_default();
    let is_far = |point: &[f64; 2]| (0..2).any(|axis| (point[axis] - first[axis]).abs() >= MIN_LENGTH);
    if !points.iter().any(is_far)
        && let Some(last) = points.last_mut()
    {
        last[0] += SMALLEST;
    }
    points
}

/// The bounding box of the marks: smallest and largest x and y, px. `None` without marks.
#[must_use]
pub fn extent<'a>(marks: impl IntoIterator<Item = &'a Mark>) -> Option<[[f64; 2]; 2]> {
    let mut found: Option<[[f64; 2]; 2]> = None;
    for mark in marks {
        let [low, high] = extent_of(mark);
        let [least, most] = found.get_or_insert([low, high]);
        for axis in 0..2 {
            least[axis] = least[axis].min(low[axis]);
            most[axis] = most[axis].max(high[axis]);
        }
    }
    found
}

fn extent_of(mark: &Mark) -> [[f64; 2]; 2] {
    match mark {
        Mark::Ellipse(ellipse) => {
            let (sin, cos) = ellipse.angle.to_radians().sin_cos();
            let [a, b] = ellipse.radii;
            let half = [(a * cos).hypot(b * sin), (a * sin).hypot(b * cos)];
            [-1.0, 1.0].map(|side| [0, 1].map(|axis| ellipse.center[axis] + side * half[axis]))
        }
        Mark::Line(line) => {
            let half = 0.5 * line.width;
            let low = [0, 1].map(|axis| line.from[axis].min(line.to[axis]) - half);
            let high = [0, 1].map(|axis| line.from[axis].max(line.to[axis]) + half);
            [low, high]
        }
        Mark::Path(path) => {
            let [low, high] = path.bounds();
            let half = 0.5 * path.width;
            [low.map(|edge| edge - half), high.map(|edge| edge + half)]
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::editor::shape::*;

    const ELLIPSE: Mark = Mark::Ellipse(Ellipse { center: [50.0, 40.0], radii: [20.0, 10.0], angle: 90.0 });

    #[test]
    fn a_line_that_is_moved_over_the_edge_has_its_centre_on_the_canvas() {
        for i in 0..20_000_u32 {
            // Ends with all their digits.
            let digits = |k: u32| f64::from(i.wrapping_mul(2_654_435_761).rotate_left(k)) / 7e6;
            let line = Line { from: [digits(0), digits(5)], to: [digits(11), digits(19)], width: 2.0 };
            let midpoint = line.center();
            for by in
                [[-midpoint[0], -midpoint[1]], [512.0 - midpoint[0], 384.0 - midpoint[1]], [-900.0, 900.0]]
            {
                let at = center(&bounded(&moved(&Mark::Line(line), by), [512, 384]));
                assert!((0.0..=512.0).contains(&at[0]) && (0.0..=384.0).contains(&at[1]), "{line:?} {at:?}");
            }
        }
    }

    #[test]
    fn a_path_that_is_moved_over_the_edge_has_its_centre_on_the_canvas() {
        for i in 0..5_000_u32 {
            let digits = |k: u32| f64::from(i.wrapping_mul(2_654_435_761).rotate_left(k)) / 7e6;
            let points = [[digits(0), digits(5)], [digits(11), digits(19)], [digits(23), digits(29)]];
            let path = Mark::Path(Path { points: points.to_vec(), width: 2.0 });
            let [x, y] = center(&path);
            for by in [[-x, -y], [512.0 - x, -y], [512.0 - x, 384.0 - y], [-900.0, 900.0]] {
                let at = center(&bounded(&moved(&path, by), [512, 384]));
                assert!((0.0..=512.0).contains(&at[0]) && (0.0..=384.0).contains(&at[1]), "{path:?} {at:?}");
            }
        }
    }

    #[test]
    fn the_distance_of_a_point_from_an_ellipse_is_0_inside() {
        assert_eq!(distance(&ELLIPSE, [50.0, 59.0]), 0.0);
        assert!((distance(&ELLIPSE, [50.0, 65.0]) - 5.0).abs() < 1e-9);
        assert!((distance(&ELLIPSE, [63.0, 40.0]) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn the_bounding_box_of_a_turned_ellipse_touches_it() {
        let [low, high] = extent([&ELLIPSE]).unwrap();
        for (found, expected) in low.iter().chain(&high).zip([40.0, 20.0, 60.0, 60.0]) {
            assert!((found - expected).abs() < 1e-9, "{low:?} {high:?}");
        }
    }

    #[test]
    fn a_mark_is_limited_to_the_canvas_by_its_centre() {
        let line = Mark::Line(Line { from: [-30.0, 10.0], to: [10.0, 10.0], width: 900.0 });
        let Mark::Line(line) = bounded(&line, [100, 80]) else { panic!("a line stays a line") };
        assert_eq!((line.from, line.to, line.width), ([-20.0, 10.0], [20.0, 10.0], 100.0));
    }

    #[test]
    fn turning_and_turning_back_changes_nothing() {
        let there = turned(&ELLIPSE, 33.0, [0.0, 0.0]);
        let Mark::Ellipse(back) = turned(&there, -33.0, [0.0, 0.0]) else { panic!() };
        assert!((back.center[0] - 50.0).abs() < 1e-9 && (back.angle - 90.0).abs() < 1e-9);
    }
}
