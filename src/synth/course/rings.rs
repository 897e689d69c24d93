//! Rings: round each mark beneath, at the same distance everywhere.

use super::copies::Copies;
use super::gaps::{Gaps, open};
use super::room::CourseError;
use super::{Course, Grid, Wanted, Way, along, radius};
use crate::field::distance::{length, nearest};

/// Nothing grows nearer to a mark than this share of a ring's width. Rings shrink until they stand against it.
pub const HALO: f64 = 0.3;
/// Distance from there to the middle of a ring at rest ÷ its width.
pub const AWAY: f64 = 0.45;
/// Rings whose middles are nearer to each other than this share of their width are one wall for both.
pub const SHARED: f64 = 1.1;
/// The least room for such a wall between two halos ÷ its width; below, one ring goes round both marks.
const WALL: f64 = 0.8;

/// An outline is ringed where a ring passes within this many widths of it.
const NEAR: f64 = 1.8;
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
    let width = |cell: usize| f64::from(wanted.width[cell]);
    let copies = Copies::of(wanted.taken, grid);
    let walls = walls(wanted, grid, &away, &distance, &copies);
    let off: Vec<f32> = (0..grid.len())
        .map(|cell| {
            let own = (distance[cell] - (HALO + AWAY) * width(cell)).abs();
            (walls[cell].unwrap_or(own) / px) as f32
        })
        .collect();
    let mut kept_off: Vec<bool> = (0..grid.len()).map(|cell| distance[cell] < HALO * width(cell)).collect();
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
    let along = along(&away, grid, radius(wanted.width, grid), |_| 0.0);
    Ok(Course { way: Way::Rings, off, along, kept_off, curve, ends, remarks })
}

/// Where two marks are so near to each other that their rings are one wall: the distance to the middle between them, px.
fn walls(
    wanted: &Wanted,
    grid: &Grid,
    away: &[[i32; 2]],
    distance: &[f64],
    copies: &Copies,
) -> Vec<Option<f64>> {
    let middle = super::web::between(away, grid, copies);
    let Some(to) = nearest(&middle, grid.size, grid.cell, grid.edges) else {
        return vec![None; grid.len()];
    };
    (0..grid.len())
        .map(|cell| {
            let (at, _) = grid.away(cell, to[cell])?;
            let width = f64::from(wanted.width[cell]);
            let half = distance[at] / width - HALO;
            let shared = (0.5 * WALL..AWAY + 0.5 * SHARED).contains(&half);
            shared.then(|| (length(to[cell], grid.cell) - 0.5 * grid.px()).max(0.0))
        })
        .collect()
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
    let need = (2.0 * HALO + WALL) * width;
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
