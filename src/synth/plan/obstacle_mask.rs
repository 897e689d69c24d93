//! What the layers beneath have grown: their marks are frozen, and what grows next keeps out of them.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::grid::Edges;
use crate::grid::distance::{length, nearest};
use crate::synth::grow::probe::Offset;
use crate::synth::grow::refine::Measured;
use crate::synth::plan::Plan;
use crate::synth::render::pattern::Pattern;

/// From this pattern value on a place belongs to a mark.
pub const COVERED: f32 = 0.5;
/// Points that a cell is asked at, each way, at most.
const POINTS: usize = 4;

/// Which cells of a grid of `nx` × `ny` over the canvas the marks of `layers` reach into, row by row.
#[must_use]
pub fn taken(layers: &[Pattern], [nx, ny]: [usize; 2]) -> Vec<bool> {
    let mut taken = vec![false; nx * ny];
    for layer in layers {
        // As many points as show the finest that this layer has grown.
        let finer = |axis: usize, n: usize| layer.grid()[axis].div_ceil(n).clamp(1, POINTS);
        let [fx, fy] = [finer(0, nx), finer(1, ny)];
        let fine = layer.field(fx * nx, fy * ny);
        taken.par_iter_mut().enumerate().for_each(|(cell, taken)| {
            let (x, y) = (cell % nx * fx, cell / nx * fy);
            let covered =
                |row: usize| fine.values[row * fine.width + x..][..fx].iter().any(|v| *v >= COVERED);
            *taken = *taken || (y..y + fy).any(covered);
        });
    }
    taken
}

/// The same with the cells beside them, for stripes: these end on the frozen cells, and by less than a cell on the marks.
/// Of 224 that end on marks eight touched one; so none.
#[must_use]
pub fn with_rim(taken: &[bool], [nx, ny]: [usize; 2], edges: Edges) -> Vec<bool> {
    let near = |cell: usize| {
        let (x, y) = ((cell % nx) as isize, (cell / nx) as isize);
        let mut around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
        around.any(|(x, y)| taken[edges.index(y, ny) * nx + edges.index(x, nx)])
    };
    (0..taken.len()).into_par_iter().map(near).collect()
}

/// Is there a place where the stripes of `plan` fit between what is taken: as far from it as half a stripe is wide?
#[must_use]
pub fn has_room(plan: &Plan) -> bool {
    let [nx, ny] = plan.grid;
    let Some(ways) = nearest(&plan.taken, plan.grid, plan.cell, plan.map.layout().edges) else { return true };
    (0..nx * ny).into_par_iter().any(|cell| {
        let at = plan.place([(cell % nx) as f64 + 0.5, (cell / nx) as f64 + 0.5]);
        let Attributes::Stripes(wanted) = plan.map.at(at) else { return false };
        // To the near side of what is taken, not to the middle of its cell.
        2.0 * length(ways[cell], plan.cell) - plan.px_a_cell() >= wanted.width
    })
}

/// A region of fewer spots is left as it is: so few turn by chance as much as by what is beside them.
const FEW: usize = 12;
/// Errors of the direction, degrees, and of ln aspect that are left.
const LEFT: [f64; 2] = [1.5, 0.03];

/// How marks beneath turn and stretch the spots between them, by region; `None` where they hardly do.
///
/// In a lane between two stripes a spot leans along it: by 5.7° in one of two spacings.
#[must_use]
pub fn shaped(plan: &Plan, measured: &Measured) -> Option<Vec<Offset>> {
    let Measured::Spots { errors, .. } = measured else { return None };
    if plan.taken.is_empty() {
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
    let shaped = |offset: &Offset| offset.turn.abs() > LEFT[0] || offset.elongation.abs() > LEFT[1];
    found.iter().any(shaped).then_some(found)
}
