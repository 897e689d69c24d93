//! The plan of a layer of spots or stripes, in the form that the layers above use.

use std::any::Any;

use crate::document::{After, LayerOptions};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::plan::Lookup;

/// The lookup of a layer, with the options for its growth.
#[derive(Clone)]
pub struct MarksPlan {
    /// The result of the lookup.
    pub lookup: Lookup,
    /// The options of the layer.
    pub options: LayerOptions,
    /// Position of its marks relative to the marks beneath.
    pub after: After,
}

/// The lookup of the layer beneath, from its plan or its grown layer; `None` for any other kind.
#[must_use]
pub fn looked_up(beneath: Option<&dyn Any>) -> Option<&Lookup> {
    let beneath = beneath?;
    let planned = beneath.downcast_ref::<MarksPlan>().map(|plan| &plan.lookup);
    planned.or_else(|| beneath.downcast_ref::<GrownMarks>().map(|grown| &grown.plan.lookup))
}
