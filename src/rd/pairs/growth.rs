//! The growth of a system of pairs: explicit steps by the kernels of all systems, and the plain twin.

use super::kinetics::{held_pairs, reacting_pairs};
use super::start::{PairStart, noise};
use super::{MOST_PAIRS, PairField, PairMaps, PairModel};
use crate::grid::{Domain, Field};
use crate::rd::chemicals::{Chemicals, Clock};
use crate::rd::coefficients::Coefficients;
use crate::rd::diffusion::Diffusion;
use crate::rd::kinetics::MOBILITIES;
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::problem::Problem;
use crate::rd::selling::Tensor;
use crate::rd::solver::Solver;
use crate::rd::wavefront::{Instructions, Scratch, Tiling};

/// Largest dt · (4Σw + b) of an explicit step: at 1.8 a checkerboard of cells persists (`facts.md` T).
const STEP_LIMIT: f32 = 1.5;

/// Time in which a reaction that is held reaches its equilibrium within 1 %, in 1/b.
pub const HELD: f64 = 5.0;

/// A pattern of pairs being grown.
#[derive(Clone, Debug)]
pub struct PairGrowth {
    problem: Problem,
    cell: [f64; 2],
    chemicals: Box<dyn Chemicals>,
    scratch: Scratch,
    /// Time of one step, in 1/b.
    step: f64,
    steps: u64,
}

impl PairGrowth {
    /// Computes the coefficients and the initial concentrations on the grid; `None` without pairs, with more than
    /// [`MOST_PAIRS`], or where a vector has another length than the grid has cells.
    #[must_use]
    pub fn new(maps: &PairMaps, model: &PairModel, start: &PairStart) -> Option<Self> {
        let cells = maps.grid.cells();
        let fits = |pair: &PairField| pair.direction.len() == cells && pair.size.len() == cells;
        let is_known = (1..=MOST_PAIRS).contains(&maps.pairs.len()) && maps.pairs.iter().all(fits);
        let covers = |values: usize| values == 0 || values == cells;
        if !is_known || !covers(maps.obstacles.len()) || !covers(maps.raised.len()) {
            return None;
        }
        let layout = RowLayout::new(&maps.grid);
        let planes = 2 * maps.pairs.len();
        let plane = |cells: &Vec<f32>| Plane::from_cells(layout, cells);
        let (problem, step) = problem(maps, model, layout);
        let concentrations = match start {
            PairStart::Noise(seed) => noise(maps, planes, *seed),
            PairStart::Drawn(reaction) => held(&problem, step, planes, plane(reaction)?),
            PairStart::Grown(concentrations) if concentrations.len() == planes => concentrations.clone(),
            PairStart::Grown(_) => return None,
        };
        let unit = model.peak_gain() * model.gain.at(0.0);
        let raised: Vec<f32> = maps.raised.iter().map(|raised| unit * raised).collect();
        let raised = (!raised.is_empty()).then_some(&raised);
        let planes = concentrations.iter().chain(raised).map(plane).collect::<Option<_>>()?;
        let chemicals = reacting_pairs(*model, planes)?;
        Some(Self { problem, cell: maps.grid.cell, chemicals, scratch: Scratch::default(), step, steps: 0 })
    }

    /// Takes `steps` explicit steps.
    pub fn advance(&mut self, steps: u64) {
        let threads = rayon::current_num_threads();
        let tiling = Tiling::suited(&self.problem, self.chemicals.planes().len(), threads);
        match Solver::chosen() {
            Solver::Plain => self.advance_plain(steps),
            Solver::Fast(instructions) => self.advance_as(steps, tiling, instructions),
        }
    }

    /// The same with this tiling and these instructions: the same bits.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        let (most, mut left) = (tiling.levels.max(1), steps);
        while left > 0 {
            let tiling = Tiling { levels: most.min(left as usize), ..tiling };
            let clock = self.clock();
            self.chemicals.sweep(&self.problem, clock, tiling, instructions, &mut self.scratch);
            left -= tiling.levels as u64;
            self.steps += tiling.levels as u64;
        }
    }

    /// The same with the plain solver, bit for bit but slower; the fast solver is tested and measured against it.
    pub fn advance_plain(&mut self, steps: u64) {
        for _ in 0..steps {
            let clock = self.clock();
            self.chemicals.step(&self.problem, clock);
            self.steps += 1;
        }
    }

    fn clock(&self) -> Clock {
        Clock { steps: self.steps, step: self.step }
    }

    /// Cells along x and y.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        [self.problem.grid.nx, self.problem.grid.ny]
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps that make up `time`, in 1/b.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.step).ceil().max(1.0) as u64
    }

    /// Time grown, in 1/b.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.step
    }

    /// The difference C₊ − C₋ of each pair.
    #[must_use]
    pub fn differences(&self) -> Vec<Field> {
        let grid = self.problem.grid;
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
        self.chemicals.planes().chunks_exact(2).map(difference).collect()
    }

    /// The concentrations of each morphogen, row by row: C₊ and C₋ of the first pair, then of the second, and so on.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.chemicals.planes().chunks_exact(2).flatten().map(Plane::cells).collect()
    }
}

/// The equilibrium of a `reaction` that is held, from nothing.
fn held(problem: &Problem, step: f64, planes: usize, reaction: Plane) -> Vec<Vec<f32>> {
    let empty = Plane::from_cells(problem.grid, &vec![0.0; problem.grid.nx * problem.grid.ny]);
    let mut all: Vec<Plane> = std::iter::repeat_n(empty, planes).flatten().collect();
    all.push(reaction);
    let Some(mut chemicals) = held_pairs(all) else { return Vec::new() };
    let (mut scratch, mut taken) = (Scratch::default(), 0);
    let steps = (HELD / step).ceil() as u64;
    let tiling = Tiling::suited(problem, planes + 1, rayon::current_num_threads());
    while taken < steps {
        let clock = Clock { steps: taken, step };
        match Solver::chosen() {
            Solver::Plain => {
                chemicals.step(problem, clock);
                taken += 1;
            }
            Solver::Fast(instructions) => {
                let levels = tiling.levels.min((steps - taken) as usize);
                chemicals.sweep(problem, clock, Tiling { levels, ..tiling }, instructions, &mut scratch);
                taken += levels as u64;
            }
        }
    }
    chemicals.planes()[..planes].iter().map(Plane::cells).collect()
}

/// Coefficients with the largest time step that is stable, and that step in 1/b.
fn problem(maps: &PairMaps, model: &PairModel, layout: RowLayout) -> (Problem, f64) {
    let d = f64::from(model.ratio);
    let tensors = |pair: &PairField, [along, across]: [f64; 2]| {
        Diffusion::new(
            layout,
            |cell| [pair.direction[cell], pair.size[cell]],
            |[direction, s]| {
                let square = f64::from(s) * f64::from(s);
                Tensor::oriented(along * along * square, across * across * square, f64::from(direction))
                    .on_cells(maps.grid.cell)
            },
        )
    };
    let tensors: Vec<Diffusion> = maps
        .pairs
        .iter()
        .flat_map(|pair| pair.blurs.lengths(d).map(|lengths| tensors(pair, lengths)))
        .collect();
    let largest = tensors.iter().map(|tensor| tensor.largest).fold(0.0, f32::max);
    let step = STEP_LIMIT / (4.0 * largest + 1.0);
    let mobility = Coefficients::new(layout, false, |_| (), |()| [step; MOBILITIES]);
    let rate = Coefficients::new(layout, false, |_| (), |()| [step]);
    let mut problem = Problem::new(layout, tensors, [1.0, 1.0], mobility, rate, step);
    if !maps.obstacles.is_empty() {
        problem.freeze(&|cell: usize| maps.obstacles[cell]);
    }
    (problem, f64::from(step))
}
