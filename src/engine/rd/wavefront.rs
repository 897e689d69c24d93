//! The fast solver: several steps in one sweep over the grid, so that the result of a step is still in the cache when the
//! next step reads it; multithreaded.
//!
//! Time step l of a sweep is the pattern after l more steps. While the sweep moves down, time step l trails time step l − 1 by the
//! reach of the stencil. The time steps between the first and the last keep only the few rows that the next one reads. Each thread
//! steps a band of rows, and also the rows of neighbouring bands that it needs. With any tiling every cell is computed from equal
//! numbers in one order, so the bits are those of [`super::explicit`].

use std::ops::Range;

use bytemuck::{cast_slice, cast_slice_mut};
use rayon::prelude::*;

use super::kinetics::Kinetics;
use super::plane::{LANES, Lanes, Plane};
use super::problem::Problem;
use super::selling::REACH;
#[cfg(target_arch = "x86_64")]
use super::vector::{Eight, Sixteen};
use super::vector::{Four, Vector};
use crate::grid::Edges;
use crate::rd::simd_step::{Source, Window, step_row};
use crate::rd::super_step::Stage;

/// The division of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiling {
    /// Stages in a sweep, at least 1: rounded down to whole super steps, one at least.
    pub time_steps: usize,
    /// Bands of rows, at least 1.
    pub bands: usize,
}

/// Bytes of a core's second-level cache for the rows between the time steps and the coefficients: many processors have this
/// much; tuned at 1024², 2048² and 6000² on one with 2 MB.
const CACHE: usize = 1 << 20;
/// Most stages in a sweep, unless a super step has more; more stages were no faster.
const TIME_STEPS: usize = 8;
/// Largest share of rows that a band steps although they belong to a neighbour: the cost of dividing the work.
const SHARED: f64 = 0.06;
/// Fewest cells in a band that is given to a thread: about 5 µs for each step.
const CELLS_A_BAND: usize = 8_192;

impl Tiling {
    /// The tiling for a grid on `threads` threads. All tilings give the same bits.
    #[must_use]
    pub fn suited(problem: &Problem, chemicals: usize, threads: usize) -> Self {
        let (grid, reach) = (problem.grid, problem.reach);
        let bands = (grid.nx * grid.ny / CELLS_A_BAND).clamp(1, threads.max(1));
        let rows = grid.ny.div_ceil(bands);
        // A time step keeps 2r + 1 rows of each chemical and trails the one before by r rows of coefficients: mobilities,
        // rate and some three weights a tensor.
        let coefficients = 3 + 3 * problem.tensors.len();
        let a_time_step =
            ((2 * reach + 1) * chemicals + coefficients * reach) * grid.stride() * size_of::<f32>();
        let alone = bands == 1 && grid.edges == Edges::Closed;
        let by_sharing = if alone { TIME_STEPS } else { 1 + (SHARED * rows as f64) as usize / reach };
        Self { time_steps: (CACHE / a_time_step).min(by_sharing).clamp(1, TIME_STEPS), bands }
            .with_whole(problem.stages)
    }

    /// This tiling, with as many time steps as make up whole super steps of `stages`.
    #[must_use]
    pub fn with_whole(self, stages: usize) -> Self {
        Self { time_steps: (self.time_steps / stages).max(1) * stages, ..self }
    }
}

/// The vector instructions to step with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// The vector instructions of every machine of this architecture (SSE2, NEON).
    Baseline,
    /// AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// AVX-512.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Instructions {
    /// The widest that this machine supports.
    #[must_use]
    pub fn best() -> Self {
        *Self::available().last().unwrap_or(&Self::Baseline)
    }

    /// Whether this machine supports them.
    pub(super) fn there(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl"),
        }
    }

    /// The instructions that this machine supports, the widest last.
    #[must_use]
    pub fn available() -> Vec<Self> {
        #[cfg(target_arch = "x86_64")]
        let all = [Self::Baseline, Self::Avx2, Self::Avx512];
        #[cfg(not(target_arch = "x86_64"))]
        let all = [Self::Baseline];
        all.into_iter().filter(|instructions| instructions.there()).collect()
    }
}

/// Rows of the time steps between the first and the last of a band; reused by later sweeps.
#[derive(Clone, Debug, Default)]
pub struct Scratch(Vec<Vec<Vec<Lanes>>>);

/// Takes one stage for each of `kinetics`, whole super steps, on `bands` bands of rows, from `old` into `new` (whose contents do
/// not matter). Instructions that the machine lacks are replaced by the baseline, with equal bits.
pub fn sweep<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    kinetics: &[K],
    old: &[Plane; N],
    new: &mut [Plane; N],
    bands: usize,
    instructions: Instructions,
    scratch: &mut Scratch,
) {
    let instructions = if instructions.there() { instructions } else { Instructions::Baseline };
    let grid = problem.grid;
    let rows = grid.ny.div_ceil(bands.max(1)).max(1);
    let bands = grid.ny.div_ceil(rows);
    scratch.0.resize(bands.max(scratch.0.len()), Vec::new());
    let stages: Vec<Stage> = (0..kinetics.len()).map(|taken| Stage::after(taken, problem.stages)).collect();
    let mut parts = new.each_mut().map(|plane| plane.memory_mut().chunks_mut(rows * grid.stride()));
    let mut tasks: Vec<Band<N, K>> = scratch.0[..bands]
        .iter_mut()
        .enumerate()
        .map(|(band, rings)| Band {
            problem,
            kinetics,
            stages: &stages,
            old,
            rows: band * rows..grid.ny.min((band + 1) * rows),
            rings,
            new: parts.each_mut().map(|part| part.next().unwrap_or_default()),
        })
        .collect();
    let run = |band: &mut Band<N, K>| band.sweep(instructions);
    if bands == 1 {
        tasks.iter_mut().for_each(run);
    } else {
        tasks.par_iter_mut().for_each(run);
    }
}

/// A band of rows that one task sweeps.
struct Band<'a, const N: usize, K> {
    problem: &'a Problem,
    /// The reaction of each step.
    kinetics: &'a [K],
    /// The coefficients of each step.
    stages: &'a [Stage],
    old: &'a [Plane; N],
    rows: Range<usize>,
    /// For each intermediate time step `ring_rows` rows of each chemical.
    rings: &'a mut Vec<Vec<Lanes>>,
    /// The output of the last time step.
    new: [&'a mut [f32]; N],
}

impl<const N: usize, K: Kinetics<N>> Band<'_, N, K> {
    fn sweep(&mut self, instructions: Instructions) {
        let ring = self.problem.grid.groups() * N * (2 * self.problem.reach + 1);
        self.rings.resize(self.kinetics.len().saturating_sub(1).max(self.rings.len()), Vec::new());
        for time_step in self.rings.iter_mut() {
            time_step.resize(ring, Lanes([0.0; LANES]));
        }
        match instructions {
            Instructions::Baseline => self.down::<Four>(),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: `sweep` made sure that the processor has them.
            Instructions::Avx2 => unsafe { self.down_avx2() },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: `sweep` made sure that the processor has them.
            Instructions::Avx512 => unsafe { self.down_avx512() },
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn down_avx2(&mut self) {
        self.down::<Eight>();
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512vl")]
    fn down_avx512(&mut self) {
        self.down::<Sixteen>();
    }

    /// Sweeps from the top to the bottom of the band.
    #[inline(always)]
    fn down<V: Vector>(&mut self) {
        let (grid, reach) = (self.problem.grid, self.problem.reach as isize);
        let (top, end) = (self.rows.start as isize, self.rows.end as isize);
        let time_steps = self.kinetics.len() as isize;
        for front in top - reach * (time_steps - 1)..end + reach * (time_steps - 1) {
            for time_step in 1..=time_steps {
                let y = front - reach * (time_step - 1);
                let more = reach * (time_steps - time_step);
                let inside = grid.edges == Edges::Wrap || (0..grid.ny as isize).contains(&y);
                if inside && (top - more..end + more).contains(&y) {
                    self.row::<V>(time_step as usize, y);
                }
            }
        }
    }

    /// Steps row `y` of one time step; with wrapped edges `y` may lie beyond the border.
    #[inline(always)]
    fn row<V: Vector>(&mut self, time_step: usize, y: isize) {
        let (grid, reach) = (self.problem.grid, self.problem.reach);
        let stride = grid.stride();
        let ring_rows = 2 * reach + 1;
        // A 32-bit division takes less time than a 64-bit one.
        let topmost = (y as i32 - reach as i32).rem_euclid(ring_rows as i32) as usize;
        // Where row y − reach + d begins in a ring.
        let slot = |d: usize| {
            let slot = topmost + d;
            (if slot < ring_rows { slot } else { slot - ring_rows }) * N * stride
        };
        let (below, here) = self.rings.split_at_mut(time_step - 1);
        // The ring of the time step before the last still holds row y: its oldest row.
        let before: [&[f32]; N] = std::array::from_fn(|i| match time_step {
            0..=2 => self.old[i].memory(grid.row(y)),
            _ => &cast_slice(&below[time_step - 3])[slot(reach) + i * stride..][..stride],
        });
        let source: &[f32] = below.last().map_or(&[], |ring| cast_slice(ring));
        // Rows that the stencil does not reach, or beyond a closed edge, are listed but not read.
        let mut from: Window<N> = [[&[]; 2 * REACH + 1]; N];
        for d in 0..ring_rows {
            let near = y - reach as isize + d as isize;
            let beyond = grid.edges == Edges::Closed && !(0..grid.ny as isize).contains(&near);
            let [near, d_near] = if beyond { [y, reach as isize] } else { [near, d as isize] };
            let (at, first) = (d + REACH - reach, slot(d_near as usize));
            for i in 0..N {
                from[i][at] = if time_step == 1 {
                    self.old[i].memory(grid.row(near))
                } else {
                    &source[first + i * stride..][..stride]
                };
            }
        }
        if reach < REACH {
            for rows in &mut from {
                let own = rows[REACH];
                rows[..REACH - reach].fill(own);
                rows[REACH + reach + 1..].fill(own);
            }
        }
        let mut to: [&mut [f32]; N] = if time_step == self.kinetics.len() {
            let first = (y - self.rows.start as isize) as usize * stride;
            self.new.each_mut().map(|rows| &mut rows[first..first + stride])
        } else {
            let ring: &mut [f32] = cast_slice_mut(&mut here[0]);
            let mut rows = ring[slot(reach)..][..N * stride].chunks_exact_mut(stride);
            [(); N].map(|()| rows.next().unwrap_or_default())
        };
        let step = (&self.kinetics[time_step - 1], self.stages[time_step - 1]);
        let source = Source { window: from, before };
        step_row::<N, K, V>(self.problem, step, grid.row(y), &source, &mut to);
        for row in &mut to {
            grid.fill_margins(row);
        }
    }
}

#[cfg(test)]
mod tests;
