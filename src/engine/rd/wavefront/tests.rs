//! Comparison of every tiling and every instruction set with the plain solver.

use super::super::coefficients::Coefficients;
use super::super::diffusion::Diffusion;
use super::super::explicit;
use super::super::plane::RowLayout;
use super::super::selling::PrincipalAxes;
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

/// Coefficients that differ from cell to cell; `tensors` tensors with stretches from `thinnest` to 1 in all directions.
fn uneven(grid: RowLayout, thinnest: f64, tensors: usize) -> Problem {
    let wave = |i: usize, f: f64| 0.5 + 0.5 * libm::sin(f * i as f64);
    let tensor = |number: usize, i: usize| {
        let stretch = thinnest + (1.0 - thinnest) * wave(i, 0.013 + 0.002 * number as f64);
        let degrees = 180.0 * wave(i, 0.007) + 50.0 * number as f64;
        PrincipalAxes { along: 1.0 / stretch, across: stretch, degrees }
    };
    let between = |[low, high]: [f64; 2], f: f64, i: usize| (low + (high - low) * wave(i, f)) as f32;
    let mobilities = |i| [between([0.001, 0.004], 0.1, i), between([0.05, 0.09], 0.2, i)];
    let isotropic = if thinnest == 1.0 { [1.0, 1.0] } else { [1.02, 0.98] };
    Problem::new(
        grid,
        (0..tensors).map(|number| Diffusion::new(grid, [1.0; 2], |i| tensor(number, i))).collect(),
        isotropic,
        Coefficients::new(grid, |i| i, mobilities),
        Coefficients::new(grid, |i| i, |i| [between([0.01, 0.05], 0.03, i)]),
        0.01,
    )
}

/// Two pairs of chemicals, each chemical with a tensor of its own, that share a reaction with absolute values, maxima
/// and a soft step whose height decays with time, as in systems of pairs.
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

/// The bits after `steps` steps of the plain solver.
fn plain<const N: usize, K: Kinetics<N>>(problem: &Problem, kinetics: &K, steps: usize) -> Vec<u32> {
    let mut planes = [noise::<N>(problem.grid), noise::<N>(problem.grid)];
    for step in 0..steps {
        let [old, new] = &mut planes;
        let stage = Stage::after(step, problem.stages);
        explicit::step::<N, K>(problem, &kinetics.at(step as f64 * STEP), stage, old, new);
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
    let tiling = tiling.with_whole(problem.stages);
    let mut left = steps;
    while left > 0 {
        let time_steps = tiling.time_steps.min(left);
        let at = |time_step| kinetics.at((steps - left + time_step) as f64 * STEP);
        let each: Vec<K> = (0..time_steps).map(at).collect();
        let [old, new] = &mut planes;
        sweep::<N, K>(problem, &each, old, new, tiling.bands, instructions, &mut scratch);
        planes.swap(0, 1);
        left -= time_steps;
    }
    bits(&planes[0])
}

fn bits<const N: usize>(planes: &[Plane; N]) -> Vec<u32> {
    planes.iter().flat_map(Plane::cells).map(f32::to_bits).collect()
}

fn agree<const N: usize, K: Kinetics<N>>(kinetics: K, grid: RowLayout, thinnest: f64, tilings: &[Tiling]) {
    for [stages, steps] in [[1, 7], [2, 4], [3, 9], [6, 6]] {
        let problem = Problem { stages, ..uneven(grid, thinnest, K::TENSORS) };
        let plain = plain::<N, K>(&problem, &kinetics, steps);
        for instructions in Instructions::available() {
            for tiling in tilings {
                let fast = fast::<N, K>(&problem, &kinetics, steps, *tiling, instructions);
                assert!(
                    plain == fast,
                    "{N} chemicals, {stages} stages, {grid:?}, {thinnest}, {tiling:?}, {instructions:?}"
                );
            }
        }
    }
}

fn all_agree(nx: usize, ny: usize, tilings: &[Tiling]) {
    for edges in [Edges::Closed, Edges::Wrap] {
        let grid = RowLayout { nx, ny, edges };
        for thinnest in [0.13, 0.3, 0.6, 1.0] {
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
        explicit::step::<4, Pairs>(&problem, &Pairs { height }, Stage::after(0, 1), old, new);
        planes.swap(0, 1);
    }
    let tiling = Tiling { time_steps: 2, bands: 1 };
    let instructions = Instructions::best();
    assert!(bits(&planes[0]) == fast::<4, _>(&problem, &Pairs { height: 0.8 }, 2, tiling, instructions));
    assert_eq!(Pairs::TENSORS, 4);
}

#[test]
fn every_tiling_and_every_instruction_set_gives_the_bits_of_the_plain_solver() {
    let tilings =
        [[1, 1], [1, 3], [3, 1], [4, 2], [7, 5]].map(|[time_steps, bands]| Tiling { time_steps, bands });
    for (nx, ny) in [(65, 33), (150, 41)] {
        all_agree(nx, ny, &tilings);
    }
}

/// Small enough for Miri, which checks the unchecked loads and stores:
/// `MIRIFLAGS="-Zmiri-disable-isolation -Zmiri-ignore-leaks -Zmiri-tree-borrows" cargo +nightly miri test --lib -- rd::wavefront::tests::a_small`
#[test]
fn a_small_grid_gives_the_bits_of_the_plain_solver() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let tilings = [Tiling { time_steps: 3, bands: 2 }];
        for thinnest in [0.13, 0.3] {
            agree::<2, _>(MeinhardtSpots, RowLayout { nx: 19, ny: 4, edges }, thinnest, &tilings);
        }
    }
}

#[test]
fn grids_of_every_size_about_a_multiple_of_the_lanes_give_the_bits_of_the_plain_solver() {
    let tilings = [Tiling { time_steps: 3, bands: 2 }];
    for nx in 1..=2 * LANES + 3 {
        all_agree(nx, 5, &tilings);
    }
    for ny in 1..=9 {
        all_agree(LANES + 3, ny, &tilings);
    }
}
