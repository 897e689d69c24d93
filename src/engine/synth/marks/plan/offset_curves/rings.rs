//! Rings: offset curves of the marks beneath, at one distance everywhere; marks close together share one wall.

use crate::grid::distance::{length, nearest};
use crate::grid::{Domain, Grid};
use crate::rd::LinesAlongCurves;
use crate::synth::error::CurvesError;
use crate::synth::marks::plan::offset_curves::copies::Copies;
use crate::synth::marks::plan::offset_curves::gaps::{Gaps, open};
use crate::synth::marks::plan::offset_curves::medial_axis::between;
use crate::synth::marks::plan::offset_curves::{CurveRequest, Curves, blur_radius, directions};

/// Half the width of the zone in which a ring can move, in widths of the ring: cells outside are blocked. The zone keeps rings in
/// place, and keeps them from taking the room of their neighbours. Without it rings shrink until they touch their marks, and of two
/// close ones one vanishes.
pub const LANE: f64 = 0.8;
/// The least half width of a zone: in narrower ones no line survives.
pub const NARROWEST: f64 = 0.7;
/// Inhibitor that is held on the inner and the outer side of a ring. For round marks of 1 to 6 ring widths these values keep the
/// ring in the centre of its zone, open or closed, from T = 30 to 80; with equal values on both sides it moves inwards.
pub const SIDES: [f32; 2] = [0.45, 0.2];
/// Inhibitor that is held on both sides of a wall that two marks share.
pub const WALL: f32 = 0.3;

/// Half the distance between two marks, in ring widths, below which they share one wall.
pub const SHARED: f64 = 1.6;
/// Between two rings closer than the first value nothing grows in a strip, whose half width is this number of widths (the
/// second value): otherwise one ring takes the other's room.
pub const STRIP: [f64; 2] = [1.9, 0.1];
/// Distance between two marks, in ring widths, from which on each has its own ring.
pub const OWN: f64 = 2.0 * SHARED;

/// Largest share of the outlines without room for a ring of their own. With a larger one there are no rings: walls from all sides
/// would leave only remnants.
pub const CROWDED: f64 = 0.7;

/// Lays rings around the obstacles of `request`.
pub fn lay(
    request: &CurveRequest,
    grid: &Grid,
    regions: usize,
    region_of: &dyn Fn([f64; 2]) -> usize,
) -> Result<Curves, CurvesError> {
    let away = nearest(request.obstacles, grid);
    let away = away.ok_or(CurvesError::Nothing("ring"))?;
    let px = grid.px_a_cell();
    // The edge of a covered cell is half a cell before its centre.
    let distance: Vec<f64> = away.iter().map(|way| (length(*way, grid) - 0.5 * px).max(0.0)).collect();
    let copies = Copies::connect(request.obstacles, grid);
    let room = room(grid, &between(&away, grid, &copies), &distance);
    let width = |cell: usize| f64::from(request.width[cell]);
    let at = |cell: usize| place(room[cell] / width(cell)) * width(cell);
    let off: Vec<f32> =
        (0..grid.cells()).map(|cell| ((distance[cell] - at(cell)).abs() / px) as f32).collect();
    let has_own = |cell: usize| room[cell] >= SHARED * width(cell);
    let narrow = |cell: usize| room[cell] < NARROWEST * width(cell) && distance[cell] < width(cell);
    let between_rings = |cell: usize| {
        let room = room[cell] / width(cell);
        (SHARED..STRIP[0]).contains(&room) && distance[cell] / width(cell) > room - STRIP[1]
    };
    let mut blocked: Vec<bool> = (0..grid.cells())
        .map(|cell| f64::from(off[cell]) * px > LANE * width(cell) || narrow(cell) || between_rings(cell))
        .collect();
    let mut curve: Vec<bool> =
        off.iter().zip(&blocked).map(|(off, blocked)| *off < 1.0 && !blocked).collect();
    let mut remarks = Vec::new();
    check_room(request, grid, &has_own, &mut remarks)?;
    let mut ends = vec![(0.0, 0.0); regions];
    if request.broken > 0.0 {
        let Gaps { opened, ends: places } = open(request, grid, &off, &curve, |cell| {
            let to = grid.step(cell, away[cell]);
            to.map_or(cell, |(cell, _)| copies.find(cell).0)
        });
        places.iter().for_each(|place| ends[region_of(*place)].0 += 1.0);
        for (cell, opened) in opened.iter().enumerate() {
            blocked[cell] |= opened;
            curve[cell] &= !opened;
            if curve[cell] && off[cell] < 0.5 {
                ends[region_of(grid.center_px(cell))].1 += px;
            }
        }
    }
    let inhibitor = (0..grid.cells())
        .map(|cell| if has_own(cell) { SIDES[usize::from(distance[cell] > at(cell))] } else { WALL })
        .collect();
    let LinesAlongCurves { ratio, ratio_at_junctions, rings, web } = request.laws;
    let radius = blur_radius(request.width, grid);
    let directions = directions(&away, grid, radius, [ratio, ratio_at_junctions], |cell| {
        let law = if has_own(cell) { rings } else { web };
        (law.stretch, if has_own(cell) { 0.0 } else { 1.0 })
    });
    Ok(Curves { distance: off, directions, blocked, inhibitor, curve, ends, remarks })
}

/// Distance of a ring's centre line from its mark, in ring widths, if half the distance to the next mark is `room` widths.
pub fn place(room: f64) -> f64 {
    if room < SHARED { room.max(LANE) } else { LANE }
}

/// Half the distance between the two marks whose medial axis is nearest to each cell, px.
fn room(grid: &Grid, medial: &[bool], distance: &[f64]) -> Vec<f64> {
    let Some(to) = nearest(medial, grid) else {
        return vec![f64::INFINITY; grid.cells()];
    };
    let at = |cell: usize| grid.step(cell, to[cell]).map_or(f64::INFINITY, |(at, _)| distance[at]);
    (0..grid.cells()).map(at).collect()
}

/// Refuses rings with too little room, and remarks on rings of which some have too little.
fn check_room(
    request: &CurveRequest,
    grid: &Grid,
    has_own: &dyn Fn(usize) -> bool,
    remarks: &mut Vec<String>,
) -> Result<(), CurvesError> {
    let outline: Vec<usize> = (0..grid.cells())
        .filter(|cell| request.obstacles[*cell])
        .filter(|cell| {
            let sides = [[1, 0], [-1, 0], [0, 1], [0, -1]].iter();
            sides.filter_map(|side| grid.step(*cell, *side)).any(|(side, _)| !request.obstacles[side])
        })
        .collect();
    if outline.is_empty() {
        return Err(CurvesError::Nothing("ring"));
    }
    let all = outline.len() as f64;
    let share = outline.iter().filter(|cell| !has_own(**cell)).count() as f64 / all;
    let width = outline.iter().map(|cell| f64::from(request.width[*cell])).sum::<f64>() / all;
    let need = OWN * width;
    if share > CROWDED {
        return Err(CurvesError::TooNarrow { lines: "rings", width, need, share });
    }
    if share > 0.005 {
        remarks.push(format!(
            "rings {width:.1} px wide need {need:.1} px between marks; {:.0} % of the outlines have less, and neighbours \
             share a wall there",
            100.0 * share
        ));
    }
    Ok(())
}
