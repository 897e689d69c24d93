//! Sketches of curved strokes: arcs, S-curves, spirals, concentric rings, radiating lines, chevrons.

use std::f64::consts::TAU;

use dapple_engine::marks::Path;

use super::super::dice::Dice;
use super::SIDE;
use super::geometry::{distance, turned};

/// Width of a stroke, px.
const WIDTH: [f64; 2] = [4.0, 16.0];
/// Range of width ÷ period of parallel strokes that are thinner than their gaps.
pub const THIN: [f64; 2] = [0.36, 0.5];
/// Range of width ÷ period of parallel strokes that are wider than their gaps.
pub const WIDE: [f64; 2] = [0.52, 0.8];
/// Smallest radius of curvature, periods.
const BEND: f64 = 2.0;
/// Distance of the points of a stroke, px.
const STEP: f64 = 4.0;

/// What the strokes of a sketch form, by index.
pub const SHAPES: [&str; 7] = ["loose arcs", "arcs", "S-curves", "spiral", "rings", "rays", "chevrons"];

/// The strokes of sketch `index`; those that lie side by side have a width ÷ period in the range `duty`.
pub fn draw(dice: &mut Dice, index: u64, duty: [f64; 2]) -> Vec<Path> {
    loop {
        let width = dice.log_between(WIDTH);
        let period = width / dice.between(duty);
        let lines = match index % SHAPES.len() as u64 {
            0 => loose_arcs(dice, width),
            1 => arcs(dice, period),
            2 => s_curves(dice, period),
            3 => spiral(dice, period),
            4 => rings(dice, period),
            5 => rays(dice, period),
            _ => chevrons(dice, period),
        };
        let turn = dice.between([0.0, TAU]);
        let middle = [0, 1].map(|_| SIDE * dice.between([0.4, 0.6]));
        let place = |point: [f64; 2]| {
            let [x, y] = turned(point, turn);
            [middle[0] + x, middle[1] + y]
        };
        let curve = |line: Vec<[f64; 2]>, dice: &mut Dice| Path {
            points: line.into_iter().map(place).collect(),
            width: width * (1.0 + dice.off(0.05)),
        };
        let curves: Vec<Path> = lines.into_iter().map(|line| curve(line, dice)).collect();
        let on = |point: &[f64; 2]| point.iter().all(|x| (0.0..=SIDE).contains(x));
        if curves.iter().all(|curve| curve.points.len() > 2 && curve.points.iter().all(on)) {
            return curves;
        }
    }
}

/// Points of a curve with a parameter 0..1, about [`STEP`] px apart.
fn sampled(curve: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    const FINE: usize = 4000;
    let mut points = vec![curve(0.0)];
    let mut gone = 0.0;
    for k in 1..=FINE {
        let [before, here] = [k - 1, k].map(|k| curve(k as f64 / FINE as f64));
        gone += distance(before, here);
        if gone >= STEP || k == FINE {
            points.push(here);
            gone = 0.0;
        }
    }
    points
}

/// A part of a circle about `center` from the angle `from` on, radians.
fn arc(center: [f64; 2], radius: f64, from: f64, by: f64) -> Vec<[f64; 2]> {
    sampled(|t| {
        let [x, y] = turned([radius, 0.0], from + t * by);
        [center[0] + x, center[1] + y]
    })
}

/// Three to five arcs, each far from the others.
fn loose_arcs(dice: &mut Dice, width: f64) -> Vec<Vec<[f64; 2]>> {
    let least = 2.0 * BEND * width;
    let count = dice.whole([3, 5]);
    let about = dice.between([110.0, 150.0]);
    (0..count)
        .map(|k| {
            let radius = dice.between([least, least.max(90.0)]);
            let by = dice.between([0.8, 1.8]) * dice.between([0.7, 1.0]);
            let from = dice.between([0.0, TAU]);
            let center = turned([about, 0.0], TAU * k as f64 / count as f64 + dice.off(0.2));
            // The given place is that of the middle of the arc, not of the centre of its circle.
            let [x, y] = turned([radius, 0.0], from + 0.5 * by);
            arc([center[0] - x, center[1] - y], radius, from, by)
        })
        .collect()
}

/// Two to five arcs about one centre, side by side.
fn arcs(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let inner = period * dice.between([BEND, 6.0]);
    let by = dice.between([0.8, 2.4]);
    let count = dice.whole([2, 5]);
    let back = inner + 0.5 * (count as f64 - 1.0) * period;
    (0..count)
        .map(|k| {
            let [from, by] = [dice.off(0.1) - 0.5 * by, by + dice.off(0.1)];
            arc([-back, 0.0], inner + k as f64 * period, from, by)
        })
        .collect()
}

/// One to four S-curves, side by side: y = a·sin(kx), whose sharpest bend has the radius 1 ÷ (a·k²).
fn s_curves(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let length = dice.between([180.0, 380.0]);
    let k = TAU / length;
    let most = 1.0 / (k * k * BEND * period);
    let height = most.min(dice.between([0.1, 0.2]) * length);
    let count = dice.whole([1, 4]);
    (0..count)
        .map(|line| {
            let up = (line as f64 - 0.5 * (count as f64 - 1.0)) * period;
            let [from, to] = [-0.5, 0.5].map(|end| length * (end + dice.off(0.04)));
            sampled(|t| {
                let x = from + t * (to - from);
                [x, up + height * libm::sin(k * x)]
            })
        })
        .collect()
}

/// An Archimedean spiral, whose radius grows by a period with each turn.
fn spiral(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let inner = BEND * period;
    let turns = dice.between([1.5, 3.5]).min((230.0 - inner) / period);
    vec![sampled(|t| turned([inner + t * turns * period, 0.0], TAU * t * turns))]
}

/// Concentric rings, each with a small gap.
fn rings(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let inner = period * dice.between([BEND, 3.0]);
    let most = ((230.0 - inner) / period) as usize + 1;
    let count = dice.whole([2, most.clamp(2, 5)]);
    (0..count)
        .map(|k| {
            arc([0.0, 0.0], inner + k as f64 * period, dice.between([0.0, TAU]), dice.between([5.0, 5.7]))
        })
        .collect()
}

/// Straight strokes that radiate from a point.
fn rays(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let count = dice.whole([8, 18]);
    let inner = count as f64 * period / TAU;
    let outer = inner + dice.between([60.0, 140.0]);
    (0..count)
        .map(|k| {
            let way = TAU * k as f64 / count as f64 + dice.off(0.04);
            let [from, to] = [inner, outer].map(|radius| radius + dice.off(5.0));
            sampled(|t| turned([from + t * (to - from), 0.0], way))
        })
        .collect()
}

/// Chevrons above each other, whose tips have the smallest radius allowed.
fn chevrons(dice: &mut Dice, period: f64) -> Vec<Vec<[f64; 2]>> {
    let half = dice.between([0.6, 1.0]);
    let limb = dice.between([60.0, 140.0]);
    let radius = BEND * period;
    // The tip is an arc of 2·half radians, and the limbs continue it in straight lines.
    let bent = radius * half;
    let all = bent + limb;
    let at = |along: f64| -> [f64; 2] {
        let on_tip = along.clamp(-bent, bent) / radius;
        let tip = turned([0.0, -radius], on_tip);
        let way = turned([1.0, 0.0], on_tip);
        let rest = along - along.clamp(-bent, bent);
        [tip[0] + rest * way[0], tip[1] + rest * way[1]]
    };
    // In the direction straight up, limbs of successive chevrons are a period ÷ cos(half) apart.
    let up = period / libm::cos(half);
    let count = dice.whole([1, 4]);
    let top = 0.5 * (count as f64 - 1.0);
    (0..count)
        .map(|k| {
            let [from, to] = [-all, all].map(|end| end * (1.0 + dice.off(0.05)));
            sampled(|t| {
                let [x, y] = at(from + t * (to - from));
                [x, y + (k as f64 - top) * up]
            })
        })
        .collect()
}
