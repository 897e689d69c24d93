//! The very first picture: where marks would begin, before anything is measured or corrected.
//!
//! Laying out a growth takes as long as some hundred frames; a hand that has just lifted the pen shall not wait for it.

use super::Picture;
use crate::document::{After, Document};
use crate::synth::plan::sketch_targets;
use crate::synth::render::painting::Look;
use crate::synth::{Engine, GrownLayer, Training, memory, placed_over, planned};

/// Cell updates before the picture is taken: ground and marks have parted.
const UPDATES: u64 = 100_000;

/// The picture of the layer above those `beneath` that have grown; `None` where it takes their places or goes round them,
/// which is laid out first, and where it cannot be grown (growing it will say why).
pub(super) fn preview(document: &Document, training: &Training, beneath: &[GrownLayer]) -> Option<Picture> {
    let index = beneath.len();
    let layer = document.layers.get(index)?;
    if index > 0 && layer.after != After::Between {
        return None;
    }
    let map = sketch_targets::region_map(document, index, "").ok()?;
    let under = beneath.last().map(|layer| &layer.plan);
    let mut plan = planned(document, index, "", training, &map, under).ok()?;
    memory::check(plan.system, document.size.map(f64::from), plan.grid).ok()?;
    placed_over(&mut plan, document, beneath);
    let layout = plan.map.layout();
    // As far apart as the system itself would have them: finding out better takes several times as long.
    let maps = plan.maps(&vec![1.0; layout.len()]);
    let mut engine = Engine::of(plan.system, maps, document.layer_seed(index));
    if !engine.begins() {
        return None;
    }
    engine.advance(UPDATES);
    Some(Picture::growing(document, &Look { beneath, plan: &plan, engine: &engine }))
}
