//! Chemicals on a grid that are advanced by explicit steps.

use super::chemicals::{Chemicals, Clock};
use super::problem::Problem;
use super::solver::Solver;
use super::super_step::euler_steps_a_stage;
use super::wavefront::{Instructions, Scratch, Tiling};

/// Chemicals with the problem that they solve, and the number of steps taken.
#[derive(Clone, Debug)]
pub(super) struct Stepper {
    pub problem: Problem,
    pub chemicals: Box<dyn Chemicals>,
    scratch: Scratch,
    /// Time that an Euler step takes.
    euler_step: f64,
    /// Stages taken, whole super steps.
    steps: u64,
}

impl Stepper {
    /// A stepper before its first step; an Euler step takes the time `euler_step`.
    pub fn new(problem: Problem, chemicals: Box<dyn Chemicals>, euler_step: f64) -> Self {
        Self { problem, chemicals, scratch: Scratch::default(), euler_step, steps: 0 }
    }

    /// This stepper, before its first step, set to take super steps of `stages`; 1 = Euler steps.
    pub fn with_stages(mut self, stages: usize) -> Self {
        self.problem.stages = stages.max(1);
        self.steps = 0;
        self
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
    pub fn advance(&mut self, steps: u64) {
        let threads = rayon::current_num_threads();
        let tiling = Tiling::suited(&self.problem, self.chemicals.planes().len(), threads);
        match Solver::chosen() {
            Solver::Plain => self.advance_plain(steps),
            Solver::Fast(instructions) => self.advance_as(steps, tiling, instructions),
        }
    }

    /// Takes `steps` explicit steps with this tiling and these instructions. The bits do not depend on the two.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        let tiling = tiling.with_whole(self.problem.stages);
        let mut left = self.whole(steps);
        while left > 0 {
            let tiling = Tiling { time_steps: tiling.time_steps.min(left as usize), ..tiling };
            let clock = self.clock();
            self.chemicals.sweep(&self.problem, clock, tiling, instructions, &mut self.scratch);
            left -= tiling.time_steps as u64;
            self.steps += tiling.time_steps as u64;
        }
    }

    /// Takes `steps` explicit steps with the plain solver, which gives the bits of the fast solver, but more slowly. The fast
    /// solver is tested and measured against it.
    pub fn advance_plain(&mut self, steps: u64) {
        for _ in 0..self.whole(steps) {
            let clock = self.clock();
            self.chemicals.step(&self.problem, clock);
            self.steps += 1;
        }
    }

    /// `steps`, rounded up to whole super steps.
    fn whole(&self, steps: u64) -> u64 {
        steps.next_multiple_of(self.problem.stages as u64)
    }

    fn clock(&self) -> Clock {
        Clock { steps: self.steps, step: self.time_a_step() }
    }

    /// Euler steps that take as long as one step.
    pub fn euler_steps_a_step(&self) -> f64 {
        euler_steps_a_stage(self.problem.stages)
    }

    /// Time that a step takes.
    pub fn time_a_step(&self) -> f64 {
        self.euler_step * self.euler_steps_a_step()
    }

    /// Stages taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }
}
