//! Trial of stripes with tips: sketches of lines of one direction.

use dapple::document::{Edges, LayerOptions, PairKind, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::marks::turn;
use dapple_engine::measure;
use dapple_engine::synth::GrownLayer;

use super::sketch::{Lines, Sketch};
use super::{Errors, Figure};
use crate::trial::dice::Dice;

/// Side of the canvas, px.
const SIDE: f64 = 512.0;
/// Width of the lines, px.
const WIDTH: [f64; 2] = [4.0, 12.0];
/// Width ÷ period.
const DUTY: [f64; 2] = [0.2, 0.7];

/// The figures that are compared; the bounds are the goals that were set.
pub const FIGURES: &[Figure] = &[
    Figure { name: "width %", factor: 100.0, bounds: Some([3.0, 7.0]) },
    Figure { name: "period %", factor: 100.0, bounds: Some([2.0, 6.0]) },
    Figure { name: "angle °", factor: 1.0, bounds: Some([0.7, 2.5]) },
];

/// Three lines side by side.
pub fn sketch(dice: &mut Dice) -> Sketch {
    let width = dice.log_between(WIDTH);
    let lines = Lines { angle: dice.between([0.0, 180.0]), width, period: width / dice.between(DUTY) };
    Sketch {
        side: SIDE,
        edges: if dice.chance(0.5) { Edges::Wrap } else { Edges::Closed },
        system: SystemChoice::Of(PairKind::Stripes.description()),
        strokes: lines.strokes([0.5 * SIDE; 2], 3, 0.4 * SIDE),
        options: LayerOptions::default(),
        lines: vec![lines],
        cells: [0.0; 3],
    }
}

/// Measured from area, contour and structure tensor.
pub fn measure(sketch: &Sketch, _: &GrownLayer, pattern: &Field) -> Errors {
    let found = measure::stripes(pattern, 0.5).ok_or("no stripes")?;
    let asked = sketch.lines[0];
    let errors = [
        found.width / asked.width - 1.0,
        found.wavelength / asked.period - 1.0,
        turn(found.angle, asked.angle),
    ];
    Ok(errors.map(|error| vec![error]).to_vec())
}
