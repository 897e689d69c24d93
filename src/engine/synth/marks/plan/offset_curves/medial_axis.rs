//! Webs: the medial axis, where the distances to two marks beneath are equal.

use crate::grid::distance::{length, nearest};
use crate::grid::{Domain, Grid};
use crate::rd::LinesAlongCurves;
use crate::synth::error::CurvesError;
use crate::synth::marks::plan::offset_curves::copies::Copies;
use crate::synth::marks::plan::offset_curves::{CurveRequest, Curves, blur_radius, directions};

/// Distance between two marks that a web needs, in widths of the web; closer marks are surrounded together.
pub const NEED: f64 = 1.8;
/// Width of the zone around a mark in which nothing grows, in widths of the web.
pub const HALO: f64 = 0.2;
/// Half the width of the zone in which a web can move, in widths of the web; outside it concentrations are held. Without the zone
/// the web breaks where lines meet, from T = 100 on.
pub const LANE: f64 = 1.3;
/// Inhibitor that is held on both sides: at 0.25 and less, lines slide to one side of their zone; at 0.4 and more they vanish in
/// narrow zones.
pub const HELD: f32 = 0.33;
/// Largest share of the web in a piece that is left out; two larger pieces are an error.
pub const PIECE: f64 = 0.1;
/// Largest share of the web that may be without room.
pub const NARROW: f64 = 0.5;

/// Lays a web between the obstacles of `request`.
pub fn lay(request: &CurveRequest, grid: &Grid, regions: usize) -> Result<Curves, CurvesError> {
    let away = nearest(request.obstacles, grid);
    let away = away.ok_or(CurvesError::Nothing("span a web between"))?;
    let px = grid.px_a_cell();
    let distance: Vec<f64> = away.iter().map(|way| (length(*way, grid) - 0.5 * px).max(0.0)).collect();
    let mut copies = Copies::connect(request.obstacles, grid);
    let whole = between(&away, grid, &copies);
    let all = whole.iter().filter(|set| **set).count();
    if all == 0 {
        return Err(CurvesError::Single);
    }
    let width = |cell: usize| f64::from(request.width[cell]);
    let near = |[cell, other]: [usize; 2]| distance[cell] + distance[other] < NEED * width(cell);
    join_near(&mut copies, &away, grid, &near);
    let mut medial = between(&away, grid, &copies);
    let left = medial.iter().filter(|set| **set).count();
    let share = 1.0 - left as f64 / all as f64;
    let mean = whole.iter().enumerate().filter(|(_, set)| **set).map(|(cell, _)| width(cell)).sum::<f64>();
    let mean = mean / all as f64;
    if share > NARROW {
        return Err(CurvesError::TooNarrow { lines: "webs", width: mean, need: NEED * mean, share });
    }
    one_piece(&mut medial, grid)?;
    let mut remarks = Vec::new();
    if share > 0.01 {
        remarks.push(format!(
            "a web {mean:.1} px wide needs {:.1} px between marks; {:.0} % of it has less, and marks there are surrounded \
             together",
            NEED * mean,
            100.0 * share
        ));
    }
    let to = nearest(&medial, grid).ok_or(CurvesError::Single)?;
    let off: Vec<f32> = to.iter().map(|way| ((length(*way, grid) / px) as f32 - 0.5).max(0.0)).collect();
    let blocked: Vec<bool> = (0..grid.cells())
        .map(|cell| distance[cell] < HALO * width(cell) || f64::from(off[cell]) * px > LANE * width(cell))
        .collect();
    let curve = off.iter().zip(&blocked).map(|(off, blocked)| *off < 1.0 && !blocked).collect();
    let LinesAlongCurves { ratio, ratio_at_junctions, web, .. } = request.laws;
    let stretch_and_meeting = |cell: usize| {
        let widths = f64::from(off[cell]) * px / width(cell);
        (web.stretch, libm::exp(-widths * widths))
    };
    let radius = blur_radius(request.width, grid);
    let directions = directions(&to, grid, radius, [ratio, ratio_at_junctions], stretch_and_meeting);
    let inhibitor = vec![HELD; grid.cells()];
    let ends = vec![(0.0, 0.0); regions];
    Ok(Curves { distance: off, directions, blocked, inhibitor, curve, ends, remarks })
}

/// A cell of a mark, and its distance in canvases.
type MarkCopy = (usize, [i32; 2]);

/// Two neighbouring cells and the cell of a mark that is nearest to each, relative to the canvas of the first.
struct Pair {
    cells: [usize; 2],
    marks: [MarkCopy; 2],
}

impl Pair {
    /// Whether both are nearest to one mark, and to one copy of it.
    fn is_of_one_mark(&self, copies: &Copies) -> bool {
        let [(mark, canvas), (next, beyond)] = self.marks;
        mark == next && canvas == beyond || copies.identity(mark, canvas) == copies.identity(next, beyond)
    }
}

/// Each cell with its right and with its lower neighbour, where there is one.
fn pairs<'a>(away: &'a [[i32; 2]], grid: &'a Grid) -> impl Iterator<Item = Pair> + 'a {
    // The border of a wrapped canvas is the only border across which a nearest cell can lie, so that the step always exists.
    let seen = |cell: usize| grid.step(cell, away[cell]).unwrap_or((cell, [0, 0]));
    (0..away.len()).flat_map(move |cell| {
        [[1, 0], [0, 1]].into_iter().filter_map(move |side| {
            let (other, [x, y]) = grid.step(cell, side)?;
            let (mark, [mx, my]) = seen(other);
            Some(Pair { cells: [cell, other], marks: [seen(cell), (mark, [mx + x, my + y])] })
        })
    })
}

/// The cells in the middle between two marks, or two copies of one.
pub fn between(away: &[[i32; 2]], grid: &Grid, copies: &Copies) -> Vec<bool> {
    let mut medial = vec![false; away.len()];
    for pair in pairs(away, grid).filter(|pair| !pair.is_of_one_mark(copies)) {
        pair.cells.iter().for_each(|cell| medial[*cell] = true);
    }
    medial
}

/// Joins marks that are too `near` to each other somewhere.
fn join_near(copies: &mut Copies, away: &[[i32; 2]], grid: &Grid, near: &dyn Fn([usize; 2]) -> bool) {
    for pair in pairs(away, grid) {
        if !pair.is_of_one_mark(copies) && near(pair.cells) {
            let [(mark, [x, y]), (next, [bx, by])] = pair.marks;
            copies.join(mark, next, [bx - x, by - y]);
        }
    }
}

/// Removes all pieces but the largest, if the others are small.
fn one_piece(medial: &mut [bool], grid: &Grid) -> Result<(), CurvesError> {
    let pieces = Copies::connect(medial, grid);
    let mut sizes = vec![0usize; medial.len()];
    for cell in (0..medial.len()).filter(|cell| medial[*cell]) {
        sizes[pieces.find(cell).0] += 1;
    }
    let all: usize = sizes.iter().sum();
    let largest = (0..sizes.len()).fold(0, |best, root| if sizes[root] > sizes[best] { root } else { best });
    let parts = sizes.iter().filter(|size| **size as f64 > PIECE * all as f64).count();
    if parts > 1 {
        return Err(CurvesError::Parts(parts));
    }
    for (cell, set) in medial.iter_mut().enumerate() {
        *set = *set && pieces.find(cell).0 == largest;
    }
    Ok(())
}
