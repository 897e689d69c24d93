//! Grid levels: the coarse grids under the planned one.
//!
//! The number of steps until a pattern has settled increases with the area of its spots in cells. So it is formed on the coarsest
//! grid that resolves its marks, and then prolongated to finer grids, where only the errors of the coarse one are corrected. Where
//! marks differ in size, the large ones are formed on grids that are too coarse for the small ones; these start on the first grid
//! that resolves them.
//!
//! The numbers of cells that marks need ([`Resolution`]) were tuned on patches of 86 spots and 10 wavelengths, against plain Euler
//! steps with 48 cells a spot and 8 a stripe to T ≥ 120. On coarser grids, correcting area, aspect and angle takes longer than the
//! coarse grid saves.

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::Domain;
use crate::rd::{ParameterField, Parameters, Resolution, System};
use crate::synth::marks::plan::mark_cells::resolving_cells;

/// Cells of the smallest marks on the coarsest grid ÷ `enough`: a margin for the error of the area laws.
const MARGIN: f64 = 1.09;
/// Least ratio of the sides of cells for a coarser grid to save steps.
const WORTH: f64 = 1.3;
/// Ratio of the sides of cells from one grid to the next.
const NEXT: f64 = 2.0;
/// Least number of cells of a coarse grid along either side.
pub const LEAST_SIDE: f64 = 12.0;
/// Marks formed on a coarser grid are corrected unless they had this many times `enough` cells there.
const EXACT: f64 = 8.0;

/// Grids from the coarsest to that of `maps`, without grids that would hold only marks of more than `most` cells.
#[must_use]
pub fn grids(system: System, maps: &ParameterField, most: f64) -> Vec<[usize; 2]> {
    if maps.curves.is_some() {
        // A coarser grid cannot show on which side of a curve a cell lies.
        return vec![maps.domain.size];
    }
    let enough = system.definition().resolution.enough * MARGIN;
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
    let [nx, ny] = maps.domain.size;
    factors.retain(|f| *f == 1.0 || side(nx.min(ny), *f) >= LEAST_SIDE);
    let grid = |f: &f64| [side(nx, *f), side(ny, *f)].map(|n| n.round() as usize);
    factors.iter().rev().map(grid).collect()
}

/// The work on one grid.
#[derive(Clone, Debug)]
pub struct Work {
    /// By cell: the share that is taken from the coarser grid; empty if everything is, and on the coarsest.
    pub taken: Vec<f32>,
    /// By cell: whether marks still form or are corrected there. Cells of finished marks, and of marks that are too small on this
    /// grid, do not count for convergence.
    pub counts: Vec<bool>,
    /// Whether marks start on this grid.
    pub begins: bool,
    /// Time scale: normalised time is counted with a reaction rate of this factor times the slowest one on the grid.
    pub pace: f64,
}

/// The parameters on `grid`, with larger marks where they are too small for it; and by cell, whether marks are too small there.
#[must_use]
pub fn coarse(system: System, maps: &ParameterField, grid: [usize; 2]) -> (ParameterField, Vec<bool>) {
    let least = system.definition().resolution.least;
    let area = maps.domain.cells() as f64 / (grid[0] * grid[1]) as f64;
    let mut coarse = maps.on_grid(grid);
    let mut lost = vec![false; coarse.parameters.len()];
    let parts = coarse.parameters.par_chunks_mut(PART).zip(lost.par_chunks_mut(PART));
    parts.for_each(|(parameters, lost)| {
        for (p, lost) in parameters.iter_mut().zip(lost.iter_mut()) {
            let share = resolving_cells(system, p) / least;
            *lost = share < 1.0;
            if *lost {
                p.rate *= share as f32;
            }
        }
        system.compensate(parameters, area, lost);
    });
    (coarse, lost)
}

/// The work on a grid whose parameters are `maps`; cells of the next coarser grid have `coarser` times the area.
///
/// `lost` are the cells where marks are too small for this grid.
#[must_use]
pub fn work(system: System, maps: &ParameterField, lost: &[bool], coarser: Option<f64>) -> Work {
    let Resolution { least, enough, .. } = system.definition().resolution;
    let limits = Limits {
        least,
        enough,
        coarser: coarser.unwrap_or(1.0),
        slowest: maps.parameters.iter().map(|p| p.rate).fold(f32::INFINITY, f32::min),
    };
    let part = |(index, parameters): (usize, &[Parameters])| {
        let mut part = Part::default();
        for (first, parameters) in (index * PART..).step_by(TOGETHER).zip(parameters.chunks(TOGETHER)) {
            let (mut cells, mut rates) = ([1.0; TOGETHER], [1.0; TOGETHER]);
            for (k, p) in parameters.iter().enumerate() {
                (cells[k], rates[k]) = (resolving_cells(system, p), p.rate);
            }
            let needs = side_by_side(&cells, &rates, &limits);
            for (k, cells) in cells.iter().enumerate().take(parameters.len()) {
                let is_lost = lost.get(first + k).copied().unwrap_or(false);
                let begins = (coarser.is_none() || needs.taken[k] < 0.5) && !is_lost;
                part.add(begins, begins || !is_lost && *cells < EXACT * enough, &needs, k);
            }
            if coarser.is_some() {
                part.take(first - index * PART, &needs.taken[..parameters.len()]);
            }
        }
        part
    };
    let parts: Vec<Part> = maps.parameters.par_chunks(PART).enumerate().map(part).collect();
    let begins = parts.iter().any(|part| part.begins);
    let paces = parts.iter().map(|part| if begins { part.forming.pace } else { part.corrected.pace });
    let pace = paces.fold(0.0, f64::max);
    let mut work = Work { taken: vec![], counts: vec![], begins, pace: if pace > 0.0 { pace } else { 1.0 } };
    let is_partly_fresh = parts.iter().any(|part| !part.taken.is_empty());
    work.counts.reserve_exact(maps.parameters.len());
    for part in parts {
        let counts = if begins { part.forming.counts } else { part.corrected.counts };
        work.counts.extend_from_slice(&counts);
        if is_partly_fresh {
            work.taken.extend_from_slice(&part.taken);
            work.taken.resize(work.counts.len(), 1.0);
        }
    }
    work
}

/// Cells of a part that one thread works on.
const PART: usize = 1 << 14;
/// Cells that are computed side by side. Not tuned.
const TOGETHER: usize = 64;

/// The work on a part of the cells.
#[derive(Default)]
struct Part {
    /// Shares of cells that are taken, see [`Work::taken`].
    taken: Vec<f32>,
    begins: bool,
    /// The cells that count if marks start on the grid.
    forming: Counted,
    /// The cells that count if no marks start on it. The coarser the marks were, the more has to be corrected, and the faster it
    /// goes.
    corrected: Counted,
}

/// Cells that count for convergence.
#[derive(Default)]
struct Counted {
    counts: Vec<bool>,
    /// The time scale of this part, see [`Work::pace`].
    pace: f64,
}

impl Part {
    /// Adds the shares of cells that are taken from the coarser grid, after `before` other cells.
    fn take(&mut self, before: usize, shares: &[f32]) {
        if !self.taken.is_empty() || shares.iter().any(|share| *share != 1.0) {
            self.taken.resize(before, 1.0);
            self.taken.extend_from_slice(shares);
        }
    }

    /// Adds cell `k` of these: whether marks begin there, and whether it counts where some do.
    fn add(&mut self, begins: bool, counts: bool, needs: &Needs, k: usize) {
        self.begins |= begins;
        self.forming.counts.push(counts);
        self.forming.pace = self.forming.pace.max(if begins { needs.times[k] } else { 0.0 });
        self.corrected.counts.push(needs.lack[k] > 1.0 / EXACT);
        self.corrected.pace = self.corrected.pace.max(needs.times[k] * needs.lack[k].min(1.0));
    }
}

/// Constants for all cells.
struct Limits {
    /// Cells of marks that a grid just does not resolve.
    least: f64,
    /// Cells of marks that it resolves.
    enough: f64,
    /// The area of a cell of the coarser grid.
    coarser: f64,
    /// The slowest reaction rate, 1 ÷ cell².
    slowest: f32,
}

/// Requirements of cells.
struct Needs {
    /// The share that is taken from the coarser grid.
    taken: [f32; TOGETHER],
    /// The time that the reactions take, relative to the slowest.
    times: [f64; TOGETHER],
    /// The cells that marks need ÷ those that they had on the coarser grid.
    lack: [f64; TOGETHER],
}

/// The requirements of marks of this number of `cells` with these reaction `rates` (1 ÷ cell²).
#[multiversion(targets("x86_64+avx2"))]
fn side_by_side(cells: &[f64; TOGETHER], rates: &[f32; TOGETHER], limits: &Limits) -> Needs {
    let Limits { least, enough, .. } = *limits;
    let mut needs = Needs { taken: [0.0; TOGETHER], times: [0.0; TOGETHER], lack: [0.0; TOGETHER] };
    for k in 0..TOGETHER {
        let coarse = cells[k] / limits.coarser;
        let t = ((coarse - least) / (enough - least)).clamp(0.0, 1.0);
        needs.taken[k] = (t * t * (3.0 - 2.0 * t)) as f32;
        needs.times[k] = f64::from(limits.slowest / rates[k]);
        needs.lack[k] = enough / coarse;
    }
    needs
}
