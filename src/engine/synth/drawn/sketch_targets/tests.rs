//! Regions and free marks give equal attributes for equal lines.

use super::*;
use crate::attributes::{Attributes, Stripes};
use crate::document::{DutyChoice, Layer, SystemChoice};
use crate::synth::lines::plan::LinePlan;
use crate::synth::pairs::plan::PairPlan;

const SIZE: [f64; 2] = [512.0; 2];

/// Five lines 10 px wide, 300 px long and `apart` px apart, about the middle of the canvas in this direction.
fn lines(apart: f64, angle: f64) -> Vec<Stroke> {
    let (s, c) = libm::sincos(angle.to_radians());
    let at = |along: f64, across: f64| [256.0 + along * c - across * s, 256.0 + along * s + across * c];
    let line = |k: i32| Stroke::line(at(-150.0, f64::from(k) * apart), at(150.0, f64::from(k) * apart), 10.0);
    (-2..=2).map(line).collect()
}

fn document(system: &str, strokes: Vec<Stroke>, regions: Option<[u32; 2]>) -> Document {
    let system = SystemChoice::named(system).expect("a system");
    let layers = vec![Layer { system, strokes, ..Layer::default() }];
    Document { regions, layers, ..Document::default() }
}

/// The stripes that are asked for in the middle of the canvas; for pairs, in each direction.
fn asked(document: &Document) -> Vec<Stripes> {
    let stripes = |wanted: Attributes| match wanted {
        Attributes::Stripes(stripes) => stripes,
        Attributes::Spots(_) => panic!("lines were drawn"),
    };
    let middle = SIZE.map(|side| 0.5 * side);
    if document.pairs(0).is_some() {
        let plan = PairPlan::read(document, 0, "lines", SIZE, None).expect("a plan");
        return plan.threads.iter().map(|threads| threads.at(middle)).collect();
    }
    if let Some(kind) = document.layers[0].system.lines() {
        let plan = LinePlan::read(document, 0, kind, "lines", SIZE).expect("a plan");
        return vec![stripes(plan.map.at(middle))];
    }
    vec![stripes(region_map(document, 0, "lines").expect("a map").at(middle))]
}

const ONE_DIRECTION: [&str; 7] =
    ["auto", "stripes", "meinhardt-lines", "meinhardt-stripes", "pair-stripes", "streaks", "cracks"];
const SEVERAL: [&str; 2] = ["weave", "maze"];

#[track_caller]
fn are_alike(system: &str, strokes: &[Stroke], apart: f64) {
    let [one, none] = [Some([1, 1]), None].map(|regions| asked(&document(system, strokes.to_vec(), regions)));
    assert!(one.len() == none.len() && !one.is_empty(), "{system}: {one:?} {none:?}");
    for (one, none) in one.iter().zip(&none) {
        assert_eq!(one.wavelength.is_some(), none.wavelength.is_some(), "{system} {apart}: {one:?} {none:?}");
        assert!((one.width / none.width - 1.0).abs() < 0.01, "{system} {apart}: {one:?} {none:?}");
        assert!((one.duty() / none.duty() - 1.0).abs() < 0.01, "{system} {apart}: {one:?} {none:?}");
        let is_free = system == "meinhardt-stripes" || none.wavelength.is_none() && apart == 20.0;
        let drawn = one.wavelength.is_some_and(|period| (period / apart - 1.0).abs() < 0.01);
        assert!(is_free || drawn, "{system} {apart}: {one:?}");
    }
}

#[test]
fn lines_alike_ask_for_the_same_with_one_region_and_with_none_in_every_system() {
    for system in ONE_DIRECTION {
        for apart in [20.0, 33.0, 50.0] {
            are_alike(system, &lines(apart, 25.0), apart);
        }
    }
    for system in SEVERAL {
        for apart in [33.0, 50.0] {
            are_alike(system, &[lines(apart, 10.0), lines(apart, 100.0)].concat(), apart);
        }
    }
}

#[test]
fn a_duty_that_is_given_wins_over_the_distance_of_the_lines_of_a_region() {
    let mut document = document("auto", lines(33.0, 0.0), Some([1, 1]));
    for (duty, period) in [(0.4, Some(25.0)), (0.49, Some(10.0 / 0.49)), (0.5, None)] {
        document.layers[0].options.duty = DutyChoice::Given(duty);
        assert_eq!(asked(&document)[0].wavelength, period, "{duty}");
    }
}

#[test]
fn lines_of_a_region_half_as_wide_as_their_distance_leave_the_wavelength_to_the_system() {
    let wavelength = |system, apart| asked(&document(system, lines(apart, 0.0), Some([2, 2])))[0].wavelength;
    assert_eq!([wavelength("auto", 20.0), wavelength("auto", 20.3)], [None; 2]);
    assert!(wavelength("auto", 21.5).is_some() && wavelength("meinhardt-lines", 20.0).is_some());
}

#[test]
fn only_the_width_of_lines_along_curves_counts() {
    let mut document = document("auto", lines(33.0, 0.0), Some([1, 1]));
    for after in [After::Around, After::Net] {
        document.layers[0].after = after;
        assert_eq!(asked(&document)[0].wavelength, None, "{after:?}");
    }
}
