//! The first picture of a growth: the marks at their starting places, before anything is measured or corrected.
//!
//! Laying out a growth takes as long as a hundred frames or so; this picture is shown until then.

use super::Picture;
use crate::document::{After, Document};
use crate::machine::free_memory;
use crate::synth::grow::obstacles::obstacles;
use crate::synth::grow::passing::crosses;
use crate::synth::plan::Targets;
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::{Engine, GrownLayer, Snapshot, Training, memory};

/// Cell updates before the picture is taken: enough for marks and ground to separate.
const UPDATES: u64 = 100_000;

/// The picture of the layer above those `beneath` that have grown, and what was looked up for it; `None` where it grows inside or
/// around them, which needs the full layout first, and where it cannot be grown (the growth then reports why).
pub(super) fn preview(
    document: &Document,
    training: &Training,
    beneath: &[GrownLayer],
) -> Option<(Picture, Lookup)> {
    let index = beneath.len();
    let layer = document.layers.get(index)?;
    if index > 0 && layer.after != After::Between {
        return None;
    }
    let size = document.size.map(f64::from);
    if document.pairs(index).is_some() || layer.is_of_points() || layer.is_driven() {
        // Its growth shows its first picture as soon as this would.
        return None;
    }
    let below = beneath.last().and_then(GrownLayer::marks).map(|layer| &layer.plan.lookup);
    let lookup = Targets::read(document, index, "", size, below).ok()?.look_up(training).ok()?;
    memory::check(lookup.system, size, lookup.grid.size, Some(free_memory())).ok()?;
    let obstacles = obstacles(document, beneath, lookup.grid.size, &|layer| crosses(&lookup, layer));
    let plan = lookup.clone().rough(obstacles);
    // At the system's own distance: correcting the spacing takes several times as long.
    let maps = plan.unpitched_maps();
    let mut engine = Engine::from_maps(plan.lookup.system, maps, document.layer_seed(index));
    if !engine.can_start() {
        return None;
    }
    engine.advance(UPDATES);
    Some((Picture::growing(document, &Snapshot::of_marks(beneath, &plan, &engine)), lookup))
}
