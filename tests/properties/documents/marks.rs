//! Random marks: in proportion to the canvas, like those that users draw, or of any size and shape.

use dapple_engine::document::limits::MIN_LENGTH;
use dapple_engine::document::{Ellipse, Kind, Line, Path, Stroke};
use proptest::prelude::*;

/// The sizes of marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sizes {
    /// In proportion to the canvas, with shapes like drawn ones.
    Usual,
    /// Half as large as [`Self::Usual`]: for a layer that must find room between the marks of another one.
    Small,
    /// Of any shape, thick or thin, but thick enough that the grid of a small canvas is small.
    Any,
    /// With shapes like drawn ones, as thick and as thin as documents may hold, also outside the canvas.
    Wild,
}

type Points = Vec<[f64; 2]>;

fn point([width, height]: [f64; 2]) -> impl Strategy<Value = [f64; 2]> {
    (0.0..=width, 0.0..=height).prop_map(<[f64; 2]>::from)
}

fn any_thickness() -> impl Strategy<Value = f64> {
    prop_oneof![2.0..9.0_f64, 1.5..30.0_f64]
}

/// Centres and ends of marks: on the canvas; wild marks may be as far outside as documents may hold.
fn place([width, height]: [f64; 2], sizes: Sizes) -> BoxedStrategy<[f64; 2]> {
    let on = point([width, height]);
    if sizes != Sizes::Wild {
        return on.boxed();
    }
    let beside = (-width..=2.0 * width, -height..=2.0 * height).prop_map(<[f64; 2]>::from);
    prop_oneof![9 => on, 1 => beside].boxed()
}

/// Radii and widths of wild marks: mostly in proportion to the canvas, and of any size up to the largest that is allowed.
fn wild_thickness(size: [f64; 2]) -> BoxedStrategy<f64> {
    let [least, most] = [MIN_LENGTH, size[0].max(size[1])];
    let any = (0.0..=1.0_f64).prop_map(move |share| (least * (most / least).powf(share)).clamp(least, most));
    let usual = (0.02..=0.12_f64).prop_map(move |share| (share * side(size)).clamp(least, most));
    let large = (0.1..=1.0_f64).prop_map(move |share| (share * most).clamp(least, most));
    prop_oneof![12 => usual, 3 => large, 2 => any, 1 => Just(most)].boxed()
}

/// The shorter side of a canvas.
fn side([width, height]: [f64; 2]) -> f64 {
    width.min(height)
}

/// A length between these numbers of sides of a canvas, but at least `least` px.
fn share(size: [f64; 2], [low, high]: [f64; 2], least: f64) -> std::ops::Range<f64> {
    let [low, high] = [low, high].map(|share| side(size) * share);
    low.max(least)..high.max(1.5 * least)
}

/// Radii of a spot.
fn radii(size: [f64; 2], sizes: Sizes) -> BoxedStrategy<[f64; 2]> {
    match sizes {
        Sizes::Any => (any_thickness(), any_thickness()).prop_map(<[f64; 2]>::from).boxed(),
        Sizes::Wild => (wild_thickness(size), 0.2..=1.0_f64)
            .prop_map(|(r, aspect)| [r, (r * aspect).max(MIN_LENGTH)])
            .boxed(),
        Sizes::Usual | Sizes::Small => {
            let radius = match sizes {
                Sizes::Small => share(size, [0.015, 0.04], 1.5),
                _ => share(size, [0.03, 0.1], 3.0),
            };
            (radius, 0.45..=1.0_f64).prop_map(|(r, aspect)| [r, r * aspect]).boxed()
        }
    }
}

/// Widths of stripes.
fn width(size: [f64; 2], sizes: Sizes) -> BoxedStrategy<f64> {
    match sizes {
        Sizes::Any => any_thickness().boxed(),
        Sizes::Wild => wild_thickness(size),
        Sizes::Usual => share(size, [0.025, 0.07], 2.5).boxed(),
        Sizes::Small => share(size, [0.015, 0.03], 1.5).boxed(),
    }
}

fn ellipse(size: [f64; 2], sizes: Sizes) -> impl Strategy<Value = Ellipse> {
    (place(size, sizes), radii(size, sizes), -400.0..400.0_f64).prop_map(|(center, radii, angle)| Ellipse {
        center,
        radii,
        angle,
    })
}

/// The points of a path from `from`, each one a step farther, in a direction that changes by this number of degrees.
fn course(from: [f64; 2], mut degrees: f64, step: f64, turns: &[f64], size: [f64; 2]) -> Points {
    let mut points = vec![from];
    for turn in turns {
        let [x, y] = points[points.len() - 1];
        let (s, c) = degrees.to_radians().sin_cos();
        points.push([(x + step * c).clamp(0.0, size[0]), (y + step * s).clamp(0.0, size[1])]);
        degrees += turn;
    }
    // Steps along the border may have no length.
    points.dedup();
    if points.len() < 2 {
        points.push([0.5 * size[0], 0.5 * size[1]]);
    }
    points
}

/// Points of a line, `count` of them: slightly bent, or anywhere.
fn points(size: [f64; 2], count: std::ops::Range<usize>, sizes: Sizes) -> BoxedStrategy<Points> {
    if sizes == Sizes::Any {
        return prop::collection::vec(point(size), count).boxed();
    }
    let turns = prop::collection::vec(-20.0..20.0_f64, count.start - 1..count.end - 1);
    (point(size), 0.0..360.0_f64, share(size, [0.08, 0.2], 8.0), turns)
        .prop_map(move |(from, degrees, step, turns)| course(from, degrees, step, &turns, size))
        .boxed()
}

fn line(size: [f64; 2], sizes: Sizes) -> BoxedStrategy<Stroke> {
    let ends = match sizes {
        Sizes::Any => (point(size), point(size)).boxed(),
        Sizes::Usual | Sizes::Small | Sizes::Wild => {
            (point(size), 0.0..360.0_f64, share(size, [0.3, 0.9], 12.0))
                .prop_map(move |(from, degrees, length)| {
                    let points = course(from, degrees, length, &[0.0], size);
                    (points[0], points[1])
                })
                .boxed()
        }
    };
    (ends, width(size, sizes)).prop_map(|((from, to), width)| Stroke::Line(Line { from, to, width })).boxed()
}

fn path(size: [f64; 2], sizes: Sizes) -> impl Strategy<Value = Stroke> {
    (points(size, 2..9, sizes), width(size, sizes))
        .prop_map(|(points, width)| Stroke::Path(Path { points, width }))
}

fn freehand_line(size: [f64; 2], sizes: Sizes) -> impl Strategy<Value = Stroke> {
    (points(size, 2..12, sizes), width(size, sizes))
        .prop_map(|(points, width)| Stroke::Freehand { points, width })
}

/// A stroke around an ellipse, or any scribble.
fn freehand_spot(size: [f64; 2], sizes: Sizes) -> BoxedStrategy<Stroke> {
    if sizes == Sizes::Any {
        return freehand_line(size, sizes).boxed();
    }
    (ellipse(size, sizes), 12..24_usize, width(size, sizes))
        .prop_map(|(ellipse, count, width)| Stroke::Freehand { points: around(&ellipse, count), width })
        .boxed()
}

/// Points around an ellipse; the last one repeats the first.
fn around(ellipse: &Ellipse, count: usize) -> Points {
    let (s, c) = ellipse.angle.to_radians().sin_cos();
    let at = |k: usize| {
        let (sin, cos) = (std::f64::consts::TAU * (k % count) as f64 / count as f64).sin_cos();
        let [along, across] = [ellipse.radii[0] * cos, ellipse.radii[1] * sin];
        [ellipse.center[0] + along * c - across * s, ellipse.center[1] + along * s + across * c]
    };
    (0..=count).map(at).collect()
}

/// A star-shaped outline about a point of the canvas, which may reach outside.
fn outline(size: [f64; 2], sizes: Sizes) -> BoxedStrategy<Stroke> {
    let radii = match sizes {
        Sizes::Any => prop::collection::vec(2.0..20.0_f64, 3..20).boxed(),
        Sizes::Wild => (wild_thickness(size), prop::collection::vec(0.75..1.3_f64, 3..20))
            .prop_map(|(radius, shares)| shares.into_iter().map(|share| radius * share).collect())
            .boxed(),
        Sizes::Usual | Sizes::Small => {
            (share(size, [0.04, 0.1], 3.0), prop::collection::vec(0.75..1.3_f64, 6..20))
                .prop_map(|(radius, shares)| shares.into_iter().map(|share| radius * share).collect())
                .boxed()
        }
    };
    (point(size), radii)
        .prop_map(|([x, y], radii)| {
            let corner = |(k, r): (usize, &f64)| {
                let (s, c) = (std::f64::consts::TAU * k as f64 / radii.len() as f64).sin_cos();
                [x + r * c, y + r * s]
            };
            Stroke::outline(radii.iter().enumerate().map(corner))
        })
        .boxed()
}

/// One to four marks of this kind.
pub fn strokes(size: [u32; 2], kind: Kind, sizes: Sizes) -> BoxedStrategy<Vec<Stroke>> {
    let size = size.map(f64::from);
    let mark = match kind {
        Kind::Ellipse => prop_oneof![
            12 => ellipse(size, sizes).prop_map(Stroke::Ellipse),
            3 => outline(size, sizes),
            1 => freehand_spot(size, sizes),
        ]
        .boxed(),
        Kind::Line => prop_oneof![
            8 => line(size, sizes),
            4 => path(size, sizes),
            1 => freehand_line(size, sizes),
        ]
        .boxed(),
    };
    prop::collection::vec(mark, 1..5).boxed()
}

/// One or two lines of one direction, and the same number of another direction, which cross in the middle of the
/// canvas.
pub fn crossing_lines(size: [u32; 2], sizes: Sizes) -> impl Strategy<Value = Vec<Stroke>> {
    let size = size.map(f64::from);
    let offset = move || -0.15 * side(size)..0.15 * side(size);
    let lines = move || prop::collection::vec((offset(), width(size, sizes)), 1..=2);
    (0.0..180.0_f64, 40.0..=90.0_f64, lines(), lines()).prop_map(move |(degrees, between, first, second)| {
        let through = |degrees: f64, (offset, width): (f64, f64)| {
            let (s, c) = degrees.to_radians().sin_cos();
            let at =
                |along: f64| [0.5 * size[0] + along * c - offset * s, 0.5 * size[1] + along * s + offset * c];
            let half = 0.45 * side(size);
            Stroke::Line(Line { from: at(-half), to: at(half), width })
        };
        let first = first.into_iter().map(|line| through(degrees, line));
        first.chain(second.into_iter().map(|line| through(degrees + between, line))).collect()
    })
}
