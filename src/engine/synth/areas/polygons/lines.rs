//! The initial lines between cells, and the thresholds that keep drawn marks.

use rayon::prelude::*;

use super::owned::{Owned, TAKEN};
use crate::grid::Domain;
use crate::grid::distance::{length, nearest};
use crate::points::extent::Extent;
use crate::points::patches::Outlines;
use crate::synth::areas::plan::AreaPlan;

/// Decrease of the threshold in drawn marks and increase on the lines around them, in K₀: larger than any difference.
const HELD: f32 = 1.0;
/// Width of the ring around marks of the layers beneath in which no cell grows, in widths of a line.
const CLEAR: f64 = 0.9;
/// Distances from a drawn outline, in widths of a line, between which the pattern is held. The edge itself is not.
const HOLDS: [f64; 2] = [0.2, 0.8];

/// By cell of the grid, the depth inside a drawn outline, px, and the index of this outline. The depth is negative outside, and −∞
/// farther off than the width of a line, `gap`. Empty if no outline is kept.
pub(super) fn depths_of_kept(plan: &AreaPlan, gap: f64) -> Vec<(f32, u32)> {
    if plan.kept.is_empty() {
        return Vec::new();
    }
    let kept = Outlines::new(plan.kept.iter().map(|(_, outline)| outline), &Extent::from(plan.canvas()));
    let deepest = |cell: usize| match kept.deepest(plan.grid.center_px(cell), gap) {
        Some((depth, index)) => (depth as f32, index),
        None => (f32::NEG_INFINITY, 0),
    };
    (0..plan.grid.cells()).into_par_iter().map(deepest).collect()
}

/// The reaction at each cell: 0 within half a `gap` of the border between two owners, 1 elsewhere. The border between two laid
/// points is known exactly, so that lines have no steps of the grid.
pub(super) fn lines_between(owned: &Owned, depths: &[(f32, u32)], plan: &AreaPlan, gap: f64) -> Vec<f32> {
    let ([nx, ny], grid) = (plan.grid.size, &plan.grid);
    let owner = |cell: usize| match depths.get(cell) {
        Some((depth, mark)) if f64::from(*depth) > -0.5 * gap && owned.owners[cell] != TAKEN => {
            TAKEN - 1 - mark
        }
        _ => owned.owners[cell],
    };
    let owners: Vec<u32> = (0..grid.cells()).map(owner).collect();
    let at = |x: isize, y: isize| owners[grid.edges.index(y, ny) * nx + grid.edges.index(x, nx)];
    let beside = |cell: usize| {
        let [x, y] = grid.position(cell).map(|k| k as isize);
        [(1, 0), (-1, 0), (0, 1), (0, -1)].map(|(dx, dy)| at(x + dx, y + dy))
    };
    let is_border = |cell: usize| beside(cell).iter().any(|other| *other != owners[cell]);
    let border: Vec<bool> = (0..grid.cells()).map(is_border).collect();
    let px = plan.px_a_cell();
    let Some(ways) = nearest(&border, grid) else {
        return owners.iter().map(|owner| f32::from(u8::from(*owner != TAKEN))).collect();
    };
    // The distance of a cell from the border beside its nearest marked cell, `way` from it.
    let exact = |cell: usize, way: [i32; 2]| {
        let [x, y] = grid.position(cell).map(|k| k as isize);
        let [x, y] = [x + way[0] as isize, y + way[1] as isize];
        let marked = grid.edges.index(y, ny) * nx + grid.edges.index(x, nx);
        let [back, up] = grid.to_px(way.map(|cells| -f64::from(cells)));
        let own = owners[cell];
        let mut others = beside(marked).into_iter().filter(|other| *other != own);
        others.try_fold(f64::INFINITY, |least, other| {
            let (depth, [right, down]) = owned.border(grid.center_px(marked), own, other)?;
            Some(least.min(depth + back * right + up * down))
        })
    };
    let reaction = |(cell, way): (usize, &[i32; 2])| {
        if owners[cell] == TAKEN {
            return 0.0;
        }
        // Without an exact one, the border runs between two cells that are both marked.
        let rough = length(*way, grid) + 0.5 * px;
        let is_near = rough < gap + 2.0 * px;
        let away = if is_near { exact(cell, *way).filter(|away| away.is_finite()) } else { None };
        ((away.unwrap_or(rough) - 0.5 * gap) / px + 0.5).clamp(0.0, 1.0) as f32
    };
    ways.par_iter().enumerate().map(reaction).collect()
}

/// Increase of the threshold at each cell, in K₀, which keeps drawn marks as drawn, and cells away from the layers beneath; empty
/// if there are neither.
pub(super) fn held(depths: &[(f32, u32)], plan: &AreaPlan, gap: f64) -> Vec<f32> {
    let beneath = nearest(&plan.obstacles, &plan.grid);
    if depths.is_empty() && beneath.is_none() {
        return Vec::new();
    }
    let raised = |cell: usize| {
        if beneath.as_ref().is_some_and(|ways| length(ways[cell], &plan.grid) < CLEAR * gap) {
            return HELD;
        }
        let depth = depths.get(cell).map_or(f64::NEG_INFINITY, |(depth, _)| f64::from(*depth) / gap);
        if depth > HOLDS[0] {
            -HELD
        } else if (-HOLDS[1]..-HOLDS[0]).contains(&depth) {
            HELD
        } else {
            0.0
        }
    };
    (0..plan.grid.cells()).into_par_iter().map(raised).collect()
}
