//! One pair of morphogens on a surface: the reactions of [`crate::rd::pairs`], with a Laplacian of the mesh for each morphogen.

use std::sync::Arc;

use crate::rd::chemicals::Clock;
use crate::rd::kinetics::MOBILITIES;
use crate::rd::pairs::{
    HELD, PairField, PairModel, STEP_LIMIT, SUPER_STEP_LIMIT, held_pair_by_rows, reacting_pair_by_rows,
};
use crate::rd::selling::PrincipalAxes;
use crate::rd::solver::Solver;
use crate::rd::sparse::{Operators, ROWS, SparseChemicals, SparseProblem};
use crate::rd::super_step::{euler_steps_a_stage, suited};
use crate::surface::{Laplacian, Stretch, Surface, laplacian};

/// A pair on a surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePairField<'a> {
    /// The surface.
    pub surface: &'a Surface,
    /// The pair, by vertex: sizes in units of √(mean cell area), directions in the frame of each vertex.
    pub pair: &'a PairField,
    /// Vertices that the marks of other layers cover; empty = none. They do not change.
    pub obstacles: &'a [bool],
}

/// A pair that grows on a surface.
#[derive(Clone, Debug)]
pub struct SurfacePair {
    problem: SparseProblem,
    chemicals: Box<dyn SparseChemicals>,
    /// Time of an Euler step, in 1/b.
    euler_step: f64,
    /// Stages taken.
    steps: u64,
}

impl SurfacePair {
    /// A pair that begins at the equilibrium with this reaction, 0..1 by vertex. `None` where a length does not fit.
    #[must_use]
    pub fn new(maps: &SurfacePairField, model: &PairModel, reaction: &[f32]) -> Option<Self> {
        let (problem, euler_step) = problem(maps, model)?;
        let held = problem.operators.by_row(reaction)?;
        let empty = vec![0.0; held.len()];
        let chemicals = held_pair_by_rows(&[empty.clone(), empty, held])?;
        let mut beginning = Self { problem, chemicals, euler_step, steps: 0 };
        beginning.advance(beginning.steps_in(HELD));
        let chemicals = reacting_pair_by_rows(*model, &beginning.chemicals.rows()[..2])?;
        Some(Self { chemicals, steps: 0, ..beginning })
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

    /// The difference C₊ − C₋ by vertex.
    #[must_use]
    pub fn difference(&self) -> Vec<f32> {
        let rows = self.chemicals.rows();
        let difference: Vec<f32> = rows[0].iter().zip(&rows[1]).map(|(plus, minus)| plus - minus).collect();
        self.problem.operators.by_vertex(&difference)
    }
}

/// Coefficients with the largest time step that is stable, and its time in 1/b; `None` where a length does not fit.
fn problem(maps: &SurfacePairField, model: &PairModel) -> Option<(SparseProblem, f64)> {
    let mesh = &maps.surface.mesh;
    let count = mesh.positions.len();
    let covers = maps.obstacles.is_empty() || maps.obstacles.len() == count;
    if !covers || maps.pair.size.len() != count || maps.pair.direction.len() != count {
        return None;
    }
    let laplacians = laplacians(maps.surface, maps.pair, model);
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

/// The Laplacians of C₊ and C₋, each with a factor for each vertex.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rd::pairs::{Blurs, Combination, Course, MOST_PAIRS};
    use crate::surface::test_meshes::sphere;

    const MODEL: PairModel = PairModel {
        combination: Combination::Maximum,
        ratio: 1.5,
        threshold: Course::Constant(0.0),
        softness: 0.2,
        weights: [1.0; MOST_PAIRS],
        gain: Course::Constant(1.0),
    };

    /// A pair of even size on a small sphere, which begins with this reaction; vertices of `obstacles` are frozen.
    fn begun(reaction: impl Fn(usize) -> f32, is_obstacle: impl Fn(usize) -> bool) -> SurfacePair {
        let surface = Surface::new(sphere(14, 10.0), [1.0, 0.0, 0.0]);
        let count = surface.mesh.positions.len();
        let pair = PairField::uniform(count, 20.0, 1.8, Blurs::Along(2.0));
        let obstacles: Vec<bool> = (0..count).map(is_obstacle).collect();
        let reaction: Vec<f32> = (0..count).map(reaction).collect();
        let maps = SurfacePairField { surface: &surface, pair: &pair, obstacles: &obstacles };
        SurfacePair::new(&maps, &MODEL, &reaction).expect("lengths that fit")
    }

    #[test]
    fn an_even_reaction_makes_no_difference_and_stripes_grow_from_an_uneven_one() {
        let even = begun(|_| 0.7, |_| false);
        assert!(even.difference().iter().all(|value| value.abs() < 1e-3));
        let mut uneven = begun(|vertex| f32::from(u8::from(vertex % 7 < 3)), |_| false);
        let most = |pair: &SurfacePair| pair.difference().into_iter().fold(0.0, f32::max);
        let before = most(&uneven);
        uneven.advance(uneven.steps_in(14.0));
        assert!(most(&uneven) > 2.0 * before && most(&uneven) > 0.05, "{before} {}", most(&uneven));
    }

    #[test]
    fn all_solvers_grow_the_same_bits_and_obstacles_stay_as_they_are() {
        let start = begun(|vertex| f32::from(u8::from(vertex % 5 < 2)), |vertex| vertex % 11 == 0);
        let mut plain = start.clone();
        plain.advance_as(24, Solver::Plain);
        for (vertex, (after, before)) in plain.difference().iter().zip(start.difference()).enumerate() {
            assert_eq!(*after == before, vertex % 11 == 0, "{vertex}");
        }
        for solver in Solver::available() {
            let mut fast = start.clone();
            fast.advance_as(24, solver);
            assert!(fast.difference() == plain.difference(), "{solver:?}");
        }
    }
}
