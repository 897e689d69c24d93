//! Pairs of morphogens on a surface: the reactions of [`crate::rd::pairs`], with a Laplacian of the mesh for each morphogen.

use std::sync::Arc;

use crate::rd::chemicals::Clock;
use crate::rd::kinetics::MOBILITIES;
use crate::rd::pairs::{
    HELD, PairField, PairModel, STEP_LIMIT, SUPER_STEP_LIMIT, held_pairs_by_rows, reacting_pairs_by_rows,
};
use crate::rd::selling::PrincipalAxes;
use crate::rd::solver::Solver;
use crate::rd::sparse::{Operators, ROWS, SparseChemicals, SparseProblem};
use crate::rd::super_step::{euler_steps_a_stage, suited};
use crate::surface::{Laplacian, Stretch, Surface, laplacian};

/// One or two pairs on a surface. Sizes are in units of √(mean cell area), directions in the frame of each vertex.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePairField<'a> {
    /// The surface.
    pub surface: &'a Surface,
    /// The pairs, by vertex.
    pub pairs: &'a [PairField],
    /// Vertices that the marks of other layers cover; empty = none. They do not change.
    pub obstacles: &'a [bool],
}

/// Pairs being grown on a surface.
#[derive(Clone, Debug)]
pub struct SurfacePairs {
    problem: SparseProblem,
    chemicals: Box<dyn SparseChemicals>,
    /// Time of an Euler step, in 1/b.
    euler_step: f64,
    /// Stages taken.
    steps: u64,
}

impl SurfacePairs {
    /// Pairs that begin at the equilibrium with this reaction, 0..1 by vertex. `None` for other than one or two pairs, or where a length does
    /// not fit.
    #[must_use]
    pub fn from_reaction(maps: &SurfacePairField, model: &PairModel, reaction: &[f32]) -> Option<Self> {
        let (problem, euler_step) = problem(maps, model)?;
        let rows = by_row(&problem, reaction)?;
        let morphogens = 2 * maps.pairs.len();
        let mut all = vec![vec![0.0; rows.len()]; morphogens];
        all.push(rows);
        let mut held = Self { chemicals: held_pairs_by_rows(&all)?, problem, euler_step, steps: 0 };
        held.advance((HELD / held.time_a_step()).ceil() as u64);
        let mut concentrations = held.concentrations();
        // The last one is the reaction.
        concentrations.pop();
        Self::begun(held.problem, euler_step, model, &concentrations)
    }

    /// Pairs that go on from these concentrations, C₊ and C₋ of the first pair, then of the second, by vertex. `None` as in
    /// [`Self::from_reaction`].
    #[must_use]
    pub fn resumed(maps: &SurfacePairField, model: &PairModel, concentrations: &[Vec<f32>]) -> Option<Self> {
        let (problem, euler_step) = problem(maps, model)?;
        Self::begun(problem, euler_step, model, concentrations)
    }

    fn begun(
        problem: SparseProblem,
        euler_step: f64,
        model: &PairModel,
        concentrations: &[Vec<f32>],
    ) -> Option<Self> {
        let rows = concentrations.iter().map(|of| by_row(&problem, of)).collect::<Option<Vec<_>>>()?;
        Some(Self { chemicals: reacting_pairs_by_rows(*model, &rows)?, problem, euler_step, steps: 0 })
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
    pub fn advance(&mut self, steps: u64) {
        self.advance_as(steps, Solver::chosen());
    }

    /// Takes `steps` explicit steps with this solver. All give the same bits.
    pub fn advance_as(&mut self, steps: u64, solver: Solver) {
        for _ in 0..steps.next_multiple_of(self.problem.stages as u64) {
            let clock = Clock { steps: self.steps, step: self.time_a_step() };
            self.chemicals.step(&self.problem, clock, solver);
            self.steps += 1;
        }
    }

    /// Steps taken: the stages of super steps count one by one.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps that make up `time`, in 1/b.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step()).ceil().max(1.0) as u64
    }

    fn time_a_step(&self) -> f64 {
        self.euler_step * euler_steps_a_stage(self.problem.stages)
    }

    /// The difference C₊ − C₋ of each pair, by vertex.
    #[must_use]
    pub fn differences(&self) -> Vec<Vec<f32>> {
        let difference =
            |pair: &[Vec<f32>]| pair[0].iter().zip(&pair[1]).map(|(plus, minus)| plus - minus).collect();
        self.concentrations().chunks_exact(2).map(difference).collect()
    }

    /// The concentrations of each morphogen, by vertex: C₊ and C₋ of the first pair, then of the second.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        let by_vertex = |rows: Vec<f32>| {
            let mut values = vec![0.0; rows.len()];
            for (vertex, value) in self.problem.operators.order.iter().zip(rows) {
                values[*vertex as usize] = value;
            }
            values
        };
        self.chemicals.rows().into_iter().map(by_vertex).collect()
    }
}

/// Values by vertex in the order of the rows; `None` for another number.
fn by_row(problem: &SparseProblem, values: &[f32]) -> Option<Vec<f32>> {
    let order = &problem.operators.order;
    (values.len() == order.len()).then(|| order.iter().map(|vertex| values[*vertex as usize]).collect())
}

/// Coefficients with the largest time step that is stable, and its time in 1/b; `None` where a length does not fit.
fn problem(maps: &SurfacePairField, model: &PairModel) -> Option<(SparseProblem, f64)> {
    let mesh = &maps.surface.mesh;
    let count = mesh.positions.len();
    let fits = |pair: &PairField| pair.size.len() == count && pair.direction.len() == count;
    let covers = maps.obstacles.is_empty() || maps.obstacles.len() == count;
    if !covers || !maps.pairs.iter().all(fits) {
        return None;
    }
    let of_pair = |pair: &PairField| laplacians(maps.surface, pair, model);
    let laplacians: Vec<(Laplacian, Vec<f64>)> = maps.pairs.iter().flat_map(of_pair).collect();
    let operators = Arc::new(Operators::of(&laplacians, mesh.area() / count.max(1) as f64));
    let sums = operators.rows.iter().flat_map(|rows| (0..count).map(|row| rows.sum(row)));
    // The stencils of grids count each weight for two neighbours.
    let step = STEP_LIMIT / (2.0 * sums.fold(0.0, f32::max) + 1.0);
    let filled = count.next_multiple_of(ROWS);
    let of_rows = || {
        let mut values = vec![step; count];
        values.resize(filled, 0.0);
        values
    };
    let mut problem = SparseProblem {
        mobility: [(); MOBILITIES].map(|()| of_rows()),
        rate: of_rows(),
        slowest: step,
        stages: suited(step, SUPER_STEP_LIMIT),
        operators,
    };
    if !maps.obstacles.is_empty() {
        problem.freeze(|vertex| maps.obstacles[vertex]);
    }
    Some((problem, f64::from(step)))
}

/// The Laplacians of C₊ and C₋ of a pair, each with a factor for each vertex.
fn laplacians(surface: &Surface, pair: &PairField, model: &PairModel) -> [(Laplacian, Vec<f64>); 2] {
    pair.blurs.lengths(f64::from(model.ratio)).map(|[along, across]| {
        let axes = pair.direction.iter().zip(&pair.size).map(|(direction, size)| {
            let square = f64::from(*size) * f64::from(*size);
            PrincipalAxes {
                along: along * along * square,
                across: across * across * square,
                degrees: f64::from(*direction),
            }
        });
        let (stretch, factors): (Vec<Stretch>, Vec<f64>) = axes.map(PrincipalAxes::parted).unzip();
        (laplacian(&surface.mesh, surface.frames(), &stretch), factors)
    })
}
