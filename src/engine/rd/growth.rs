//! Growth as a value: created from parameters, advanced step by step, read at any time.

use multiversion::multiversion;
use rayon::prelude::*;

use super::coefficients::Coefficients;
use super::definition::System;
use super::diffusion::Diffusion;
use super::initial_conditions::fresh;
use super::kinetics::{MOBILITIES, Spreading};
use super::local_warp::{LocalWarp, Moves, rows, shifts};
use super::parameter_field::{ParameterField, Parameters};
use super::plane::{Plane, RowLayout};
use super::problem::Problem;
use super::selling::Tensor;
use super::stepper::Stepper;
use super::super_step;
use super::wavefront::{Instructions, Tiling};
use crate::grid::{Domain, Field};

/// Largest dt·D·Σw of a step. Diffusion is monotone up to ½; with reactions 0.45 gave no noise (`facts.md` A).
pub(super) const DIFFUSION_LIMIT: f32 = 0.45;

/// Grids of fewer cells than this are stepped by Euler steps, whose cost does not matter there. On such a small canvas stripes may
/// be wider than the canvas: a − b of the flat state neither grows nor decays at first, and the smallest error decides whether
/// everything becomes mark or ground (`facts.md` S).
const FEWEST_CELLS: usize = 1_024;

/// A pattern being grown.
#[derive(Clone, Debug)]
pub struct Growth {
    system: System,
    /// Its times are normalised, in the cells where the reactions are slowest.
    stepper: Stepper,
    cell: [f64; 2],
    /// The concentration at the centre of a mark, by cell; empty if it is equal everywhere.
    peaks: Vec<f32>,
    /// Cells that show the marks of other layers, not of this pattern.
    masked: Vec<bool>,
}

/// The marks at the start of [`Growth::new`], as [`Growth::marks`] shows them.
#[must_use]
pub fn initial_marks(system: System, maps: &ParameterField, seed: u64) -> Field {
    Growth::new(system, maps, seed).marks()
}

impl Growth {
    /// A growth at its start: computes the coefficients and the initial concentrations on the grid.
    ///
    /// # Panics
    /// Never for a system of [`System::ALL`]: each begins with the chemicals that it steps.
    #[must_use]
    pub fn new(system: System, maps: &ParameterField, seed: u64) -> Self {
        let concentrations = fresh(system, maps, seed);
        Self::resumed(system, maps, concentrations).expect("a system begins with its own chemicals")
    }

    /// Continues from saved `concentrations` (as [`Self::concentrations`] gives them) instead of a fresh start.
    ///
    /// `None` where their number or length does not fit the system and the grid.
    #[must_use]
    pub fn resumed(system: System, maps: &ParameterField, concentrations: Vec<Vec<f32>>) -> Option<Self> {
        let grid = RowLayout::new(&maps.domain);
        // Passed by value, so that the memory of each vector is freed for the next.
        let plane = |cells: Vec<f32>| Plane::from_cells(grid, &cells);
        let planes: Vec<Plane> = concentrations.into_par_iter().map(plane).collect::<Option<_>>()?;
        let chemicals = (system.definition().reacting)(maps, grid, planes)?;
        let mut problem = problem(system, maps, grid);
        if !maps.obstacles.is_empty() {
            problem.freeze(&|cell: usize| maps.obstacles[cell]);
        }
        let time_of_euler_step = f64::from(problem.slowest) * f64::from(system.definition().decay);
        let masked = masked(system, maps);
        let peaks = peaks(system, maps);
        let stepper = Stepper::new(problem, chemicals, time_of_euler_step);
        Some(Self { peaks, masked, system, stepper, cell: maps.domain.cell })
    }

    /// Keeps the cells that `frozen` names (`y · nx + x`) constant from now on, while they still affect their neighbours. Their
    /// concentrations must be such that the reaction stays finite.
    pub fn freeze(&mut self, frozen: impl Fn(usize) -> bool + Sync) {
        self.stepper.problem.freeze(&frozen);
    }

    /// Moves spots of the pattern that grows in `maps`. Planes other than those of the chemicals are not moved.
    pub fn warp(&mut self, maps: &ParameterField, warps: &[LocalWarp]) {
        let shifts = shifts(self.system, maps, warps);
        let moves = Moves::new(&maps.domain, &shifts);
        let count = self.system.chemicals().len();
        let nx = self.stepper.problem.grid.nx;
        for plane in &mut self.stepper.chemicals.planes_mut()[..count] {
            let moved = moves.moved(|y| plane.row(y));
            for (y, indices) in rows(&maps.domain, &shifts) {
                let values = shifts[indices.clone()].iter().zip(&moved[indices]);
                plane.change_row(y, |row| {
                    values.for_each(|((cell, _), value)| row[cell - y * nx] = *value);
                });
            }
        }
    }

    /// This growth, before its first step, set to take super steps of `stages`; 1 = Euler steps.
    #[must_use]
    pub fn with_stages(mut self, stages: usize) -> Self {
        self.stepper = self.stepper.with_stages(stages);
        self
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
    ///
    /// ```
    /// use dapple_engine::grid::Edges;
    /// use dapple_engine::rd::{Growth, ParameterField, Parameters, System};
    ///
    /// let parameters = Parameters { rate: 0.02, ratio: 30.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    /// let maps = ParameterField::uniform([32, 32], Edges::Wrap, parameters);
    /// let mut growth = Growth::new(System::MEINHARDT_SPOTS, &maps, 1);
    /// growth.advance(20);
    /// assert!(growth.steps() >= 20);
    /// assert!(growth.concentrations().iter().flatten().all(|value| value.is_finite()));
    /// ```
    pub fn advance(&mut self, steps: u64) {
        self.stepper.advance(steps);
    }

    /// Takes `steps` explicit steps with this tiling and these instructions. The bits do not depend on the two.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        self.stepper.advance_as(steps, tiling, instructions);
    }

    /// Takes `steps` explicit steps with the plain solver, which gives the bits of the fast solver, but more slowly. The fast
    /// solver is tested and measured against it.
    pub fn advance_plain(&mut self, steps: u64) {
        self.stepper.advance_plain(steps);
    }

    /// Number of Euler steps that take as much time as one step.
    #[must_use]
    pub fn euler_steps_a_step(&self) -> f64 {
        self.stepper.euler_steps_a_step()
    }

    /// Normalised time that a step takes where the reactions are slowest.
    fn time_a_step(&self) -> f64 {
        self.stepper.time_a_step()
    }

    /// Steps taken: the stages of super steps count one by one, as each is as much work as an Euler step.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.stepper.steps()
    }

    /// Steps that make up `time` of normalised time (`facts.md` 0) where the reactions are slowest.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step()).ceil().max(1.0) as u64
    }

    /// Normalised time of the growth so far, in the cells where the reactions are slowest.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps() as f64 * self.time_a_step()
    }

    /// The concentration that shows the marks, high inside them: about 0 on the ground, about 1 at the centre of a
    /// mark with the parameters there.
    #[must_use]
    pub fn marks(&self) -> Field {
        let nx = self.stepper.problem.grid.nx;
        let mut values = vec![0.0; nx * self.stepper.problem.grid.ny];
        values.par_chunks_mut(nx).enumerate().for_each(|(y, row)| self.show_row(y, row));
        Field {
            width: self.stepper.problem.grid.nx,
            height: self.stepper.problem.grid.ny,
            cell: self.cell,
            edges: self.stepper.problem.grid.edges,
            values,
        }
    }

    /// Writes row `y` of [`Self::marks`].
    fn show_row(&self, y: usize, row: &mut [f32]) {
        let nx = self.stepper.problem.grid.nx;
        let chemicals: Vec<&[f32]> =
            self.stepper.chemicals.planes().iter().map(|plane| plane.row(y)).collect();
        let peaks = self.peaks.get(y * nx..).unwrap_or_default();
        (self.system.definition().show)(&chemicals, peaks, row);
        for (value, masked) in row.iter_mut().zip(self.masked.get(y * nx..).unwrap_or_default()) {
            if *masked {
                *value = 0.0;
            }
        }
    }

    /// Replaces `marks`, earlier values of [`Self::marks`], by the current ones. Returns Σ|after − before| and Σ max(after, 0) over
    /// the cells that `count`.
    pub fn update_marks(&self, marks: &mut [f32], count: &[bool]) -> [f64; 2] {
        let nx = self.stepper.problem.grid.nx;
        let rows = marks.par_chunks_mut(nx).zip(count.par_chunks(nx)).enumerate();
        let row = |after: &mut Vec<f32>, (y, (before, count)): (usize, (&mut [f32], &[bool]))| {
            after.resize(nx, 0.0);
            self.show_row(y, after);
            let sums = change(before, after, count);
            before.copy_from_slice(after);
            sums
        };
        // Summed by row, so that the number of threads does not change the sum.
        let rows: Vec<[f64; 2]> = rows.map_init(Vec::new, row).collect();
        rows.iter().fold([0.0; 2], |[moved, total], [m, t]| [moved + m, total + t])
    }

    /// The concentrations of each chemical, row by row, without the other planes.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        let count = self.system.chemicals().len();
        self.stepper.chemicals.planes()[..count].iter().map(Plane::cells).collect()
    }
}

/// The concentration at the centre of a mark in each cell.
pub(super) fn peaks<D: Domain>(system: System, maps: &ParameterField<D>) -> Vec<f32> {
    let Some(of) = system.definition().peaks else { return Vec::new() };
    let mut peaks = vec![0.0; maps.parameters.len()];
    let part = maps.domain.part();
    peaks.par_chunks_mut(part).zip(maps.parameters.par_chunks(part)).for_each(|(peaks, parameters)| {
        let mut ratios = [f32::NAN; TOGETHER];
        for (peaks, parameters) in peaks.chunks_mut(TOGETHER).zip(parameters.chunks(TOGETHER)) {
            ratios.iter_mut().zip(parameters).for_each(|(ratio, p)| *ratio = p.ratio);
            of(&ratios[..peaks.len()], peaks);
        }
    });
    peaks
}

/// Cells whose peaks are computed side by side. Not tuned.
const TOGETHER: usize = 64;

/// Sums that are added up side by side.
const SUMS: usize = 8;

/// Σ|after − before| and Σ max(after, 0) over the cells that `count`.
#[multiversion(targets("x86_64+avx2"))]
pub(super) fn change(before: &[f32], after: &[f32], count: &[bool]) -> [f64; 2] {
    let (mut moved, mut total) = ([0.0f64; SUMS], [0.0f64; SUMS]);
    let eights = before.chunks(SUMS).zip(after.chunks(SUMS)).zip(count.chunks(SUMS));
    for ((before, after), count) in eights {
        let sums = moved.iter_mut().zip(&mut total);
        for (((b, a), counts), (moved, total)) in before.iter().zip(after).zip(count).zip(sums) {
            let [change, height] = if *counts { [(a - b).abs(), a.max(0.0)] } else { [0.0; 2] };
            *moved += f64::from(change);
            *total += f64::from(height);
        }
    }
    [moved.iter().sum(), total.iter().sum()]
}

/// Cells whose concentrations belong to the marks of other layers: obstacle cells, and cells that obstacles affect.
pub(super) fn masked<D: Domain>(system: System, maps: &ParameterField<D>) -> Vec<bool> {
    let rim = system.definition().obstacle_rim;
    if rim == 0.0 {
        return maps.obstacles.clone();
    }
    let reach = |cell: usize| (rim * system.spacing(&maps.parameters[cell])).ceil();
    maps.domain.dilated(&maps.obstacles, reach)
}

/// Coefficients with the largest Euler step that is stable, and super steps as long as the reactions allow.
fn problem(system: System, maps: &ParameterField, grid: RowLayout) -> Problem {
    let definition = system.definition();
    let tensors: Vec<Diffusion> = definition
        .tensors
        .iter()
        .map(|axes| Diffusion::new(grid, maps.domain.cell, |cell| axes(&maps.parameters[cell])))
        .collect();
    let square = Tensor { xx: 1.0, xy: 0.0, yy: 1.0 }.on_cells(maps.domain.cell);
    let isotropic = [square.xx as f32, square.yy as f32];
    // For each mobility, the largest sum of the weights of the chemicals that spread with it.
    let mut sums = [0.0f32; MOBILITIES];
    for spreading in definition.spread {
        let (mobility, sum) = match *spreading {
            Spreading::Tensor { tensor, mobility } => (mobility, tensors[tensor].largest),
            Spreading::Isotropic { mobility } => (mobility, isotropic[0] + isotropic[1]),
            Spreading::Still => continue,
        };
        sums[mobility] = sums[mobility].max(sum);
    }
    let fastest = |p: &Parameters| {
        let mobilities = (definition.mobilities)(p);
        mobilities.iter().zip(&sums).map(|(mobility, sum)| mobility * sum).fold(0.0, f32::max)
    };
    let Extremes { diffusion, rate: [lowest, fastest_reaction] } = Extremes::of(&maps.parameters, &fastest);
    let scale = (DIFFUSION_LIMIT / diffusion).min(definition.reaction_limit / fastest_reaction);
    let mobilities = |cell: usize| (definition.mobilities)(&maps.parameters[cell]);
    let mobility = Coefficients::new(grid, mobilities, |mobilities| mobilities.map(|share| scale * share));
    let rate = Coefficients::new(grid, |cell| maps.parameters[cell].rate, |rate| [scale * rate]);
    let stages = if grid.nx * grid.ny < FEWEST_CELLS {
        1
    } else {
        super_step::suited(scale * fastest_reaction, definition.super_step_limit)
    };
    Problem { stages, ..Problem::new(grid, tensors, isotropic, mobility, rate, scale * lowest) }
}

/// The extremes that limit the time step of all cells.
struct Extremes {
    /// The largest mobility × sum of stencil weights.
    diffusion: f32,
    /// The least and the largest rate, 1 ÷ cell².
    rate: [f32; 2],
}

impl Extremes {
    /// The ranges of `parameters`, and of the values that `diffusion` gives for them.
    fn of(parameters: &[Parameters], diffusion: &(impl Fn(&Parameters) -> f32 + Sync)) -> Self {
        let none = || Self { diffusion: 0.0, rate: [f32::INFINITY, 0.0] };
        let with = |extremes: Self, p: &Parameters| Self {
            diffusion: extremes.diffusion.max(diffusion(p)),
            rate: [extremes.rate[0].min(p.rate), extremes.rate[1].max(p.rate)],
        };
        let both = |a: Self, b: Self| Self {
            diffusion: a.diffusion.max(b.diffusion),
            rate: [a.rate[0].min(b.rate[0]), a.rate[1].max(b.rate[1])],
        };
        parameters.par_iter().fold(none, with).reduce(none, both)
    }
}

mod part;
#[cfg(test)]
mod super_step_tests;
#[cfg(test)]
mod tests;
