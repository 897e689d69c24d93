//! The concentrations of a growth with their reaction: generic over the number of chemicals, behind one dynamic call for
//! each sweep.

use std::fmt::Debug;

use rayon::prelude::*;

use super::explicit;
use super::kinetics::Kinetics;
use super::plane::Plane;
use super::problem::Problem;
use super::super_step::Stage;
use super::wavefront::{self, Instructions, Scratch, Tiling};

/// Normalised time (`facts.md` 0) in the cells where the reactions are slowest.
#[derive(Clone, Copy, Debug)]
pub struct Clock {
    /// Stages taken.
    pub steps: u64,
    /// Time of one stage.
    pub step: f64,
}

impl Clock {
    /// The time `more` stages later.
    #[must_use]
    pub fn after(&self, more: usize) -> f64 {
        (self.steps + more as u64) as f64 * self.step
    }
}

/// Concentrations that can be stepped.
pub trait Chemicals: Debug + Send + Sync {
    /// A plane for each chemical, then further planes that the reaction needs.
    fn planes(&self) -> &[Plane];

    /// The planes, mutable.
    fn planes_mut(&mut self) -> &mut [Plane];

    /// Takes `tiling.time_steps` stages, whole super steps, by the fast solver.
    fn sweep(
        &mut self,
        problem: &Problem,
        clock: Clock,
        tiling: Tiling,
        instructions: Instructions,
        scratch: &mut Scratch,
    );

    /// Takes one stage by the plain solver, with the bits of the fast one.
    fn step(&mut self, problem: &Problem, clock: Clock);

    /// A copy.
    fn copied(&self) -> Box<dyn Chemicals>;
}

impl Clone for Box<dyn Chemicals> {
    fn clone(&self) -> Self {
        self.copied()
    }
}

/// These concentrations, one plane a chemical, with their reaction; `None` for another number of planes.
#[must_use]
pub fn reacting<const N: usize, K: Kinetics<N>>(
    kinetics: K,
    planes: Vec<Plane>,
) -> Option<Box<dyn Chemicals>> {
    let planes: [Plane; N] = planes.try_into().ok()?;
    let next: Vec<Plane> = planes.par_iter().map(|plane| Plane::flat(plane.grid(), 0.0)).collect();
    let next = next.try_into().ok()?;
    Some(Box::new(Reacting { kinetics, planes: [planes, next] }))
}

/// `N` chemicals that react by `K`.
#[derive(Clone, Debug)]
struct Reacting<const N: usize, K> {
    kinetics: K,
    /// The current planes, and those for the next step.
    planes: [[Plane; N]; 2],
}

impl<const N: usize, K: Kinetics<N>> Chemicals for Reacting<N, K> {
    fn planes(&self) -> &[Plane] {
        &self.planes[0]
    }

    fn planes_mut(&mut self) -> &mut [Plane] {
        &mut self.planes[0]
    }

    fn sweep(
        &mut self,
        problem: &Problem,
        clock: Clock,
        tiling: Tiling,
        instructions: Instructions,
        scratch: &mut Scratch,
    ) {
        let kinetics: Vec<K> =
            (0..tiling.time_steps).map(|time_step| self.kinetics.at(clock.after(time_step))).collect();
        let [old, new] = &mut self.planes;
        wavefront::sweep::<N, K>(problem, &kinetics, old, new, tiling.bands, instructions, scratch);
        self.planes.swap(0, 1);
    }

    fn step(&mut self, problem: &Problem, clock: Clock) {
        let kinetics = self.kinetics.at(clock.after(0));
        let [old, new] = &mut self.planes;
        let stage = Stage::after(clock.steps as usize, problem.stages);
        explicit::step::<N, K>(problem, &kinetics, stage, old, new);
        self.planes.swap(0, 1);
    }

    fn copied(&self) -> Box<dyn Chemicals> {
        Box::new(self.clone())
    }
}
