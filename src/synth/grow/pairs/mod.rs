//! What systems of pairs have grown.

mod pattern;

pub use pattern::PairPattern;

use crate::grid::Field;
use crate::measure::StripeErrors;
use crate::synth::plan::pairs::PairPlan;

/// What pairs have grown.
#[derive(Clone)]
pub struct GrownPairs {
    /// How it was planned.
    pub plan: PairPlan,
    /// Steps taken.
    pub steps: u64,
    /// The difference C₊ − C₋ of each pair, on the grid.
    pub differences: Vec<Field>,
    /// The threads of each direction over the whole canvas, against what was asked at each place.
    pub measured: Vec<StripeErrors>,
    /// The concentrations of each morphogen on the grid, where the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
}

impl GrownPairs {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> PairPattern {
        PairPattern::new(&self.differences, &self.plan.levels())
    }

    /// The pattern of the threads of one direction at any size.
    #[must_use]
    pub fn pattern_of(&self, direction: usize) -> PairPattern {
        PairPattern::new(&self.differences[direction..=direction], &self.plan.levels()[direction..=direction])
    }
}
