//! What systems of pairs have grown.

mod over;
mod pattern;
mod phase;

pub use over::OverUnder;
pub use pattern::PairPattern;
pub use phase::ThreadPhase;

use crate::grid::Field;
use crate::measure::StripeErrors;
use crate::synth::pairs::plan::PairPlan;

/// What pairs have grown.
#[derive(Clone)]
pub struct GrownPairs {
    /// How it was planned.
    pub plan: PairPlan,
    /// Steps taken.
    pub steps: u64,
    /// What shows the threads, on the grid: the difference C₊ − C₋ of each pair; of the others one field for all, see [`PairPlan::shown`].
    pub differences: Vec<Field>,
    /// The threads of each direction over the whole canvas, of a maze over its pieces, against what was asked at each place.
    pub measured: Vec<StripeErrors>,
    /// The levels of the differences at which edges lie.
    pub levels: Vec<f32>,
    /// The concentrations of each morphogen on the grid, where the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
    /// Which threads lie over the others; `None` where all are as high.
    pub over: Option<OverUnder>,
}

impl GrownPairs {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> PairPattern {
        PairPattern::new(&self.differences, &self.levels).with(self.over.clone())
    }

    /// The pattern of the threads of one direction at any size; of a maze that of all.
    #[must_use]
    pub fn pattern_of(&self, direction: usize) -> PairPattern {
        if self.differences.len() < self.plan.threads.len() {
            return self.pattern();
        }
        let own = direction..=direction;
        PairPattern::new(&self.differences[own.clone()], &self.levels[own])
    }
}
