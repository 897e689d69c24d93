//! What has grown on a model.

use crate::document::{Colours, Document};
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::threshold::Levelled;

/// A pattern that has grown on a model.
pub struct GrownBody {
    /// The document that was grown.
    pub document: Document,
    /// The model, px.
    pub placed: Placed,
    /// What it grew from.
    pub plan: BodyPlan,
    /// The pattern and what is measured in it.
    pub levelled: Levelled,
    /// How many spots were laid.
    pub laid: usize,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
}

impl GrownBody {
    /// The colours of its layer.
    #[must_use]
    pub fn colours(&self) -> Colours {
        self.document.layers[0].colours.clone().unwrap_or_else(|| Colours::default_for_layer(0))
    }

    /// How many spots have grown.
    #[must_use]
    pub fn spots(&self) -> usize {
        self.levelled.measured.spots.len()
    }
}
