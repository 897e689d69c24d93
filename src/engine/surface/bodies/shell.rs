//! A coiled sea shell: a tube around a logarithmic spiral (Raup 1966), whose whorls have grown together.

use std::f64::consts::TAU;
use std::ops::Range;

use super::super::model::Model;
use super::bars::{Bar, dot, joined};
use super::implicit::model;

/// Number of whorls.
const TURNS: usize = 4;
/// Number of bars per whorl.
const STEPS: usize = 32;
/// Ratio of the size of a whorl to the one before it.
const EXPANSION: f64 = 1.75;
/// The fillet between whorls, as a share of the tube's radius, and its least width, which the mesh must be able to show.
const FILLET: f64 = 0.25;
const LEAST: f64 = 0.07;

/// Radius of the rounded edge of the opening.
const EDGE: f64 = 0.06;

/// The middle of the tube and its radius, `turns` whorls before the opening.
fn tube(turns: f64) -> ([f64; 3], f64) {
    let size = libm::pow(EXPANSION, -turns);
    // The opening is in front and faces to the right; the spire is above.
    let (sin, cos) = libm::sincos(TAU * turns + 2.2);
    ([0.56 * size * cos, 0.95 - 1.42 * size, 0.56 * size * sin], 0.44 * size)
}

/// A bar of the tube, thinner by this share.
fn bar(from: f64, to: f64, share: f64) -> Bar {
    let [(from, thick), (to, thin)] = [tube(from), tube(to)];
    Bar::new(from, to, [share * thick, share * thin], 1.0)
}

/// The tube: bars from the opening to the apex, cut off flat at the opening.
struct Tube {
    bars: Vec<Bar>,
    end: [f64; 3],
    /// The direction out of the opening.
    outward: [f64; 3],
}

impl Tube {
    fn new() -> Self {
        let turns = |step: usize| step as f64 / STEPS as f64;
        let mut bars: Vec<Bar> =
            (0..TURNS * STEPS).map(|step| bar(turns(step), turns(step + 1), 1.0)).collect();
        // The apex is closed over the axis.
        let (last, radius) = tube(turns(TURNS * STEPS));
        bars.push(Bar::new(last, [0.0, last[1] + 0.6 * radius, 0.0], [radius, 0.7 * radius], 1.0));
        let [(end, _), (inside, _)] = [tube(0.0), tube(1e-3)];
        let way: [f64; 3] = [0, 1, 2].map(|axis| end[axis] - inside[axis]);
        let length = dot(way, way).sqrt();
        Self { bars, end, outward: way.map(|value| value / length) }
    }

    /// The index of the nearest bar, without the skipped ones, and the approximate distance from it.
    fn nearest(&self, place: [f64; 3], skipped: &Range<usize>) -> (usize, f64) {
        let mut nearest = (0, 1e9);
        let bars = self.bars.iter().enumerate().filter(|(at, _)| !skipped.contains(at));
        for (at, bar) in bars {
            if !bar.may_be_nearer(place, nearest.1) {
                continue;
            }
            let mut distance = bar.distance(place);
            if at < STEPS / 4 {
                let off = [0, 1, 2].map(|axis| place[axis] - self.end[axis]);
                distance = -joined(-distance, -dot(off, self.outward), EDGE);
            }
            if distance < nearest.1 {
                nearest = (at, distance);
            }
        }
        nearest
    }

    /// Approximate distance from the whorls; negative inside. Bars join their neighbours without a fillet, other whorls with one.
    fn distance(&self, place: [f64; 3]) -> f64 {
        let (at, distance) = self.nearest(place, &(0..0));
        let (other_at, other) = self.nearest(place, &(at.saturating_sub(STEPS / 2)..at + STEPS / 2));
        // The fillet is computed from the smaller whorl, so that it is equal on both sides.
        let (_, radius) = tube(at.max(other_at) as f64 / STEPS as f64);
        joined(distance, other, (FILLET * radius).max(LEAST))
    }
}

pub fn shell() -> Model {
    let whorls = Tube::new();
    // The opening is hollow, and wider toward its edge.
    let inside = (0..8).map(|step| 0.16 - 0.03 * f64::from(step));
    let hollow: Vec<Bar> = inside.map(|at| bar(at, at - 0.03, 0.78 - 0.5 * at.max(0.0))).collect();
    let field = |place: [f64; 3]| {
        let hole = hollow.iter().map(|bar| bar.distance(place)).fold(f64::MAX, f64::min);
        -joined(-whorls.distance(place), hole, EDGE)
    };
    model(&field, [[-1.2, -1.1, -1.2], [1.2, 1.1, 1.2]], 0.023)
}
