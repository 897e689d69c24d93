//! Strokes as hands draw them, by kind.

mod hand;

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::*;
use crate::marks::turn;
use hand::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Fails unless 99 of 100 of each kind are what `is` says.
fn recognised(kinds: &[Kind], line: bool, is: fn(&Option<Mark>) -> bool) {
    let mut table = String::new();
    let mut failed = false;
    for kind in kinds {
        let right = strokes(kind, line).iter().filter(|(_, points)| is(&recognise(points, 6.0))).count();
        failed |= right * 100 < STROKES * 99;
        table += &format!("{right:5} of {STROKES}: {}\n", kind.0);
    }
    println!("{table}");
    assert!(!failed, "\n{table}");
}

#[test]
fn closed_strokes_are_ellipses() {
    recognised(OUTLINES, false, |mark| matches!(mark, Some(Mark::Ellipse(_))));
    recognised(BLOBS, false, |mark| matches!(mark, Some(Mark::Ellipse(_))));
}

#[test]
fn open_strokes_are_lines_or_paths() {
    recognised(OPEN, true, |mark| matches!(mark, Some(Mark::Line(_) | Mark::Path(_))));
    let straight: Vec<Kind> =
        OPEN.iter().filter(|kind| ["straight", "retraced"].contains(&kind.0)).copied().collect();
    recognised(&straight, true, |mark| matches!(mark, Some(Mark::Line(_))));
}

#[test]
fn in_version_1_open_strokes_were_lines() {
    for kind in OPEN {
        for (_, points) in strokes(kind, true) {
            let mark = recognise_straight(&points, 6.0);
            assert!(!matches!(mark, Some(Mark::Path(_)) | None), "{}: {mark:?}", kind.0);
        }
    }
}

/// An S of 200 × 80 px with its directions, drawn with jitter of `jitter` px.
fn wave(jitter: f64) -> (Vec<[f64; 2]>, impl Fn(f64) -> f64) {
    let mut rng = Pcg64Mcg::seed_from_u64(9);
    let at = |t: f64| [200.0 * t, 40.0 * (TAU * t).sin()];
    let points = (0..=300)
        .map(|i| at(f64::from(i) / 300.0).map(|value| value + jitter * rng.random_range(-1.0..1.0)))
        .collect();
    let direction = |x: f64| (40.0 * TAU / 200.0 * (TAU * x / 200.0).cos()).atan().to_degrees();
    (points, direction)
}

#[test]
fn a_path_follows_the_stroke_and_not_the_jitter_of_the_pen() {
    for width in [4.0, 8.0, 14.0] {
        let (points, direction) = wave(0.6);
        let Some(Mark::Path(path)) = recognise(&points, width) else { panic!("a path") };
        assert!(path.points.len() <= 30, "{} points, {width} wide", path.points.len());
        let mut off: Vec<f64> = path
            .samples(200)
            .iter()
            .map(|sample| turn(sample.direction, direction(sample.point[0])).abs())
            .collect();
        off.sort_by(f64::total_cmp);
        assert!(off[100] < 3.0 && off[190] < 10.0, "{width} wide: {} {}", off[100], off[190]);
        for sample in path.samples(200) {
            let wanted = 40.0 * (TAU * sample.point[0] / 200.0).sin();
            assert!((sample.point[1] - wanted).abs() < 0.25 * width + 1.0, "{width} wide: {sample:?}");
        }
    }
}

#[test]
fn a_stroke_that_departs_by_less_than_half_its_width_is_a_line() {
    let arc: Vec<[f64; 2]> =
        (0..=60).map(|i| f64::from(i) / 60.0).map(|t| [100.0 * t, 24.0 * t * (1.0 - t)]).collect();
    // It departs by 6 px from its chord, and by 4 from the line through it.
    assert!(matches!(recognise(&arc, 10.0), Some(Mark::Line(_))));
    assert!(matches!(recognise(&arc, 6.0), Some(Mark::Path(_))));
}

#[test]
fn a_corner_stays_a_corner() {
    let chevron = polyline(vec![[0.0, 0.0], [60.0, 60.0], [120.0, 0.0]]);
    let points: Vec<[f64; 2]> = (0..=80).map(|i| chevron(f64::from(i) / 80.0)).collect();
    let Some(Mark::Path(path)) = recognise(&points, 8.0) else { panic!("a path") };
    let off = |from: usize, to: usize, angle: f64| {
        path.samples(100)[from..to].iter().all(|sample| turn(sample.direction, angle).abs() < 4.0)
    };
    assert!(off(0, 46, 45.0) && off(54, 100, 135.0), "{path:?}");
}

/// Sorted absolute errors of the fitted ellipses of a kind: area as a share, aspect, centre as a share of the
/// half length, angle in degrees (aspect below 0.8 only).
fn errors(kind: &Kind) -> [Vec<f64>; 4] {
    let mut errors = [vec![], vec![], vec![], vec![]];
    for (meant, points) in strokes(kind, false) {
        let Some(Mark::Ellipse(got)) = recognise(&points, 6.0) else { continue };
        let area = std::f64::consts::PI * meant.radius * meant.radius * meant.aspect;
        errors[0].push((got.area() / area - 1.0).abs());
        errors[1].push((got.aspect() - meant.aspect).abs());
        let off = (got.center[0] - meant.center[0]).hypot(got.center[1] - meant.center[1]);
        errors[2].push(off / meant.radius);
        if meant.aspect < 0.8 {
            errors[3].push(turn(got.major_angle(), meant.angle).abs());
        }
    }
    errors.each_mut().map(|list| {
        list.sort_by(f64::total_cmp);
        std::mem::take(list)
    })
}

#[test]
fn a_stroke_along_an_ellipse_gives_that_ellipse() {
    for kind in OUTLINES {
        let [area, aspect, centre, angle] = errors(kind);
        // (median, 95th percentile, name); the wobble of the hand itself is 2 % of the half length.
        for (list, median, p95, name) in [
            (area, 0.02, 0.06, "area"),
            (aspect, 0.01, 0.035, "aspect"),
            (centre, 0.03, 0.06, "centre"),
            (angle, 0.8, 3.0, "angle"),
        ] {
            let got = (list[list.len() / 2], list[list.len() * 95 / 100]);
            assert!(got.0 < median && got.1 < p95, "{}: {name} {got:?}", kind.0);
        }
    }
}

#[test]
fn the_line_lies_along_the_stroke() {
    // Straight, wavy and retraced: as long as drawn, in its direction, wherever the pen was slow.
    for kind in OPEN.iter().filter(|kind| ["straight", "wavy", "retraced"].contains(&kind.0)) {
        for (meant, points) in strokes(kind, true) {
            let Some(Mark::Line(line)) = recognise(&points, 6.0) else { continue };
            assert_eq!(line.width, 6.0);
            assert!((line.length() / (2.0 * meant.radius) - 1.0).abs() < 0.25, "{}: {line:?}", kind.0);
            let most = if kind.0 == "wavy" { 45.0 } else { 8.0 };
            assert!(turn(line.angle(), meant.angle).abs() < most, "{}: {line:?} for {meant:?}", kind.0);
        }
    }
}

#[test]
fn a_slowly_drawn_stroke_gives_the_same_ellipse() {
    // A thousand points on one quarter, twenty on the rest.
    let at = |turns: f64| {
        let (s, c) = (TAU * turns).sin_cos();
        [100.0 + 20.0 * c, 60.0 + 10.0 * s]
    };
    let slow = (0..1000).map(|i| at(f64::from(i) / 4000.0));
    let fast = (0..=20).map(|i| at(0.25 + 0.75 * f64::from(i) / 20.0));
    let Some(Mark::Ellipse(got)) = recognise(&slow.chain(fast).collect::<Vec<_>>(), 6.0) else {
        panic!("an ellipse")
    };
    assert!((got.radii[0] - 20.0).abs() < 0.2 && (got.radii[1] - 10.0).abs() < 0.2, "{got:?}");
    assert!((got.center[0] - 100.0).abs() < 0.2 && (got.center[1] - 60.0).abs() < 0.2, "{got:?}");
}

#[test]
fn an_outline_that_no_conic_fits_takes_the_second_moments_of_its_hull() {
    let square = [[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]];
    let got = ellipse(&[square, square].concat()).unwrap();
    assert!((got.radii[0] - 12.0 * 2.0 / 12f64.sqrt()).abs() < 1e-9, "{got:?}");
}

#[test]
fn a_dot_is_no_mark() {
    assert_eq!(recognise(&[], 6.0), None);
    assert_eq!(recognise(&[[5.0, 5.0]], 6.0), None);
    assert_eq!(recognise(&[[5.0, 5.0]; 30], 6.0), None);
    assert_eq!(recognise(&[[5.0, 5.0], [f64::NAN, 6.0]], 6.0), None);
    assert!(matches!(recognise(&[[0.0, 0.0], [3.0, 4.0]], 2.0), Some(Mark::Line(_))));
}

proptest! {
    #[test]
    fn whatever_the_points_the_mark_is_made_of_finite_numbers(
        points in prop::collection::vec(prop::array::uniform2(prop_oneof![
            4 => (-4i32..4).prop_map(f64::from),
            4 => -100.0..100.0f64,
            1 => prop::num::f64::ANY,
        ]), 0..30),
    ) {
        match recognise(&points, 6.0) {
            None => {}
            Some(Mark::Ellipse(got)) => {
                let numbers = [got.center, got.radii].concat();
                prop_assert!(numbers.iter().all(|x| x.is_finite()) && got.radii[1] > 0.0, "{got:?}");
            }
            Some(Mark::Path(got)) => {
                prop_assert!(got.length().is_finite() && got.length() > 0.0, "{got:?}");
            }
            Some(Mark::Line(got)) => {
                prop_assert!(got.length().is_finite() && got.length() > 0.0, "{got:?}");
            }
        }
    }

    #[test]
    fn a_stroke_moved_and_enlarged_is_the_same_mark(
        kind in prop::sample::select((0..OUTLINES.len()).collect::<Vec<_>>()),
        power in -3i32..6, x in -64i32..64, y in -64i32..64,
    ) {
        let (_, points) = strokes(&OUTLINES[kind], false).swap_remove(7);
        let scale = 2f64.powi(power);
        let moved: Vec<_> = points.iter().map(|p| [scale * p[0] + f64::from(x), scale * p[1] + f64::from(y)]).collect();
        let (Some(Mark::Ellipse(here)), Some(Mark::Ellipse(there))) =
            (recognise(&points, 6.0), recognise(&moved, 6.0)) else { panic!("ellipses") };
        prop_assert!((there.radii[0] / here.radii[0] / scale - 1.0).abs() < 1e-6);
        prop_assert!((there.radii[1] / here.radii[1] / scale - 1.0).abs() < 1e-6);
        prop_assert!((there.center[0] - scale * here.center[0] - f64::from(x)).abs() < 1e-6 * scale * here.radii[0] + 1e-6);
    }
}
