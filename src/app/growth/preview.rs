//! The first picture of a growth: the marks at the places where their growth begins, before anything is measured or
//! corrected.
//!
//! Preparing a growth takes as long as about a hundred frames; until then this picture is shown.

use super::Picture;
use crate::document::Document;
use crate::machine::free_memory;
use crate::synth::growth;
use crate::synth::kind::Request;
use crate::synth::{GrownLayer, LayerPlan, Snapshot, Training};

/// The picture of the layer above the layers `beneath`, which have grown, and its plan. `None` where the growth shows
/// its first picture just as soon, and where the layer cannot be grown (the growth then reports why).
pub(super) fn preview(
    document: &Document,
    training: &Training,
    beneath: &[GrownLayer],
) -> Option<(Picture, LayerPlan)> {
    let index = beneath.len();
    document.layers.get(index)?;
    let (size, memory) = (document.size.map(f64::from), Some(free_memory()));
    let below = beneath.last().map(GrownLayer::own);
    let request = Request { document, index, source: "", size, training, memory, beneath: below };
    let plan = LayerPlan::read(&request).ok()?;
    plan.fits(&request).ok()?;
    let rough = plan.preview(&growth::beneath(document, beneath), document.layer_seed(index))?;
    Some((Picture::growing(document, &Snapshot { beneath, growing: rough.seen() }), plan))
}
