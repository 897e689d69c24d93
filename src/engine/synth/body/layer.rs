//! A layer that has grown on a model.

use crate::synth::body::plan::BodyPlan;
use crate::synth::body::threshold::{Levelled, Measured};
use crate::synth::report::PointsReport;

/// A layer that has grown on a model.
pub struct BodyLayer {
    /// What it grew from.
    pub plan: BodyPlan,
    /// The pattern and what is measured in it.
    pub levelled: Levelled,
    /// How many spots were laid; 0 of stripes.
    pub laid: usize,
    /// The report of a field of points; `None` of other marks.
    pub points: Option<PointsReport>,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
}

impl BodyLayer {
    /// This layer with another pattern, one value a vertex, that is measured in the same way.
    #[must_use]
    pub fn with_pattern(mut self, pattern: Vec<f32>) -> Self {
        self.levelled.measured = Measured::new(&self.plan, &pattern);
        self.levelled.pattern = pattern;
        self
    }

    /// How many spots have grown.
    #[must_use]
    pub fn spots(&self) -> usize {
        self.levelled.measured.spots.len()
    }
}
