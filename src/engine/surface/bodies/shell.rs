//! A coiled sea shell: a tube around a logarithmic spiral (Raup 1966), whose whorls have grown together.

use std::f64::consts::TAU;

use super::super::model::Model;
use super::bars::{Bar, joined};
use super::implicit::model;

/// Whorls.
const TURNS: usize = 5;
/// Bars a whorl.
const STEPS: usize = 32;
/// How much larger a whorl is than the one before it.
const EXPANSION: f64 = 1.75;
/// The fillet between whorls, as a share of the tube's radius, and at least so wide: the mesh must be able to show it.
const FILLET: f64 = 0.25;
const LEAST: f64 = 0.07;

/// The middle of the tube and its radius, `turns` whorls before the opening.
fn tube(turns: f64) -> ([f64; 3], f64) {
    let size = libm::pow(EXPANSION, -turns);
    // The opening is in front, to the right; the spire is above.
    let (sin, cos) = libm::sincos(TAU * turns + 0.9);
    ([0.56 * size * cos, 0.95 - 1.42 * size, 0.56 * size * sin], 0.44 * size)
}

/// A bar of the tube, thinner by this share.
fn bar(from: f64, to: f64, share: f64) -> Bar {
    let [(from, thick), (to, thin)] = [tube(from), tube(to)];
    Bar::new(from, to, [share * thick, share * thin], 1.0)
}

/// About the distance from the whorls; negative inside. Bars join their neighbours without, other whorls with a fillet.
fn whorls(bars: &[Bar], place: [f64; 3]) -> f64 {
    let nearest = |skipped: std::ops::Range<usize>| {
        bars.iter().enumerate().filter(|(at, _)| !skipped.contains(at)).fold(
            (0, 1e9),
            |(least_at, least), (at, bar)| {
                if !bar.may_be_nearer(place, least) {
                    return (least_at, least);
                }
                let distance = bar.distance(place);
                if distance < least { (at, distance) } else { (least_at, least) }
            },
        )
    };
    let (at, distance) = nearest(0..0);
    let (_, other) = nearest(at.saturating_sub(STEPS / 2)..at + STEPS / 2);
    joined(distance, other, (FILLET * tube(at as f64 / STEPS as f64).1).max(LEAST))
}

pub fn shell() -> Model {
    let turns = |step: usize| step as f64 / STEPS as f64;
    let bars: Vec<Bar> = (0..TURNS * STEPS).map(|step| bar(turns(step), turns(step + 1), 1.0)).collect();
    // The opening is hollow: the tube's inside is taken away.
    let hollow: Vec<Bar> =
        (0..10).map(|step| 0.08 - 0.03 * f64::from(step)).map(|at| bar(at, at - 0.03, 0.8)).collect();
    let field = |place: [f64; 3]| {
        let hole = hollow.iter().map(|bar| bar.distance(place)).fold(f64::MAX, f64::min);
        -joined(-whorls(&bars, place), hole, 0.07)
    };
    model(&field, [[-1.2, -1.1, -1.2], [1.2, 1.1, 1.2]], 0.023)
}
