//! Growth as a value: begun from parameters, advanced, looked at.

mod chemicals;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::kinetics::Kinetics;
use super::maps::{Maps, Parameters};
use super::plane::{Plane, RowLayout};
use super::problem::Problem;
use super::selling::{MIN_STRETCH, Tensor};
use super::solver::Solver;
use super::wavefront::{self, Instructions, Scratch, Tiling};
use crate::grid::{Domain, Field};
use crate::rd::local_warp::{LocalWarp, warped};
use crate::rd::systems::meinhardt_lines;
use crate::rd::systems::meinhardt_lines::MeinhardtLines;
use crate::rd::systems::meinhardt_spots;
use crate::rd::systems::meinhardt_spots::MeinhardtSpots;
use crate::rd::systems::meinhardt_stripes;
use crate::rd::systems::meinhardt_stripes::MeinhardtStripes;
use crate::rd::systems::turing_spots;
use crate::rd::systems::turing_spots::{TuringSpots, UnevenTuringSpots};
use crate::rd::{System, explicit, initial_conditions};
use chemicals::Chemicals;

/// dt·D·Σw that a step may not exceed. ½ is where it stops being monotone; 0.45 is what `facts.md` A found
/// free of noise with reactions on top.
const DIFFUSION_LIMIT: f32 = 0.45;

/// A pattern being grown.
#[derive(Clone, Debug)]
pub struct Growth {
    system: System,
    problem: Problem,
    cell: [f64; 2],
    chemicals: Chemicals,
    scratch: Scratch,
    /// Cells whose concentrations are those of other marks, not of this pattern's.
    masked: Vec<bool>,
    /// Normalised time that one step takes where the reactions are slowest.
    time_a_step: f64,
    steps: u64,
}

impl System {
    /// What tells the height of a mark's middle from the ratio, of Meinhardt's two chemicals.
    fn peak(self) -> fn(f32) -> f32 {
        if self == Self::MeinhardtLines { meinhardt_lines::peak } else { meinhardt_spots::peak }
    }
}

impl Growth {
    /// Lays out the grid, its coefficients and what the growth begins from.
    #[must_use]
    pub fn new(system: System, maps: &Maps, seed: u64) -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        let chemicals = match system {
            System::MeinhardtStripes => Chemicals::five(initial_conditions::stripes(maps, &mut rng)),
            System::MeinhardtLines => Chemicals::two(initial_conditions::lines(maps, &mut rng)),
            _ => Chemicals::two(initial_conditions::spots(system, maps, &mut rng)),
        };
        Self::of(system, maps, chemicals)
    }

    /// Goes on from saved `concentrations` (as [`Self::concentrations`] gives them) instead of a fresh start.
    ///
    /// `None` where their number or length does not fit the system and the grid.
    #[must_use]
    pub fn resumed(system: System, maps: &Maps, concentrations: &[Vec<f32>]) -> Option<Self> {
        let planes: Vec<Plane> = concentrations
            .iter()
            .map(|cells| Plane::from_cells(RowLayout::new(&maps.grid), cells))
            .collect::<Option<_>>()?;
        let chemicals = match system {
            System::MeinhardtStripes => Chemicals::five(planes.try_into().ok()?),
            _ => Chemicals::two(planes.try_into().ok()?),
        };
        Some(Self::of(system, maps, chemicals))
    }

    fn of(system: System, maps: &Maps, chemicals: Chemicals) -> Self {
        let chemicals = match chemicals {
            Chemicals::Two(two) if system == System::TuringSpots && !maps.decay_noise.is_empty() => {
                let [planes, _] = *two;
                Chemicals::with_decay(planes, maps, RowLayout::new(&maps.grid))
            }
            others => others,
        };
        let mut problem = problem(system, maps);
        if !maps.obstacles.is_empty() {
            problem.freeze(&|cell: usize| maps.obstacles[cell]);
        }
        let time_a_step = f64::from(problem.slowest) * f64::from(system.decay());
        let scratch = Scratch::default();
        let masked = masked(system, maps);
        Self { masked, system, problem, cell: maps.grid.cell, chemicals, scratch, time_a_step, steps: 0 }
    }

    /// Leaves the cells that `frozen` names (`y · nx + x`) as they are from now on, while their neighbours still see
    /// them. Their concentrations must be such that the reaction stays finite.
    pub fn freeze(&mut self, frozen: impl Fn(usize) -> bool + Sync) {
        self.problem.freeze(&frozen);
    }

    /// Moves spots of the pattern that grows in `maps`.
    pub fn warp(&mut self, maps: &Maps, warps: &[LocalWarp]) {
        let grid = self.problem.grid;
        let moved = |plane: &mut Plane| {
            let cells = warped(self.system, maps, &plane.cells(), warps);
            cells.chunks_exact(grid.nx).enumerate().for_each(|(y, row)| plane.set_row(y, row));
        };
        match &mut self.chemicals {
            Chemicals::Two(two) => two[0].iter_mut().for_each(moved),
            // β stays where it is.
            Chemicals::Three(three) => three[0][..2].iter_mut().for_each(moved),
            Chemicals::Five(five) => five[0].iter_mut().for_each(moved),
        }
    }

    /// Takes `steps` explicit steps.
    pub fn advance(&mut self, steps: u64) {
        let threads = rayon::current_num_threads();
        let tiling = Tiling::suited(&self.problem, self.chemicals.count(), threads);
        match Solver::chosen() {
            Solver::Plain => self.advance_plain(steps),
            Solver::Fast(instructions) => self.advance_as(steps, tiling, instructions),
        }
    }

    /// The same, cut and vectorised as told: the same bits.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        let (problem, scratch) = (&self.problem, &mut self.scratch);
        let tiling = Tiling { levels: tiling.levels.max(1), ..tiling };
        for sweep in 0..steps.div_ceil(tiling.levels as u64) {
            let left = steps - sweep * tiling.levels as u64;
            let tiling = Tiling { levels: tiling.levels.min(left as usize), ..tiling };
            match (&mut self.chemicals, self.system) {
                (Chemicals::Two(two), System::TuringSpots) => {
                    sweep_and_swap::<2, TuringSpots>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Two(two), System::MeinhardtLines) => {
                    sweep_and_swap::<2, MeinhardtLines>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Two(two), _) => {
                    sweep_and_swap::<2, MeinhardtSpots>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Three(three), _) => {
                    sweep_and_swap::<3, UnevenTuringSpots>(problem, three, tiling, instructions, scratch);
                }
                (Chemicals::Five(five), _) => {
                    sweep_and_swap::<5, MeinhardtStripes>(problem, five, tiling, instructions, scratch);
                }
            }
        }
        self.steps += steps;
    }

    /// The same with the plain solver, bit for bit, slowly: what the fast one is tested and measured against.
    pub fn advance_plain(&mut self, steps: u64) {
        for _ in 0..steps {
            match (&mut self.chemicals, self.system) {
                (Chemicals::Two(two), System::TuringSpots) => {
                    step_and_swap::<2, TuringSpots>(&self.problem, two);
                }
                (Chemicals::Two(two), System::MeinhardtLines) => {
                    step_and_swap::<2, MeinhardtLines>(&self.problem, two);
                }
                (Chemicals::Two(two), _) => step_and_swap::<2, MeinhardtSpots>(&self.problem, two),
                (Chemicals::Three(three), _) => step_and_swap::<3, UnevenTuringSpots>(&self.problem, three),
                (Chemicals::Five(five), _) => step_and_swap::<5, MeinhardtStripes>(&self.problem, five),
            }
        }
        self.steps += steps;
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps that make up `time` of normalised time (`facts.md` 0) where the reactions are slowest.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step).ceil().max(1.0) as u64
    }

    /// Normalised time grown where the reactions are slowest.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.time_a_step
    }

    /// The concentration that shows the marks, high inside them: 0 about the ground, 1 about the middle of a
    /// mark that has the parameters there.
    #[must_use]
    pub fn marks(&self, maps: &Maps) -> Field {
        let nx = self.problem.grid.nx;
        let mut values = vec![0.0; nx * self.problem.grid.ny];
        values.par_chunks_mut(nx).enumerate().for_each(|(y, row)| match &self.chemicals {
            Chemicals::Two(two) if self.system == System::TuringSpots => {
                for (mark, a) in row.iter_mut().zip(two[0][0].row(y)) {
                    *mark = turing_spots::share(*a);
                }
            }
            Chemicals::Three(three) => {
                for (mark, a) in row.iter_mut().zip(three[0][0].row(y)) {
                    *mark = turing_spots::share(*a);
                }
            }
            Chemicals::Two(two) => {
                let peak_at = self.system.peak();
                let (mut ratio, mut peak) = (f32::NAN, 0.0);
                for ((mark, a), p) in row.iter_mut().zip(two[0][0].row(y)).zip(&maps.parameters[y * nx..]) {
                    // Mostly the same as beside it.
                    if p.ratio != ratio {
                        (ratio, peak) = (p.ratio, peak_at(p.ratio));
                    }
                    *mark = a / peak;
                }
            }
            Chemicals::Five(five) => {
                for ((mark, a), b) in row.iter_mut().zip(five[0][0].row(y)).zip(five[0][1].row(y)) {
                    *mark = a / (a + b);
                }
            }
        });
        for (value, masked) in values.iter_mut().zip(&self.masked) {
            if *masked {
                *value = 0.0;
            }
        }
        Field {
            width: self.problem.grid.nx,
            height: self.problem.grid.ny,
            cell: self.cell,
            edges: self.problem.grid.edges,
            values,
        }
    }

    /// The concentrations of each chemical, row by row; not the decay of uneven spots, which does not change.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        match &self.chemicals {
            Chemicals::Two(two) => two[0].iter().map(Plane::cells).collect(),
            Chemicals::Three(three) => three[0][..2].iter().map(Plane::cells).collect(),
            Chemicals::Five(five) => five[0].iter().map(Plane::cells).collect(),
        }
    }
}

/// Distance to taken cells ÷ spacing within which Turing's a is high only because it is held high there: half of where
/// its spots' edges are kept.
const RIM: f64 = 0.25;

/// Where the concentrations are those of the marks of other layers: on taken cells, and where Turing's a leaks out.
fn masked(system: System, maps: &Maps) -> Vec<bool> {
    if system != System::TuringSpots {
        return maps.obstacles.clone();
    }
    let reach = |cell: usize| (RIM * system.spacing(&maps.parameters[cell])).ceil();
    maps.grid.dilated(&maps.obstacles, reach)
}

fn step_and_swap<const N: usize, K: Kinetics<N>>(problem: &Problem, planes: &mut [[Plane; N]; 2]) {
    let [old, new] = planes;
    explicit::step::<N, K>(problem, old, new);
    planes.swap(0, 1);
}

fn sweep_and_swap<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    planes: &mut [[Plane; N]; 2],
    tiling: Tiling,
    instructions: Instructions,
    scratch: &mut Scratch,
) {
    let [old, new] = planes;
    wavefront::sweep::<N, K>(problem, old, new, tiling, instructions, scratch);
    planes.swap(0, 1);
}

/// Coefficients with the largest time step that is stable.
fn problem(system: System, maps: &Maps) -> Problem {
    let tensor = |p: Parameters| {
        let stretch = f64::from(p.stretch.max(MIN_STRETCH));
        let [along, across] = match system {
            System::TuringSpots | System::MeinhardtSpots => [1.0 / stretch, stretch],
            System::MeinhardtStripes | System::MeinhardtLines => [1.0 / (stretch * stretch), 1.0],
        };
        Tensor::oriented(along, across, f64::from(p.direction)).on_cells(maps.grid.cell)
    };
    let grid = RowLayout::new(&maps.grid);
    let at = |cell: usize| maps.parameters[cell];
    let diffusion = Diffusion::new(grid, at, tensor);
    let square = Tensor { xx: 1.0, xy: 0.0, yy: 1.0 }.on_cells(maps.grid.cell);
    let isotropic = [square.xx as f32, square.yy as f32];
    let shares = |p: &Parameters| match system {
        System::TuringSpots => [turing_spots::RATIO.sqrt(), 1.0 / turing_spots::RATIO.sqrt()],
        System::MeinhardtSpots | System::MeinhardtLines => [1.0 / p.ratio.sqrt(), p.ratio.sqrt()],
        System::MeinhardtStripes => [1.0, meinhardt_stripes::RATIO],
    };
    let fastest = |p: &Parameters| {
        let [d0, d1] = shares(p);
        match system {
            System::MeinhardtStripes | System::MeinhardtLines => {
                (d0 * diffusion.largest).max(d1 * (isotropic[0] + isotropic[1]))
            }
            _ => d0.max(d1) * diffusion.largest,
        }
    };
    let of_all = |value: &(dyn Fn(&Parameters) -> f32 + Sync)| {
        maps.parameters.par_iter().map(value).reduce(|| 0.0, f32::max)
    };
    let by_diffusion = DIFFUSION_LIMIT / of_all(&fastest);
    let lowest = maps.parameters.par_iter().map(|p| p.rate).reduce(|| f32::INFINITY, f32::min);
    let scale = by_diffusion.min(system.reaction_limit() / of_all(&|p| p.rate));
    let mobility = Coefficients::new(grid, false, at, |p| shares(&p).map(|share| scale * share));
    let rate = Coefficients::new(grid, false, at, |p| [scale * p.rate]);
    Problem::new(grid, diffusion, isotropic, mobility, rate, scale * lowest)
}

#[cfg(test)]
mod tests;
