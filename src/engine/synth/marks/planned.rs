//! The plan of a layer of spots or stripes, as the layers above see it.

use std::any::Any;

use crate::document::{After, LayerOptions};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::plan::Lookup;

/// What was looked up for a layer, with the options that its growth needs.
#[derive(Clone)]
pub struct MarksPlan {
    /// What was looked up.
    pub lookup: Lookup,
    /// The options of the layer.
    pub options: LayerOptions,
    /// How it meets the marks beneath.
    pub after: After,
}

/// What was looked up for the layer beneath, by its plan or by what has grown; `None` of any other kind.
#[must_use]
pub fn looked_up(beneath: Option<&dyn Any>) -> Option<&Lookup> {
    let beneath = beneath?;
    let planned = beneath.downcast_ref::<MarksPlan>().map(|plan| &plan.lookup);
    planned.or_else(|| beneath.downcast_ref::<GrownMarks>().map(|grown| &grown.plan.lookup))
}
