//! Trial of weaves: sketches of parallel lines in two or three directions that cross.

use dapple::document::{Edges, LayerOptions, PairKind, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::marks::{axial, turn};
use dapple_engine::synth::GrownLayer;
use dapple_engine::synth::measured_weave::measure_weave;

use super::sketch::{Lines, Sketch};
use super::{Errors, Figure};
use crate::trial::dice::Dice;

/// Side of the canvas, px.
const SIDE: f64 = 512.0;
/// Width of threads, px.
const WIDTH: [f64; 2] = [3.0, 10.0];
/// Width ÷ period.
const DUTY: [f64; 2] = [0.15, 0.4];
/// The least share that three directions leave free. Denser threads are moved apart, with a note.
const FREE: f64 = 0.42;
/// A measured direction that is farther than this from the drawn one counts as another direction, degrees.
const SAME: f64 = 15.0;

/// The figures that are compared; the bounds are the goals that were set.
pub const FIGURES: &[Figure] = &[
    Figure { name: "width %", factor: 100.0, bounds: Some([3.0, 7.0]) },
    Figure { name: "period %", factor: 100.0, bounds: Some([2.0, 6.0]) },
    Figure { name: "angle °", factor: 1.0, bounds: Some([0.7, 2.5]) },
];

/// A random sketch; every third one has three directions.
pub fn sketch(dice: &mut Dice) -> Sketch {
    let three = dice.chance(1.0 / 3.0);
    let first = dice.between([0.0, 180.0]);
    let angles = if three {
        // Directions are 48 to 72° apart.
        vec![first, first + 60.0 + dice.off(6.0), first + 120.0 + dice.off(6.0)]
    } else {
        vec![first, first + dice.between([45.0, 90.0])]
    };
    let lines = loop {
        let lines: Vec<Lines> = angles
            .iter()
            .map(|angle| {
                let width = dice.log_between(WIDTH);
                Lines { angle: axial(*angle), width, period: width / dice.between(DUTY) }
            })
            .collect();
        let free: f64 = lines.iter().map(|lines| 1.0 - lines.width / lines.period).product();
        if !three || free >= FREE {
            break lines;
        }
    };
    Sketch {
        side: SIDE,
        edges: if dice.chance(0.5) { Edges::Wrap } else { Edges::Closed },
        system: SystemChoice::Of(PairKind::Weave.description()),
        strokes: lines.iter().flat_map(|lines| lines.strokes([0.5 * SIDE; 2], 3, 0.6 * SIDE)).collect(),
        options: LayerOptions::default(),
        lines,
        cells: [0.0; 3],
    }
}

/// Measured by dapple's measurement of weaves, on the picture alone.
pub fn measure(sketch: &Sketch, _: &GrownLayer, pattern: &Field) -> Errors {
    let found = measure_weave(pattern).ok_or("no weave")?;
    let mut errors = vec![Vec::new(); FIGURES.len()];
    for asked in &sketch.lines {
        let off = |angle: f64| turn(angle, asked.angle).abs();
        let own = found.iter().min_by(|a, b| off(a.angle).total_cmp(&off(b.angle)));
        let own = own.filter(|own| off(own.angle) < SAME);
        let own = own.ok_or_else(|| format!("no threads of {:.0}°", asked.angle))?;
        errors[0].push(own.width / asked.width - 1.0);
        errors[1].push(own.period / asked.period - 1.0);
        errors[2].push(turn(own.angle, asked.angle));
    }
    Ok(errors)
}
