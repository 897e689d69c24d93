//! Operations on a mark: move, turn, scale, hit test, keep within bounds.

use crate::document::limits::{MIN_LENGTH, Range};
use crate::document::{Outline, Stroke};
use crate::marks::{Ellipse, Line, Mark, Path, distance_to_segment};

/// The smallest radius or width of a drawn mark, px.
pub const SMALLEST: f64 = 0.5;
/// A mark that is moved over the border stops where this length of it is still on the canvas, px, so that it can be
/// seen and moved back.
pub const SEEN: f64 = 1.0;

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

/// The mark limited to a canvas of `size` px: some part of it is on the canvas, it is no thicker than the canvas, and
/// it is cut where it is farther away than a side of the canvas. The part on the canvas stays in its place.
#[must_use]
pub fn bounded(mark: &Mark, size: [u32; 2]) -> Mark {
    let thickest = f64::from(size[0].max(size[1]));
    let thick = |length: f64| length.clamp(SMALLEST.min(thickest), thickest);
    let mark = match mark {
        Mark::Ellipse(ellipse) => Mark::Ellipse(Ellipse { radii: ellipse.radii.map(thick), ..*ellipse }),
        Mark::Line(line) => {
            let mut line = Line { width: thick(line.width), ..*line };
            if line.length() < MIN_LENGTH {
                line.to[0] += SMALLEST;
            }
            Mark::Line(line)
        }
        Mark::Path(path) => {
            Mark::Path(Path { points: extended(path.points.clone()), width: thick(path.width) })
        }
    };
    brought_on(mark, size.map(f64::from)).cut(Range::around_canvas(size))
}

/// The mark, moved towards the canvas until some part of it is on the canvas.
fn brought_on(mark: Mark, size: [f64; 2]) -> Mark {
    if mark.is_on(size) {
        return mark;
    }
    let center = mark.center();
    let way = [0, 1].map(|axis| center[axis].clamp(0.0, size[axis]) - center[axis]);
    let at = |share: f64| mark.shifted(way.map(|way| share * way));
    let share = least_share(|share| at(share).is_on(size));
    at((share + SEEN / way[0].hypot(way[1])).min(1.0))
}

/// The least share of a displacement, 0..1, from which on a condition holds. It holds at the end of the displacement.
pub fn least_share(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut before, mut after) = (0.0, 1.0);
    for _ in 0..40 {
        let between = 0.5 * (before + after);
        if holds(between) {
            after = between;
        } else {
            before = between;
        }
    }
    after
}

/// The stroke without the parts of its outline that are farther from the canvas than a document may hold.
#[must_use]
pub fn within_limits(stroke: Stroke, size: [u32; 2]) -> Stroke {
    let [low, high] = Range::around_canvas(size);
    let nearest = |point: [f64; 2]| [0, 1].map(|axis| point[axis].clamp(low[axis], high[axis]));
    let limited = |outline: Outline| Outline { points: outline.points.into_iter().map(nearest).collect() };
    match stroke {
        Stroke::Outline(outline) => Stroke::Outline(limited(outline)),
        Stroke::Fitted { ellipse, outline } => Stroke::Fitted { ellipse, outline: limited(outline) },
        other => other,
    }
}

/// The points of a path. Where all are at one place, the last one is moved a little.
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

/// The bounding box of the centre of an ellipse, or of the points of a line or path: smallest and largest x and y, px.
#[must_use]
pub fn reach(mark: &Mark) -> [[f64; 2]; 2] {
    match mark {
        Mark::Ellipse(ellipse) => [ellipse.center; 2],
        Mark::Line(line) => Path::from(*line).bounds(),
        Mark::Path(path) => path.bounds(),
    }
}

/// The bounding box of a mark: smallest and largest x and y, px.
#[must_use]
pub fn extent_of(mark: &Mark) -> [[f64; 2]; 2] {
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

    /// Coordinates with many digits, from 0 to about 600 px.
    fn digits(i: u32, k: u32) -> f64 {
        f64::from(i.wrapping_mul(2_654_435_761).rotate_left(k)) / 7e6
    }

    #[test]
    fn marks_partly_on_the_canvas_stay_and_others_are_moved_to_its_border() {
        let size = [512, 384];
        for i in 1..5_000_u32 {
            let point = |k: u32| [digits(i, k), digits(i, k + 5)];
            let marks = [
                Mark::Line(Line { from: point(0), to: point(11), width: 2.0 }),
                Mark::Path(Path { points: vec![point(0), point(11), point(23)], width: 2.0 }),
                Mark::Ellipse(Ellipse { center: point(0), radii: [30.0, 12.0], angle: digits(i, 3) }),
            ];
            for mark in marks {
                let [x, y] = mark.center();
                for by in [[0.0, 0.0], [-x, 0.0], [-x - 20.0, -y], [512.0 - x, 384.0 - y], [-900.0, 900.0]] {
                    let mark = moved(&mark, by);
                    let kept = bounded(&mark, size);
                    assert!(kept.is_on([512.0, 384.0]), "{mark:?} {kept:?}");
                    let is_near = |[low, high]: [[f64; 2]; 2]| {
                        low[0] > -512.0 && high[0] < 1024.0 && low[1] > -384.0 && high[1] < 768.0
                    };
                    if mark.is_on([512.0, 384.0]) && is_near(extent_of(&mark)) {
                        assert_eq!(kept, mark);
                    }
                }
            }
        }
    }

    #[test]
    fn a_mark_that_is_wholly_outside_is_moved_back_by_the_shortest_way() {
        let beside = Mark::Ellipse(Ellipse { center: [140.0, 40.0], radii: [20.0, 10.0], angle: 0.0 });
        let Mark::Ellipse(back) = bounded(&beside, [100, 80]) else { panic!() };
        assert!((back.center[0] - 119.0).abs() < 1e-6 && back.center[1] == 40.0, "{back:?}");
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
    fn a_mark_is_no_thicker_than_the_canvas() {
        let line = Mark::Line(Line { from: [-30.0, 10.0], to: [10.0, 10.0], width: 900.0 });
        let Mark::Line(line) = bounded(&line, [100, 80]) else { panic!("a line stays a line") };
        assert_eq!((line.from, line.to, line.width), ([-30.0, 10.0], [10.0, 10.0], 100.0));
    }

    #[test]
    fn turning_and_turning_back_changes_nothing() {
        let there = turned(&ELLIPSE, 33.0, [0.0, 0.0]);
        let Mark::Ellipse(back) = turned(&there, -33.0, [0.0, 0.0]) else { panic!() };
        assert!((back.center[0] - 50.0).abs() < 1e-9 && (back.angle - 90.0).abs() < 1e-9);
    }
}
