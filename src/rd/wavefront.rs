//! The fast solver: several steps in one sweep over the grid, so that what a step leaves is still in the cache
//! when the next one needs it; over all threads.
//!
//! Level l of a sweep is the pattern l steps on. While the sweep moves down, level l trails level l − 1 by the
//! reach of the stencil, and the levels between the first and the last keep only the few rows that the next one
//! looks at. Threads take bands of rows and step what they need of their neighbours' for themselves. However the
//! grid is cut, every cell is computed from the same numbers in the same order: the bits are those of
//! [`super::explicit`].

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
use crate::rd::simd_step::{Window, step_row};

/// How a sweep is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiling {
    /// Steps a sweep, at least 1.
    pub levels: usize,
    /// Bands of rows, at least 1.
    pub bands: usize,
}

/// Bytes that the rows between the levels and the coefficients may take of a core's second-level cache: as much as
/// many processors have; tuned at 1024², 2048² and 6000² on one with 2 MB.
const CACHE: usize = 1 << 20;
/// Steps a sweep at most: more gained nothing.
const LEVELS: usize = 8;
/// The share of rows that a band may step for itself though they are a neighbour's: what sharing the work out costs
/// at most.
const SHARED: f64 = 0.06;
/// Cells that a band must have at least to be worth handing to a thread: some 5 µs a step.
const CELLS_A_BAND: usize = 8_192;

impl Tiling {
    /// The tiling for a grid on `threads` threads. All tilings give the same bits.
    #[must_use]
    pub fn suited(problem: &Problem, chemicals: usize, threads: usize) -> Self {
        let (grid, reach) = (problem.grid, problem.reach);
        let bands = (grid.nx * grid.ny / CELLS_A_BAND).clamp(1, threads.max(1));
        let rows = grid.ny.div_ceil(bands);
        // A level keeps 2r + 1 rows of each chemical and trails the one before by r rows of coefficients: mobilities,
        // rate and some three weights a tensor.
        let coefficients = 3 + 3 * problem.tensors.len();
        let a_level = ((2 * reach + 1) * chemicals + coefficients * reach) * grid.stride() * size_of::<f32>();
        let alone = bands == 1 && grid.edges == Edges::Closed;
        let by_sharing = if alone { LEVELS } else { 1 + (SHARED * rows as f64) as usize / reach };
        Self { levels: (CACHE / a_level).min(by_sharing).clamp(1, LEVELS), bands }
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
    /// The widest this machine has.
    #[must_use]
    pub fn best() -> Self {
        *Self::available().last().unwrap_or(&Self::Baseline)
    }

    /// Whether this machine has them.
    fn there(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl"),
        }
    }

    /// Those this machine has, the widest last.
    #[must_use]
    pub fn available() -> Vec<Self> {
        #[cfg(target_arch = "x86_64")]
        let all = [Self::Baseline, Self::Avx2, Self::Avx512];
        #[cfg(not(target_arch = "x86_64"))]
        let all = [Self::Baseline];
        all.into_iter().filter(|instructions| instructions.there()).collect()
    }
}

/// Rows of the levels between the first and the last of a band; kept from sweep to sweep.
#[derive(Clone, Debug, Default)]
pub struct Scratch(Vec<Vec<Vec<Lanes>>>);

/// Takes a step by each of `kinetics`, on `bands` bands of rows, from `old` into `new` (whose contents do not matter).
/// Instructions that the machine lacks are replaced by the baseline: the bits are the same.
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
    let mut parts = new.each_mut().map(|plane| plane.memory_mut().chunks_mut(rows * grid.stride()));
    let mut tasks: Vec<Band<N, K>> = scratch.0[..bands]
        .iter_mut()
        .enumerate()
        .map(|(band, rings)| Band {
            problem,
            kinetics,
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
    old: &'a [Plane; N],
    rows: Range<usize>,
    /// Of each level between: `ring_rows` rows of each chemical.
    rings: &'a mut Vec<Vec<Lanes>>,
    /// Where the last level goes.
    new: [&'a mut [f32]; N],
}

impl<const N: usize, K: Kinetics<N>> Band<'_, N, K> {
    fn sweep(&mut self, instructions: Instructions) {
        let ring = self.problem.grid.groups() * N * (2 * self.problem.reach + 1);
        self.rings.resize(self.kinetics.len().saturating_sub(1).max(self.rings.len()), Vec::new());
        for level in self.rings.iter_mut() {
            level.resize(ring, Lanes([0.0; LANES]));
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
        let levels = self.kinetics.len() as isize;
        for front in top - reach * (levels - 1)..end + reach * (levels - 1) {
            for level in 1..=levels {
                let y = front - reach * (level - 1);
                let more = reach * (levels - level);
                let inside = grid.edges == Edges::Wrap || (0..grid.ny as isize).contains(&y);
                if inside && (top - more..end + more).contains(&y) {
                    self.row::<V>(level as usize, y);
                }
            }
        }
    }

    /// Steps row `y` (counted on beyond the border where edges wrap) of one level.
    #[inline(always)]
    fn row<V: Vector>(&mut self, level: usize, y: isize) {
        let (grid, reach) = (self.problem.grid, self.problem.reach);
        let stride = grid.stride();
        let ring_rows = 2 * reach + 1;
        let topmost = (y - reach as isize).rem_euclid(ring_rows as isize) as usize;
        // Where row y − reach + d begins in a ring.
        let slot = |d: usize| {
            let slot = topmost + d;
            (if slot < ring_rows { slot } else { slot - ring_rows }) * N * stride
        };
        let (below, here) = self.rings.split_at_mut(level - 1);
        let source: &[f32] = below.last().map_or(&[], |ring| cast_slice(ring));
        // Rows that the stencil does not reach, or beyond a closed edge, are named but not read.
        let mut from: Window<N> = [[&[]; 2 * REACH + 1]; N];
        for d in 0..ring_rows {
            let near = y - reach as isize + d as isize;
            let beyond = grid.edges == Edges::Closed && !(0..grid.ny as isize).contains(&near);
            let [near, d_near] = if beyond { [y, reach as isize] } else { [near, d as isize] };
            let (at, first) = (d + REACH - reach, slot(d_near as usize));
            for i in 0..N {
                from[i][at] = if level == 1 {
                    self.old[i].memory(grid.row(near))
                } else {
                    &source[first + i * stride..][..stride]
                };
            }
        }
        if reach < REACH {
            for rows in &mut from {
                [rows[0], rows[2 * REACH]] = [rows[REACH]; 2];
            }
        }
        let mut to: [&mut [f32]; N] = if level == self.kinetics.len() {
            let first = (y - self.rows.start as isize) as usize * stride;
            self.new.each_mut().map(|rows| &mut rows[first..first + stride])
        } else {
            let ring: &mut [f32] = cast_slice_mut(&mut here[0]);
            let mut rows = ring[slot(reach)..][..N * stride].chunks_exact_mut(stride);
            [(); N].map(|()| rows.next().unwrap_or_default())
        };
        step_row::<N, K, V>(self.problem, &self.kinetics[level - 1], grid.row(y), &from, &mut to);
        for row in &mut to {
            grid.fill_margins(row);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::Coefficients;
    use super::super::diffusion::Diffusion;
    use super::super::explicit;
    use super::super::plane::RowLayout;
    use super::super::selling::Tensor;
    use super::*;
    use crate::rd::kinetics::Spreading;
    use crate::rd::systems::meinhardt_lines::MeinhardtLines;
    use crate::rd::systems::meinhardt_spots::MeinhardtSpots;
    use crate::rd::systems::meinhardt_stripes::MeinhardtStripes;
    use crate::rd::systems::turing_spots::{TuringSpots, TuringSpotsWithDecayNoise};
    use crate::rd::vector::Number;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Normalised time of a step.
    const STEP: f64 = 0.1;

    /// Coefficients that differ from cell to cell; so many tensors of stretches from `thinnest` to 1 in all directions.
    fn uneven(grid: RowLayout, thinnest: f64, tensors: usize) -> Problem {
        let wave = |i: usize, f: f64| 0.5 + 0.5 * libm::sin(f * i as f64);
        let tensor = |number: usize, i: usize| {
            let stretch = thinnest + (1.0 - thinnest) * wave(i, 0.013 + 0.002 * number as f64);
            Tensor::oriented(1.0 / stretch, stretch, 180.0 * wave(i, 0.007) + 50.0 * number as f64)
        };
        let between = |[low, high]: [f64; 2], f: f64, i: usize| (low + (high - low) * wave(i, f)) as f32;
        let mobilities = |i| [between([0.001, 0.004], 0.1, i), between([0.05, 0.09], 0.2, i)];
        let isotropic = if thinnest == 1.0 { [1.0, 1.0] } else { [1.02, 0.98] };
        Problem::new(
            grid,
            (0..tensors).map(|number| Diffusion::new(grid, |i| i, |i| tensor(number, i))).collect(),
            isotropic,
            Coefficients::new(grid, false, |i| i, mobilities),
            Coefficients::new(grid, false, |i| i, |i| [between([0.01, 0.05], 0.03, i)]),
            0.01,
        )
    }

    /// Two pairs of chemicals, each chemical with a tensor of its own, that share a reaction with absolute values, maxima
    /// and a soft step whose height decays with time: what systems of pairs need.
    #[derive(Clone, Copy, Debug)]
    struct Pairs {
        height: f32,
    }

    impl Kinetics<4> for Pairs {
        const SPREAD: [Spreading; 4] = [
            Spreading::Tensor { tensor: 0, mobility: 0 },
            Spreading::Tensor { tensor: 1, mobility: 1 },
            Spreading::Tensor { tensor: 2, mobility: 0 },
            Spreading::Tensor { tensor: 3, mobility: 1 },
        ];

        fn at(&self, time: f64) -> Self {
            Self { height: self.height * libm::exp(-0.5 * time) as f32 }
        }

        #[inline(always)]
        fn react<V: Number>(&self, [a, b, c, d]: [V; 4]) -> [V; 4] {
            let (one, two) = (a - b, c - d);
            let differing = one.larger(two).absolute() - one.smaller(two).absolute();
            let made = V::splat(self.height) * differing.soft_step(V::splat(0.05), V::splat(0.2));
            [made - a, made - b, made - c, made - d]
        }
    }

    fn noise<const N: usize>(grid: RowLayout) -> [Plane; N] {
        let mut rng = Pcg64Mcg::seed_from_u64((grid.nx * 1000 + grid.ny) as u64);
        [(); N].map(|()| {
            let cells: Vec<f32> = (0..grid.nx * grid.ny).map(|_| 0.2 + rng.random::<f32>()).collect();
            Plane::from_cells(grid, &cells).expect("as many cells as the grid has")
        })
    }

    /// The bits after `steps` of the plain solver.
    fn plain<const N: usize, K: Kinetics<N>>(problem: &Problem, kinetics: &K, steps: usize) -> Vec<u32> {
        let mut planes = [noise::<N>(problem.grid), noise::<N>(problem.grid)];
        for step in 0..steps {
            let [old, new] = &mut planes;
            explicit::step::<N, K>(problem, &kinetics.at(step as f64 * STEP), old, new);
            planes.swap(0, 1);
        }
        bits(&planes[0])
    }

    fn fast<const N: usize, K: Kinetics<N>>(
        problem: &Problem,
        kinetics: &K,
        steps: usize,
        tiling: Tiling,
        instructions: Instructions,
    ) -> Vec<u32> {
        let mut planes = [noise::<N>(problem.grid), noise::<N>(problem.grid)];
        let mut scratch = Scratch::default();
        let mut left = steps;
        while left > 0 {
            let levels = tiling.levels.min(left);
            let at = |level| kinetics.at((steps - left + level) as f64 * STEP);
            let each: Vec<K> = (0..levels).map(at).collect();
            let [old, new] = &mut planes;
            sweep::<N, K>(problem, &each, old, new, tiling.bands, instructions, &mut scratch);
            planes.swap(0, 1);
            left -= levels;
        }
        bits(&planes[0])
    }

    fn bits<const N: usize>(planes: &[Plane; N]) -> Vec<u32> {
        planes.iter().flat_map(Plane::cells).map(f32::to_bits).collect()
    }

    fn agree<const N: usize, K: Kinetics<N>>(
        kinetics: K,
        grid: RowLayout,
        thinnest: f64,
        tilings: &[Tiling],
    ) {
        const STEPS: usize = 7;
        let problem = uneven(grid, thinnest, K::TENSORS);
        let plain = plain::<N, K>(&problem, &kinetics, STEPS);
        for instructions in Instructions::available() {
            for tiling in tilings {
                let fast = fast::<N, K>(&problem, &kinetics, STEPS, *tiling, instructions);
                assert!(plain == fast, "{N} chemicals, {grid:?}, {thinnest}, {tiling:?}, {instructions:?}");
            }
        }
    }

    fn all_agree(nx: usize, ny: usize, tilings: &[Tiling]) {
        for edges in [Edges::Closed, Edges::Wrap] {
            let grid = RowLayout { nx, ny, edges };
            for thinnest in [0.3, 0.6, 1.0] {
                agree::<4, _>(Pairs { height: 0.8 }, grid, thinnest, tilings);
                agree::<2, _>(TuringSpots, grid, thinnest, tilings);
                agree::<2, _>(MeinhardtSpots, grid, thinnest, tilings);
                agree::<5, _>(MeinhardtStripes, grid, thinnest, tilings);
                agree::<2, _>(MeinhardtLines, grid, thinnest, tilings);
                agree::<3, _>(TuringSpotsWithDecayNoise, grid, thinnest, tilings);
            }
        }
    }

    #[test]
    fn a_reaction_that_changes_with_time_is_evaluated_at_the_time_of_each_step() {
        let problem = uneven(RowLayout { nx: 40, ny: 24, edges: Edges::Wrap }, 0.4, Pairs::TENSORS);
        let mut planes = [noise::<4>(problem.grid), noise::<4>(problem.grid)];
        for height in [0.8, 0.8 * libm::exp(-0.5 * STEP) as f32] {
            let [old, new] = &mut planes;
            explicit::step::<4, Pairs>(&problem, &Pairs { height }, old, new);
            planes.swap(0, 1);
        }
        let tiling = Tiling { levels: 2, bands: 1 };
        let instructions = Instructions::best();
        assert!(bits(&planes[0]) == fast::<4, _>(&problem, &Pairs { height: 0.8 }, 2, tiling, instructions));
        assert_eq!(Pairs::TENSORS, 4);
    }

    #[test]
    fn every_tiling_and_every_instruction_set_gives_the_bits_of_the_plain_solver() {
        let tilings =
            [[1, 1], [1, 3], [3, 1], [4, 2], [7, 5]].map(|[levels, bands]| Tiling { levels, bands });
        for (nx, ny) in [(65, 33), (150, 41)] {
            all_agree(nx, ny, &tilings);
        }
    }

    /// Small enough for Miri, which looks over the unchecked loads and stores:
    /// `MIRIFLAGS="-Zmiri-disable-isolation -Zmiri-ignore-leaks -Zmiri-tree-borrows" cargo +nightly miri test --lib -- rd::wavefront::tests::a_small`
    #[test]
    fn a_small_grid_gives_the_bits_of_the_plain_solver() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let tilings = [Tiling { levels: 3, bands: 2 }];
            agree::<2, _>(MeinhardtSpots, RowLayout { nx: 19, ny: 4, edges }, 0.3, &tilings);
        }
    }

    #[test]
    fn grids_of_every_size_about_a_multiple_of_the_lanes_give_the_bits_of_the_plain_solver() {
        let tilings = [Tiling { levels: 3, bands: 2 }];
        for nx in 1..=2 * LANES + 3 {
            all_agree(nx, 5, &tilings);
        }
        for ny in 1..=9 {
            all_agree(LANES + 3, ny, &tilings);
        }
    }
}
