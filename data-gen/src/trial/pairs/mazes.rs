//! Trial of mazes: areas with lines of two or three directions beside each other.

use dapple::document::{Edges, LayerOptions, PairKind, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::marks::axial;
use dapple_engine::measure::stripes;
use dapple_engine::synth::GrownLayer;

use super::edges::{along, shares};
use super::sketch::{Lines, Sketch};
use super::{Errors, Figure};
use crate::trial::dice::Dice;

/// Side of the canvas, px.
const SIDE: f64 = 400.0;
/// Width of the lines, px.
const WIDTH: [f64; 2] = [4.0, 10.0];
/// Width ÷ distance.
const DUTY: [f64; 2] = [0.4, 0.6];
/// Length of the lines, in distances between lines: areas of one direction have at least 2.5 wavelengths.
const LONG: [f64; 2] = [2.8, 6.0];
/// A direction that has less than this share of an equal part of the edges counts as missing.
const DIED: f64 = 0.3;

/// The figures that are compared; the bounds are the goals that were set.
pub const FIGURES: &[Figure] = &[
    Figure { name: "width %", factor: 100.0, bounds: Some([4.0, 10.0]) },
    Figure { name: "edges > 15° off %", factor: 100.0, bounds: Some([15.0, 15.0]) },
];

/// A random sketch; every third one has three directions.
pub fn sketch(dice: &mut Dice) -> Sketch {
    let first = dice.between([0.0, 180.0]);
    let angles = if dice.chance(1.0 / 3.0) {
        vec![first, first + 60.0 + dice.off(5.0), first + 120.0 + dice.off(5.0)]
    } else {
        vec![first, first + dice.between([50.0, 90.0])]
    };
    let width = dice.log_between(WIDTH);
    let period = width / dice.between(DUTY);
    let long = dice.between(LONG) * period;
    let lines: Vec<Lines> =
        angles.iter().map(|angle| Lines { angle: axial(*angle), width, period }).collect();
    let places = [[0.28, 0.28], [0.72, 0.34], [0.45, 0.74]];
    let strokes = lines
        .iter()
        .zip(places)
        .flat_map(|(lines, place)| lines.strokes(place.map(|share| share * SIDE), 2, long));
    Sketch {
        side: SIDE,
        edges: if dice.chance(0.5) { Edges::Wrap } else { Edges::Closed },
        system: SystemChoice::Of(PairKind::Maze.description()),
        strokes: strokes.collect(),
        options: LayerOptions::default(),
        lines,
        cells: [0.0; 3],
    }
}

/// The width from area and contour, the directions from the edges of the picture.
pub fn measure(sketch: &Sketch, _: &GrownLayer, pattern: &Field) -> Errors {
    let found = stripes(pattern, 0.5).ok_or("no lines")?;
    let angles: Vec<f64> = sketch.lines.iter().map(|lines| lines.angle).collect();
    let even = 1.0 / angles.len() as f64;
    if let Some((angle, share)) =
        angles.iter().zip(shares(pattern, &angles)).find(|(_, share)| *share < DIED * even)
    {
        return Err(format!("the direction {angle:.0}° has {:.0} % of the edges", 100.0 * share));
    }
    let width = found.width / sketch.lines[0].width - 1.0;
    Ok(vec![vec![width], vec![1.0 - along(pattern, &angles)]])
}
