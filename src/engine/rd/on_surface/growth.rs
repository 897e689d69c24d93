//! Growth on a surface as a value: created from parameters, advanced step by step, read at any time.

use std::sync::Arc;

use crate::grid::Domain;
use crate::rd::chemicals::Clock;
use crate::rd::definition::System;
use crate::rd::growth::{change, masked, peaks};
use crate::rd::parameter_field::ParameterField;
use crate::rd::solver::Solver;
use crate::rd::sparse::{Operators, SparseChemicals, SparseProblem};
use crate::rd::super_step::euler_steps_a_stage;

/// A pattern being grown on a surface.
#[derive(Clone, Debug)]
pub struct SurfaceGrowth {
    system: System,
    pub(super) problem: SparseProblem,
    chemicals: Box<dyn SparseChemicals>,
    /// The concentration at the centre of a mark, by vertex; empty where it is the same everywhere.
    peaks: Vec<f32>,
    /// Vertices that show the marks of other layers, not of this pattern.
    masked: Vec<bool>,
    /// Normalised time that an Euler step takes where the reactions are slowest.
    time_of_euler_step: f64,
    /// Stages taken, whole super steps.
    steps: u64,
}

impl SurfaceGrowth {
    /// A growth from these concentrations, one vector a chemical, by vertex. `operators` are those of the domain's mesh and the same stretches
    /// and directions.
    ///
    /// `None` for a system that does not grow on surfaces, and where a number or length does not fit.
    #[must_use]
    pub fn new<D: Domain>(
        system: System,
        maps: &ParameterField<D>,
        operators: Arc<Operators>,
        concentrations: &[Vec<f32>],
    ) -> Option<Self> {
        let reacting = system.definition().by_rows?;
        let count = operators.vertices();
        let fits = |length: usize| length == count;
        let has_obstacles = !maps.obstacles.is_empty();
        if !operators.fit(system)
            || !fits(maps.parameters.len())
            || has_obstacles && !fits(maps.obstacles.len())
        {
            return None;
        }
        let rows = concentrations.iter().map(|chemical| operators.by_row(chemical));
        let rows = rows.collect::<Option<Vec<_>>>()?;
        let noise = match maps.decay_noise.as_slice() {
            [] => Vec::new(),
            noise => operators.by_row(noise)?,
        };
        let chemicals = reacting(&rows, &noise)?;
        let mut problem = SparseProblem::new(system, operators, &maps.parameters);
        if has_obstacles {
            problem.freeze(|vertex| maps.obstacles[vertex]);
        }
        let time_of_euler_step = f64::from(problem.slowest) * f64::from(system.definition().decay);
        let (peaks, masked) = (peaks(system, maps), masked(system, maps));
        Some(Self { system, problem, chemicals, peaks, masked, time_of_euler_step, steps: 0 })
    }

    /// This growth, before its first step, set to take super steps of `stages`; 1 = Euler steps.
    #[must_use]
    pub fn with_stages(mut self, stages: usize) -> Self {
        self.problem.stages = stages.max(1);
        self.steps = 0;
        self
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
    pub fn advance(&mut self, steps: u64) {
        self.advance_as(steps, Solver::chosen());
    }

    /// Takes `steps` explicit steps with the plain solver: the same bits, slower. The fast solver is tested and measured against
    /// it.
    pub fn advance_plain(&mut self, steps: u64) {
        self.advance_as(steps, Solver::Plain);
    }

    /// Takes `steps` explicit steps with this solver. All give the same bits.
    pub fn advance_as(&mut self, steps: u64, solver: Solver) {
        for _ in 0..steps.next_multiple_of(self.problem.stages as u64) {
            let clock = Clock { steps: self.steps, step: self.time_a_step() };
            self.chemicals.step(&self.problem, clock, solver);
            self.steps += 1;
        }
    }

    /// Normalised time that a step takes where the reactions are slowest.
    fn time_a_step(&self) -> f64 {
        self.time_of_euler_step * euler_steps_a_stage(self.problem.stages)
    }

    /// Steps taken: the stages of super steps count one by one, as each is as much work as an Euler step.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps that make up `time` of normalised time (`facts.md` 0) where the reactions are slowest.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step()).ceil().max(1.0) as u64
    }

    /// The concentration that shows the marks, by vertex: about 0 on the ground, about 1 at the centre of a mark with the
    /// parameters there.
    #[must_use]
    pub fn marks(&self) -> Vec<f32> {
        let concentrations = self.concentrations();
        let chemicals: Vec<&[f32]> = concentrations.iter().map(Vec::as_slice).collect();
        let mut marks = vec![0.0; self.problem.operators.vertices()];
        (self.system.definition().show)(&chemicals, &self.peaks, &mut marks);
        for (mark, masked) in marks.iter_mut().zip(&self.masked) {
            if *masked {
                *mark = 0.0;
            }
        }
        marks
    }

    /// Replaces `marks`, values that [`Self::marks`] gave earlier, by those of now. Returns Σ|after − before| and
    /// Σ max(after, 0) over the vertices that `count`.
    pub fn update_marks(&self, marks: &mut [f32], count: &[bool]) -> [f64; 2] {
        let after = self.marks();
        let sums = change(marks, &after, count);
        marks.copy_from_slice(&after);
        sums
    }

    /// The concentrations of each chemical, by vertex.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.chemicals.rows().iter().map(|rows| self.problem.operators.by_vertex(rows)).collect()
    }
}
