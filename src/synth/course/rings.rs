//! Rings: round each mark beneath, at the same distance everywhere; one wall for both where two marks are near.

use super::copies::Copies;
use super::gaps::{Gaps, open};
use super::room::CourseError;
use super::web::between;
use super::{Course, Grid, Wanted, Way, along, radius};
use crate::field::distance::{length, nearest};

/// Half the width of the lane in which a ring is free to grow ÷ its own width: all beyond is held. It keeps rings where
/// they are, and neighbours from taking each other's room; without it they shrink until they stand against their
/// marks, and of neighbours that are near one dies.
const LANE: f64 = 0.85;
/// The least half of a lane: below it no line lives.
const NARROWEST: f64 = 0.7;
/// Inhibitor that is held on the inner and the outer side of a ring. Round marks of 1 to 6 ring widths these keep it in
/// the middle of its lane, open or closed, from T = 30 to 80; with as much on both sides it slides inwards.
const SIDES: [f64; 2] = [0.45, 0.2];
/// The same on both sides of a wall that two marks share.
const WALL: f64 = 0.3;

/// Half the distance between two marks ÷ the width of rings, below which their rings are one wall: lanes would overlap.
pub const SHARED: f64 = 2.0 * LANE;
/// The same from which on each has its own place; the wall forks in between.
pub const OWN: f64 = SHARED + 0.5;

/// An outline is ringed where a ring passes within this many widths of it.
const NEAR: f64 = 2.0;
/// Outlines that are ringed less than this are told, and refused below the second.
const RINGED: [f64; 2] = [0.95, 0.5];

/// Rings round the marks that `wanted` says.
pub fn lay(
    wanted: &Wanted,
    grid: &Grid,
    regions: usize,
    region_of: &dyn Fn([f64; 2]) -> usize,
) -> Result<Course, CourseError> {
    let away = nearest(wanted.taken, grid.size, grid.cell, grid.edges);
    let away = away.ok_or(CourseError::Nothing("ring"))?;
    let px = grid.px();
    // A covered cell's edge is half a cell before its middle.
    let distance: Vec<f64> = away.iter().map(|way| (length(*way, grid.cell) - 0.5 * px).max(0.0)).collect();
    let copies = Copies::of(wanted.taken, grid);
    let room = room(grid, &between(&away, grid, &copies), &distance);
    let width = |cell: usize| f64::from(wanted.width[cell]);
    let at = |cell: usize| place(room[cell] / width(cell)) * width(cell);
    let off: Vec<f32> =
        (0..grid.len()).map(|cell| ((distance[cell] - at(cell)).abs() / px) as f32).collect();
    let narrow = |cell: usize| room[cell] < NARROWEST * width(cell) && distance[cell] < width(cell);
    let mut kept_off: Vec<bool> = (0..grid.len())
        .map(|cell| f64::from(off[cell]) * px > LANE * width(cell) || narrow(cell))
        .collect();
    let mut curve: Vec<bool> = off.iter().zip(&kept_off).map(|(off, kept)| *off < 1.0 && !kept).collect();
    let mut remarks = Vec::new();
    told(wanted, grid, &curve, &mut remarks)?;
    let mut ends = vec![(0.0, 0.0); regions];
    if wanted.broken > 0.0 {
        let Gaps { opened, ends: places } = open(wanted, grid, &off, &curve, |cell| {
            let to = grid.away(cell, away[cell]);
            to.map_or(cell, |(cell, _)| copies.find(cell).0)
        });
        places.iter().for_each(|place| ends[region_of(*place)].0 += 1.0);
        for (cell, opened) in opened.iter().enumerate() {
            kept_off[cell] |= opened;
            curve[cell] &= !opened;
            if curve[cell] && off[cell] < 0.5 {
                ends[region_of(grid.middle(cell))].1 += px;
            }
        }
    }
    let held = (0..grid.len())
        .map(|cell| {
            let own = ((room[cell] / width(cell) - SHARED) / (OWN - SHARED)).clamp(0.0, 1.0);
            let side = SIDES[usize::from(distance[cell] > at(cell))];
            (WALL + own * (side - WALL)) as f32
        })
        .collect();
    let along = along(Way::Rings, &away, grid, radius(wanted.width, grid), |_| 0.0);
    Ok(Course { way: Way::Rings, off, along, kept_off, held, curve, ends, remarks })
}

/// Distance of a ring's middle from its mark, ÷ its width, where half the distance to the next mark is so many widths.
fn place(room: f64) -> f64 {
    if room < SHARED {
        return room.max(LANE);
    }
    let apart = ((room - SHARED) / (OWN - SHARED)).min(1.0);
    SHARED + apart * (LANE - SHARED)
}

/// Half the distance between the two marks whose middle is nearest to each cell, px.
fn room(grid: &Grid, middle: &[bool], distance: &[f64]) -> Vec<f64> {
    let Some(to) = nearest(middle, grid.size, grid.cell, grid.edges) else {
        return vec![f64::INFINITY; grid.len()];
    };
    let at = |cell: usize| grid.away(cell, to[cell]).map_or(f64::INFINITY, |(at, _)| distance[at]);
    (0..grid.len()).map(at).collect()
}

/// How much of the outlines has a ring, where that is not all of them.
fn told(
    wanted: &Wanted,
    grid: &Grid,
    curve: &[bool],
    remarks: &mut Vec<String>,
) -> Result<(), CourseError> {
    let outline: Vec<usize> = (0..grid.len())
        .filter(|cell| wanted.taken[*cell])
        .filter(|cell| {
            let sides = [[1, 0], [-1, 0], [0, 1], [0, -1]].iter();
            sides.filter_map(|side| grid.away(*cell, *side)).any(|(side, _)| !wanted.taken[side])
        })
        .collect();
    let to = nearest(curve, grid.size, grid.cell, grid.edges);
    let near = |cell: &&usize| {
        let width = f64::from(wanted.width[**cell]);
        to.as_ref().is_some_and(|to| length(to[**cell], grid.cell) < NEAR * width)
    };
    let share = outline.iter().filter(near).count() as f64 / outline.len().max(1) as f64;
    if share >= RINGED[0] {
        return Ok(());
    }
    let width = outline.iter().map(|cell| f64::from(wanted.width[*cell])).sum::<f64>() / outline.len() as f64;
    let need = 2.0 * NARROWEST * width;
    if share < RINGED[1] {
        return Err(CourseError::TooNarrow { lines: "rings", width, need, share: 1.0 - share });
    }
    remarks.push(format!(
        "rings {width:.1} px wide need {need:.1} px between marks; {:.0} % of their outlines have less, and marks there \
         are ringed together",
        100.0 * (1.0 - share)
    ));
    Ok(())
}
