//! Grown layers of systems of pairs.

mod over;
mod pattern;
mod phase;

pub use over::OverUnder;
pub use pattern::{PairPattern, middle_of_threads};
pub use phase::ThreadPhase;

use crate::grid::Field;
use crate::measure::StripeErrors;
use crate::synth::pairs::plan::PairPlan;

/// A grown layer of pairs.
#[derive(Clone)]
pub struct GrownPairs {
    /// The plan from which it grew.
    pub plan: PairPlan,
    /// Steps taken.
    pub steps: u64,
    /// The fields that show the threads, on the grid: for a weave the difference C₊ − C₋ of each pair; for other systems one field,
    /// see [`PairPlan::shown`].
    pub differences: Vec<Field>,
    /// The measured threads of each direction over the whole canvas (for a maze over its pieces), against the wanted ones at each
    /// place.
    pub measured: Vec<StripeErrors>,
    /// The thresholds of the differences at which edges lie.
    pub levels: Vec<f32>,
    /// The concentrations of each morphogen on the grid, if the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
    /// For each crossing, the thread on top; `None` if all threads have the same height.
    pub over: Option<OverUnder>,
}

impl GrownPairs {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> PairPattern {
        PairPattern::new(&self.differences, &self.levels).with(self.over.clone())
    }

    /// The pattern of the threads of one direction at any size; for a maze that of all directions.
    #[must_use]
    pub fn pattern_of(&self, direction: usize) -> PairPattern {
        if self.differences.len() < self.plan.threads.len() {
            return self.pattern();
        }
        let own = direction..=direction;
        PairPattern::new(&self.differences[own.clone()], &self.levels[own])
    }
}
