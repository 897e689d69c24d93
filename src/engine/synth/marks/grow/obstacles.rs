//! Effects of the layers beneath on a layer: their marks take cells, and bias the spots between them.

use rayon::prelude::*;

use crate::synth::drawn::is_replaced;
use crate::synth::kind::{Beneath, GrownBeneath};
use crate::synth::marks::grow::measured::Measured;
use crate::synth::marks::plan::Plan;
use crate::synth::marks::plan::offset::Offset;
use crate::synth::pattern::EDGE;
use crate::synth::pattern::LayerPattern;

/// Most points that are sampled in a cell along each axis.
const POINTS: usize = 4;

/// The cells of a grid of this number of columns and rows that the marks of the layers `beneath` cover in part, row by row; empty if there
/// is no such layer. Layers that another one replaces, and layers under which the marks `pass`, take no cells.
#[must_use]
pub fn obstacles(
    beneath: &Beneath,
    [nx, ny]: [usize; 2],
    pass: &dyn Fn(&dyn GrownBeneath) -> bool,
) -> Vec<bool> {
    let shown = beneath.layers.iter().enumerate();
    let shown = shown.filter(|(below, _)| !is_replaced(beneath.document, *below));
    let shown = shown.filter(|(_, layer)| !pass(**layer));
    let shown: Vec<LayerPattern> = shown.map(|(_, layer)| layer.pattern()).collect();
    if shown.is_empty() {
        return Vec::new();
    }
    let mut taken = vec![false; nx * ny];
    for layer in &shown {
        // As many points as resolve the finest detail of this layer.
        let finer = |axis: usize, n: usize| layer.grid()[axis].div_ceil(n).clamp(1, POINTS);
        let [fx, fy] = [finer(0, nx), finer(1, ny)];
        let fine = layer.field(fx * nx, fy * ny);
        taken.par_iter_mut().enumerate().for_each(|(cell, taken)| {
            let (x, y) = (cell % nx * fx, cell / nx * fy);
            let covered = |row: usize| fine.values[row * fine.width + x..][..fx].iter().any(|v| *v >= EDGE);
            *taken = *taken || (y..y + fy).any(covered);
        });
    }
    taken
}

/// Least number of spots of a region that is corrected: the mean direction of fewer varies by chance as much as by obstacles.
const FEW: usize = 12;
/// Largest error of the direction that is not corrected, degrees.
const TOLERATED_TURN: f64 = 1.5;
/// Largest error of ln aspect that is not corrected.
const TOLERATED_ELONGATION: f64 = 0.03;

/// Rotation and stretching of the spots between obstacles, by region; `None` if both are negligible.
///
/// In a lane between two stripes a spot is rotated towards the lane: by 5.7° in a lane of two spacings.
#[must_use]
pub fn bias(plan: &Plan, measured: &Measured) -> Option<Vec<Offset>> {
    let Measured::Spots { errors, .. } = measured else { return None };
    if plan.obstacles.is_empty() {
        return None;
    }
    let found = errors.iter().map(|region| match (region.wanted, region.got) {
        (Some(wanted), Some(got)) if region.marks >= FEW => Offset {
            elongation: libm::log(wanted.aspect / got.aspect),
            turn: region.angle.unwrap_or(0.0),
            ..Offset::default()
        },
        _ => Offset::default(),
    });
    let found: Vec<Offset> = found.collect();
    let matters = |offset: &Offset| {
        offset.turn.abs() > TOLERATED_TURN || offset.elongation.abs() > TOLERATED_ELONGATION
    };
    found.iter().any(matters).then_some(found)
}
