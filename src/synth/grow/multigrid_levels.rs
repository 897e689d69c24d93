//! Coarse grids under the planned one.
//!
//! Steps to settle go with a spot's area in cells. So a pattern is formed where its marks are as small, in cells, as
//! the grid can hold, and then brought to finer grids, where it only has to give up what the coarse one did to it.
//! Where marks differ in size, the large ones are formed on coarse grids that the small ones are too small for; these
//! begin on the first grid that holds them.
//!
//! The cells that marks need ([`Resolution`]) were tuned on patches of 86 spots and 10 wavelengths, against plain Euler
//! on 48 cells a spot and 8 a stripe to T ≥ 120: coarser than this, what the grid does to area, aspect and angle outlives
//! the time saved.

use rayon::prelude::*;

use crate::grid::Domain;
use crate::rd::{Maps, Resolution, System};
use crate::synth::plan::mark_cells::resolving_cells;

/// Marks on the coarsest grid that holds the smallest, ÷ `enough`: some room for what the laws of area leave out.
const ROOM: f64 = 1.09;
/// A grid less coarse than this along a side is not worth its own steps.
const WORTH: f64 = 1.3;
/// How much coarser the next grid is along a side.
const NEXT: f64 = 2.0;
/// Cells that a coarse grid has at least along either side.
const LEAST_SIDE: f64 = 12.0;
/// A place formed on a coarser grid needs corrections until its marks have this many times `enough` cells there.
const EXACT: f64 = 8.0;

/// Grids from the coarsest to that of `maps`: none that would hold only marks of more than `most` cells.
#[must_use]
pub fn grids(system: System, maps: &Maps, most: f64) -> Vec<[usize; 2]> {
    if maps.curves.is_some() {
        // What is told by cell, on which side of a curve it lies, no coarser grid can tell.
        return vec![maps.grid.size];
    }
    let enough = system.definition().resolution.enough * ROOM;
    let least = maps.parameters.iter().map(|p| resolving_cells(system, p)).fold(f64::INFINITY, f64::min);
    let mut factors = vec![1.0];
    let first = (least / enough).sqrt();
    if first >= WORTH {
        let levels = (libm::log(first / 1.15) / libm::log(NEXT)).ceil().max(1.0);
        factors.extend((1..=levels as usize).map(|level| libm::pow(first, level as f64 / levels)));
    }
    while let Some(next) = factors.last().map(|factor| factor * NEXT)
        && most / (next * next) >= enough
    {
        factors.push(next);
    }
    let side = |n: usize, factor: f64| n as f64 / factor;
    let [nx, ny] = maps.grid.size;
    factors.retain(|f| *f == 1.0 || side(nx.min(ny), *f) >= LEAST_SIDE);
    let grid = |f: &f64| [side(nx, *f), side(ny, *f)].map(|n| n.round() as usize);
    factors.iter().rev().map(grid).collect()
}

/// What is to be done on one grid.
#[derive(Clone, Debug)]
pub struct Work {
    /// By cell: the share of what a coarser grid formed that is taken over; empty on the coarsest.
    pub kept: Vec<f32>,
    /// By cell: whether something still forms or is corrected here. What is finished, or too small here, does not
    /// count when it is asked whether the pattern still changes.
    pub counts: Vec<bool>,
    /// Does anything begin here?
    pub begins: bool,
    /// Normalised times are counted where the reactions are this slow, ÷ the slowest rate on the grid.
    pub pace: f64,
}

/// The parameters to grow on `grid`: where marks are too small for it, larger ones; whether a cell is such a one.
#[must_use]
pub fn coarse(system: System, maps: &Maps, grid: [usize; 2]) -> (Maps, Vec<bool>) {
    let least = system.definition().resolution.least;
    let area = maps.grid.cells() as f64 / (grid[0] * grid[1]) as f64;
    let mut coarse = maps.on_grid(grid);
    let lost = coarse
        .parameters
        .par_iter_mut()
        .map(|p| {
            let share = resolving_cells(system, p) / least;
            if share < 1.0 {
                p.rate *= share as f32;
            } else {
                *p = system.compensated(p, area);
            }
            share < 1.0
        })
        .collect();
    (coarse, lost)
}

/// What is to be done on a grid whose parameters are `maps`; the next coarser has cells `coarser` times the area.
///
/// `lost` says where marks are too small for this one.
#[must_use]
pub fn work(system: System, maps: &Maps, lost: &[bool], coarser: Option<f64>) -> Work {
    let Resolution { least, enough, .. } = system.definition().resolution;
    let cells: Vec<f64> = maps.parameters.iter().map(|p| resolving_cells(system, p)).collect();
    let share = |cells: f64| {
        let t = ((cells - least) / (enough - least)).clamp(0.0, 1.0);
        (t * t * (3.0 - 2.0 * t)) as f32
    };
    let kept: Vec<f32> =
        coarser.map_or_else(Vec::new, |area| cells.iter().map(|cells| share(cells / area)).collect());
    let slowest = maps.parameters.iter().map(|p| p.rate).fold(f32::INFINITY, f32::min);
    let is_lost = |cell: usize| lost.get(cell).copied().unwrap_or(false);
    let begins = |cell: usize| kept.get(cell).is_none_or(|kept| *kept < 0.5) && !is_lost(cell);
    let any = (0..cells.len()).any(begins);
    let mut pace = 0.0f64;
    let counts = (0..cells.len())
        .map(|cell| {
            let time = f64::from(slowest / maps.parameters[cell].rate);
            if any {
                if begins(cell) {
                    pace = pace.max(time);
                }
                return begins(cell) || !is_lost(cell) && cells[cell] < EXACT * enough;
            }
            // The coarser the marks were, the more there is to correct, and the faster it goes.
            let coarse = coarser.map_or(cells[cell], |area| cells[cell] / area);
            let need = (enough / coarse).min(1.0);
            pace = pace.max(time * need);
            coarse < EXACT * enough
        })
        .collect();
    Work { kept, counts, begins: any, pace: if pace > 0.0 { pace } else { 1.0 } }
}
