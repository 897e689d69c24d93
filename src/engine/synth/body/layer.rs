//! A layer that has grown on a model.

use crate::synth::body::plan::BodyPlan;
use crate::synth::body::threshold::Levelled;

/// A layer that has grown on a model.
pub struct BodyLayer {
    /// What it grew from.
    pub plan: BodyPlan,
    /// The pattern and what is measured in it.
    pub levelled: Levelled,
    /// How many spots were laid; 0 of stripes.
    pub laid: usize,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
}

impl BodyLayer {
    /// How many spots have grown.
    #[must_use]
    pub fn spots(&self) -> usize {
        self.levelled.measured.spots.len()
    }
}
