//! Stripes that cross the stripes of a layer beneath: they pass under them, and are aligned on both sides.
//!
//! Stripes that grow into the gaps alone would be short pieces, shifted from gap to gap. So the stripes that they cross are no
//! obstacles to them, and hide them.

use crate::attributes::Attributes;
use crate::grid::Field;
use crate::marks::turn;
use crate::synth::drawn::is_replaced;
use crate::synth::kind::{Beneath, GrownBeneath};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};

/// Directions that differ by more than this on average cross each other, degrees; stripes whose directions differ by less find room
/// between each other.
const CROSSING: f64 = 35.0;
/// Points along each side at which directions are compared.
const POINTS: usize = 16;
/// Points per cell of the layer above along each side, for the hidden part.
const FINER: usize = 2;

/// Whether the stripes of `lookup` cross those of the layer `below`.
#[must_use]
pub fn crosses(lookup: &Lookup, below: &dyn GrownBeneath) -> bool {
    let free = matches!(lookup.start, Start::Free { .. });
    let Some(GrownMarks { plan: below, .. }) = below.grown().downcast_ref() else {
        return false;
    };
    let below = &below.lookup;
    if !free || !lookup.system.is_striped() || !below.system.is_striped() || below.curve_kind().is_some() {
        return false;
    }
    let layout = lookup.map.layout();
    let angle = |of: &Lookup, point| match of.map.at(point) {
        Attributes::Stripes(stripes) => stripes.angle,
        Attributes::Spots(_) => unreachable!("both systems grow stripes"),
    };
    let at = |i: usize, axis: usize| (i as f64 + 0.5) / POINTS as f64 * layout.size[axis];
    let apart = |i: usize| {
        let point = [at(i % POINTS, 0), at(i / POINTS, 1)];
        turn(angle(lookup, point), angle(below, point)).abs()
    };
    (0..POINTS * POINTS).map(apart).sum::<f64>() > CROSSING * (POINTS * POINTS) as f64
}

/// The pattern of all layers `beneath` under which the stripes of `lookup` pass; `None` if there are none.
#[must_use]
pub fn crossed_marks(beneath: &Beneath, lookup: &Lookup) -> Option<Field> {
    let shown = beneath.layers.iter().enumerate();
    let shown = shown.filter(|(below, _)| !is_replaced(beneath.document, *below));
    let crossed: Vec<&dyn GrownBeneath> =
        shown.map(|(_, layer)| *layer).filter(|layer| crosses(lookup, *layer)).collect();
    let side = |axis: usize| {
        let finest = crossed.iter().map(|layer| layer.grid()[axis]).max()?;
        Some(FINER * finest.max(lookup.grid.size[axis]))
    };
    let size = [side(0)?, side(1)?];
    let mut patterns = crossed.iter().map(|layer| layer.pattern().field(size[0], size[1]));
    let mut all = patterns.next()?;
    for pattern in patterns {
        all.values.iter_mut().zip(pattern.values).for_each(|(all, value)| *all = all.max(value));
    }
    Some(all)
}
