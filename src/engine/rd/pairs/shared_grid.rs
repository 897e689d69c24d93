//! Pairs on one grid: explicit steps by the kernels of all systems, or by the plain solver. They react at each stage of a step.

use super::kinetics::{held_pairs, reacting_pairs, reaction_by_shares};
use super::start::{HELD, PairStart, noise};
use super::{PairField, PairModel, PairParameterField};
use crate::grid::{Domain, Field};
use crate::rd::coefficients::Coefficients;
use crate::rd::diffusion::Diffusion;
use crate::rd::kinetics::MOBILITIES;
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::problem::Problem;
use crate::rd::selling::PrincipalAxes;
use crate::rd::stepper::Stepper;
use crate::rd::super_step::suited;
use crate::rd::wavefront::{Instructions, Tiling};

/// Largest dt · (4Σw + b) of an explicit step: at 1.8 a checkerboard of cells persists (`facts.md` T).
pub(in crate::rd) const STEP_LIMIT: f32 = 1.5;
/// Longest super step, in 1/b.
pub(in crate::rd) const SUPER_STEP_LIMIT: f32 = 0.25;

/// Pairs being grown on one grid.
#[derive(Clone, Debug)]
pub(super) struct SharedGrid {
    /// Its times are in 1/b.
    stepper: Stepper,
    cell: [f64; 2],
}

impl SharedGrid {
    /// Computes the coefficients and the initial concentrations; `None` if the length of a vector is not the number of cells.
    pub fn new(maps: &PairParameterField, model: &PairModel, start: &PairStart) -> Option<Self> {
        let layout = RowLayout::new(&maps.grid);
        let planes = 2 * maps.pairs.len();
        let plane = |cells: &Vec<f32>| Plane::from_cells(layout, cells);
        let (mut problem, euler_step) = problem(maps, model, layout);
        let concentrations = match start {
            PairStart::Noise(seed) => {
                (0..planes).map(|plane| noise(maps.grid.cells(), plane, *seed)).collect()
            }
            PairStart::Drawn(reaction) => {
                let concentrations;
                (problem, concentrations) = held(problem, euler_step, planes, plane(reaction)?)?;
                concentrations
            }
            PairStart::Grown(concentrations) if concentrations.len() == planes => concentrations.clone(),
            PairStart::Grown(_) => return None,
        };
        let unit = model.peak_gain() * model.gain.at(0.0);
        let raised: Vec<f32> = maps.raised.iter().map(|raised| unit * raised).collect();
        let raised = (!raised.is_empty()).then_some(&raised);
        let planes = concentrations.iter().chain(raised).map(plane).collect::<Option<_>>()?;
        let chemicals = reacting_pairs(*model, planes)?;
        Some(Self { stepper: Stepper::new(problem, chemicals, euler_step), cell: maps.grid.cell })
    }

    /// This growth, before its first step, set to take super steps of `stages`; 1 = Euler steps.
    pub fn with_stages(mut self, stages: usize) -> Self {
        self.stepper = self.stepper.with_stages(stages);
        self
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
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

    /// Takes one super step in which the reaction is held at the shares of the cells above the threshold; `None` if `raised`
    /// is for another number of cells. No other step can follow but one of these.
    pub fn advance_by_shares(&mut self, model: &PairModel, raised: &[f32]) -> Option<()> {
        let layout = self.stepper.problem.grid;
        if !(raised.is_empty() || raised.len() == layout.nx * layout.ny) {
            return None;
        }
        let unit = model.peak_gain() * model.gain.at(0.0);
        let raised: Vec<f32> = raised.iter().map(|raised| unit * raised).collect();
        let differences: Vec<Vec<f32>> = self.differences().into_iter().map(|field| field.values).collect();
        let time = self.steps() as f64 * self.time_a_step();
        let reaction = reaction_by_shares(model, &differences, &raised, time, &layout);
        let planes = self.stepper.chemicals.planes();
        let pairs = planes[..planes.len() / 2 * 2].iter().cloned();
        let planes = pairs.chain([Plane::from_cells(layout, &reaction)?]).collect();
        self.stepper.chemicals = held_pairs(planes)?;
        self.stepper.advance(self.stepper.problem.stages as u64);
        Some(())
    }

    /// Cells along x and y.
    pub fn size(&self) -> [usize; 2] {
        [self.stepper.problem.grid.nx, self.stepper.problem.grid.ny]
    }

    /// Stages taken.
    pub fn steps(&self) -> u64 {
        self.stepper.steps()
    }

    /// Time of one stage, in 1/b.
    pub fn time_a_step(&self) -> f64 {
        self.stepper.time_a_step()
    }

    /// The difference C₊ − C₋ of each pair.
    pub fn differences(&self) -> Vec<Field> {
        let grid = self.stepper.problem.grid;
        let difference = |pair: &[Plane]| {
            let rows = (0..grid.ny).flat_map(|y| pair[0].row(y).iter().zip(pair[1].row(y)));
            Field {
                width: grid.nx,
                height: grid.ny,
                cell: self.cell,
                edges: grid.edges,
                values: rows.map(|(plus, minus)| plus - minus).collect(),
            }
        };
        self.stepper.chemicals.planes().chunks_exact(2).map(difference).collect()
    }

    /// The concentrations of each morphogen, row by row: C₊ and C₋ of the first pair, then of the second, and so on.
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.stepper.chemicals.planes().chunks_exact(2).flatten().map(Plane::cells).collect()
    }
}

/// The problem, and its equilibrium with a constant `reaction`, reached from 0; `None` if the reaction is on another grid.
fn held(
    problem: Problem,
    euler_step: f64,
    planes: usize,
    reaction: Plane,
) -> Option<(Problem, Vec<Vec<f32>>)> {
    let empty = Plane::from_cells(problem.grid, &vec![0.0; problem.grid.nx * problem.grid.ny]);
    let mut all: Vec<Plane> = std::iter::repeat_n(empty, planes).flatten().collect();
    all.push(reaction);
    let mut stepper = Stepper::new(problem, held_pairs(all)?, euler_step);
    stepper.advance((HELD / stepper.time_a_step()).ceil() as u64);
    let concentrations = stepper.chemicals.planes()[..planes].iter().map(Plane::cells).collect();
    Some((stepper.problem, concentrations))
}

/// Coefficients with the largest time step that is stable, and its time in 1/b.
fn problem(maps: &PairParameterField, model: &PairModel, layout: RowLayout) -> (Problem, f64) {
    let of_pair = |pair: &PairField| tensors(pair, model, layout, maps.grid.cell);
    let tensors: Vec<Diffusion> = maps.pairs.iter().flat_map(of_pair).collect();
    let largest = tensors.iter().map(|tensor| tensor.largest).fold(0.0, f32::max);
    let step = STEP_LIMIT / (4.0 * largest + 1.0);
    let stages = suited(step, SUPER_STEP_LIMIT);
    let mobility = Coefficients::new(layout, |_| (), |()| [step; MOBILITIES]);
    let rate = Coefficients::new(layout, |_| (), |()| [step]);
    let problem = Problem::new(layout, tensors, [1.0, 1.0], mobility, rate, step);
    let mut problem = Problem { stages, ..problem };
    if !maps.obstacles.is_empty() {
        problem.freeze(&|cell: usize| maps.obstacles[cell]);
    }
    (problem, f64::from(step))
}

/// The tensors of C₊ and of C₋ of a pair on cells of this size.
pub(super) fn tensors(
    pair: &PairField,
    model: &PairModel,
    layout: RowLayout,
    cell: [f64; 2],
) -> [Diffusion; 2] {
    pair.blurs.lengths(f64::from(model.ratio)).map(|[along, across]| {
        Diffusion::new(layout, cell, |cell| {
            let square = f64::from(pair.size[cell]) * f64::from(pair.size[cell]);
            PrincipalAxes {
                along: along * along * square,
                across: across * across * square,
                degrees: f64::from(pair.direction[cell]),
            }
        })
    })
}
