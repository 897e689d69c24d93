//! Trial of cells: sketches of one ellipse and a width of the lines.

use dapple::document::{AreaKind, Edges, GapChoice, LayerOptions, Stroke, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::measure;
use dapple_engine::synth::GrownLayer;
use dapple_engine::synth::areas::OwnPolygons;

use super::sketch::Sketch;
use super::{Errors, Figure};
use crate::trial::dice::Dice;

/// Range of the areas that are drawn, px².
const AREA: [f64; 2] = [200.0, 4000.0];
/// Width of the lines, px.
const GAP: [f64; 2] = [3.0, 12.0];
/// Range of distance of cells ÷ gap. Outside it, a note says that the cells do not grow as drawn.
const DISTANCE: [f64; 2] = [3.5, 11.0];
/// Minor ÷ major radius.
const ASPECT: [f64; 2] = [0.5, 1.0];
/// Cells have corners, so that they are never rounder than this aspect.
const ROUNDEST: f64 = 0.84;
/// The number of cells on the canvas, about.
const CELLS: f64 = 120.0;

/// The figures that are compared; the bounds are the goals that were set.
pub const FIGURES: &[Figure] = &[
    Figure { name: "area %", factor: 100.0, bounds: Some([3.0, 8.0]) },
    Figure { name: "gap %", factor: 100.0, bounds: Some([4.0, 10.0]) },
    Figure { name: "aspect, below .84", factor: 1.0, bounds: Some([0.03, 0.08]) },
    Figure { name: "aspect, rounder", factor: 1.0, bounds: None },
    Figure { name: "without own cell %", factor: 100.0, bounds: Some([2.0, 2.0]) },
];

/// One ellipse.
pub fn sketch(dice: &mut Dice) -> Sketch {
    loop {
        let (area, gap) = (dice.log_between(AREA), dice.between(GAP));
        let distance = area.sqrt() + 0.93 * gap;
        if distance >= DISTANCE[0] * gap && distance <= DISTANCE[1] * gap {
            let aspect = dice.between(ASPECT);
            return of_area(dice, area, gap, aspect);
        }
    }
}

/// A sketch of one ellipse with this area (px²) and aspect in any direction, and lines `gap` px wide.
pub fn of_area(dice: &mut Dice, area: f64, gap: f64, aspect: f64) -> Sketch {
    let side = (CELLS.sqrt() * (area.sqrt() + 0.93 * gap)).round();
    let major = (area / std::f64::consts::PI / aspect).sqrt();
    Sketch {
        side,
        edges: if dice.chance(0.5) { Edges::Wrap } else { Edges::Closed },
        system: SystemChoice::Of(AreaKind::Polygons.description()),
        strokes: vec![Stroke::ellipse([0.5 * side; 2], [major, aspect * major], dice.between([0.0, 180.0]))],
        options: LayerOptions { keep: Some(false), gap: GapChoice::Given(gap), ..LayerOptions::default() },
        lines: Vec::new(),
        cells: [area, aspect, gap],
    }
}

/// Areas and shapes of whole cells, and the mean width of the lines between them.
pub fn measure(sketch: &Sketch, layer: &GrownLayer, pattern: &Field) -> Errors {
    let [area, aspect, gap] = sketch.cells;
    let spots: Vec<_> = measure::spots(pattern, 0.5).into_iter().filter(|spot| spot.whole).collect();
    if spots.is_empty() {
        return Err("no whole cell".to_owned());
    }
    let mean =
        |value: &dyn Fn(&measure::Spot) -> f64| spots.iter().map(value).sum::<f64>() / spots.len() as f64;
    let between = measure::stripes(pattern, 0.5).ok_or("no lines")?;
    let OwnPolygons { own, laid } =
        layer.areas().and_then(|grown| grown.own_polygons).ok_or("nothing was laid")?;
    let aspect_error = vec![mean(&|spot| spot.ellipse.aspect()) - aspect];
    let [long, round] =
        if aspect < ROUNDEST { [aspect_error, Vec::new()] } else { [Vec::new(), aspect_error] };
    Ok(vec![
        vec![mean(&|spot| spot.ellipse.area()) / area - 1.0],
        vec![(between.wavelength - between.width) / gap - 1.0],
        long,
        round,
        vec![1.0 - own as f64 / laid as f64],
    ])
}
