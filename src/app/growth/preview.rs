//! The very first picture: where marks would begin, before anything is measured or corrected.
//!
//! Laying out a growth takes as long as some hundred frames; a hand that has just lifted the pen shall not wait for it.

use super::Picture;
use crate::synth::painting::Look;
use crate::synth::plan::plan;
use crate::synth::recipe::Document;
use crate::synth::{Engine, Training, drawn};

/// Cell updates before the picture is taken: ground and marks have parted.
const UPDATES: u64 = 100_000;

/// The picture; `None` where there are layers beneath, or where it cannot be grown (growing it will say why).
pub(super) fn preview(document: &Document, training: &Training) -> Option<Picture> {
    if document.layers.len() > 1 {
        return None;
    }
    let map = drawn::region_map(document, 0, "").ok()?;
    let plan = plan(training, document.layers[0].choice(), &map).ok()?;
    crate::synth::memory::check(plan.system, document.size.map(f64::from), plan.grid).ok()?;
    let layout = plan.map.layout();
    // As far apart as the system itself would have them: finding out better takes several times as long.
    let maps = plan.maps(&vec![1.0; layout.len()]);
    let mut engine = Engine::of(plan.system, maps, layout.edges, document.layer_seed(0));
    engine.advance(UPDATES);
    Some(Picture::growing(document, &Look { beneath: &[], plan: &plan, engine: &engine }))
}
