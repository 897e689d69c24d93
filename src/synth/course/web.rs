//! A web: where two marks beneath are as near as each other.

use super::copies::Copies;
use super::room::CourseError;
use super::{Course, Grid, Wanted, Way, along, radius};
use crate::field::distance::{length, nearest};

/// Distance between two marks ÷ the web's width that a web needs between them; nearer ones are surrounded together.
pub const NEED: f64 = 1.8;
/// Nothing grows nearer to a mark than this share of the web's width.
const HALO: f64 = 0.2;
/// Inhibitor that the marks are held at: between lines there is as much.
const HELD: f32 = 0.4;
/// Pieces of the web that are less than this share of all of it are left out; larger ones are too many.
const PIECE: f64 = 0.1;
/// Where more than this share of the web finds no room it is none.
const NARROW: f64 = 0.5;

/// A web between the marks that `wanted` says.
pub fn lay(wanted: &Wanted, grid: &Grid, regions: usize) -> Result<Course, CourseError> {
    let away = nearest(wanted.taken, grid.size, grid.cell, grid.edges);
    let away = away.ok_or(CourseError::Nothing("span a web between"))?;
    let px = grid.px();
    let distance: Vec<f64> = away.iter().map(|way| (length(*way, grid.cell) - 0.5 * px).max(0.0)).collect();
    let mut copies = Copies::of(wanted.taken, grid);
    let whole = between(&away, grid, &copies);
    let all = whole.iter().filter(|set| **set).count();
    if all == 0 {
        return Err(CourseError::Single);
    }
    let width = |cell: usize| f64::from(wanted.width[cell]);
    let near = |cell: usize, other: usize| distance[cell] + distance[other] < NEED * width(cell);
    join_near(&mut copies, &away, grid, &near);
    let mut middle = between(&away, grid, &copies);
    let left = middle.iter().filter(|set| **set).count();
    let share = 1.0 - left as f64 / all as f64;
    let mean = whole.iter().enumerate().filter(|(_, set)| **set).map(|(cell, _)| width(cell)).sum::<f64>();
    let mean = mean / all as f64;
    if share > NARROW {
        return Err(CourseError::TooNarrow { lines: "webs", width: mean, need: NEED * mean, share });
    }
    one_piece(&mut middle, grid)?;
    let mut remarks = Vec::new();
    if share > 0.01 {
        remarks.push(format!(
            "a web {mean:.1} px wide needs {:.1} px between marks; {:.0} % of it has less, and marks there are surrounded \
             together",
            NEED * mean,
            100.0 * share
        ));
    }
    let to = nearest(&middle, grid.size, grid.cell, grid.edges).ok_or(CourseError::Single)?;
    let off: Vec<f32> = to.iter().map(|way| ((length(*way, grid.cell) / px) as f32 - 0.5).max(0.0)).collect();
    let kept_off: Vec<bool> = (0..grid.len()).map(|cell| distance[cell] < HALO * width(cell)).collect();
    let curve = off.iter().zip(&kept_off).map(|(off, kept)| *off < 1.0 && !kept).collect();
    let told = |cell: usize| {
        let widths = f64::from(off[cell]) * px / width(cell);
        (Way::Web.stretch(), libm::exp(-widths * widths))
    };
    let along = along(&to, grid, radius(wanted.width, grid), told);
    let held = vec![HELD; grid.len()];
    Ok(Course { way: Way::Web, off, along, kept_off, held, curve, ends: vec![(0.0, 0.0); regions], remarks })
}

/// The cell to the right and the one below, of those there are, with what each is seen to be nearest to.
fn pairs<'a>(
    away: &'a [[i32; 2]],
    grid: &'a Grid,
) -> impl Iterator<Item = (usize, usize, (usize, [i32; 2]), (usize, [i32; 2]))> + 'a {
    let seen = |cell: usize| {
        // A nearest cell lies across the border of a wrapped canvas only, so that there always is one.
        grid.away(cell, away[cell]).unwrap_or((cell, [0, 0]))
    };
    (0..away.len()).flat_map(move |cell| {
        [[1, 0], [0, 1]].into_iter().filter_map(move |side| {
            let (other, [x, y]) = grid.away(cell, side)?;
            let (mark, [mx, my]) = seen(other);
            Some((cell, other, seen(cell), (mark, [mx + x, my + y])))
        })
    })
}

/// The cells in the middle between two marks, or two copies of one.
pub fn between(away: &[[i32; 2]], grid: &Grid, copies: &Copies) -> Vec<bool> {
    let mut middle = vec![false; away.len()];
    for (cell, other, (mark, canvas), (next, beyond)) in pairs(away, grid) {
        if mark != next && copies.identity(mark, canvas) != copies.identity(next, beyond) {
            middle[cell] = true;
            middle[other] = true;
        }
    }
    middle
}

/// Makes one of all marks that are too `near` to each other somewhere.
fn join_near(copies: &mut Copies, away: &[[i32; 2]], grid: &Grid, near: &dyn Fn(usize, usize) -> bool) {
    for (cell, other, (mark, canvas), (next, beyond)) in pairs(away, grid) {
        if mark != next && near(cell, other) {
            copies.join(mark, next, [beyond[0] - canvas[0], beyond[1] - canvas[1]]);
        }
    }
}

/// Leaves the largest piece alone where the others are small.
fn one_piece(middle: &mut [bool], grid: &Grid) -> Result<(), CourseError> {
    let pieces = Copies::of(middle, grid);
    let mut sizes = vec![0usize; middle.len()];
    for cell in (0..middle.len()).filter(|cell| middle[*cell]) {
        sizes[pieces.find(cell).0] += 1;
    }
    let all: usize = sizes.iter().sum();
    let largest = (0..sizes.len()).fold(0, |best, root| if sizes[root] > sizes[best] { root } else { best });
    let parts = sizes.iter().filter(|size| **size as f64 > PIECE * all as f64).count();
    if parts > 1 {
        return Err(CourseError::Parts(parts));
    }
    for (cell, set) in middle.iter_mut().enumerate() {
        *set = *set && pieces.find(cell).0 == largest;
    }
    Ok(())
}
