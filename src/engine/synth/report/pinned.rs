//! How well pinned marks stayed where they were drawn.

use serde::Serialize;

use crate::attributes::AttributeMap;
use crate::synth::report::covered::COVERED;
use crate::synth::report::drawn::DrawnMark;

/// The share of its radius √(r₁r₂) by which a pinned spot may be off.
const OFF: f64 = 0.25;

/// How many marks of a region grew where they were drawn, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Stayed {
    /// Drawn marks of the region.
    pub drawn: usize,
    /// Drawn marks that grew.
    pub kept: usize,
    /// Of these, how many are off: spots by more than a quarter of their radius √(r₁r₂), lines of which less than nine
    /// tenths lie in a stripe.
    pub off: usize,
    /// The farthest that a kept spot is off, ÷ its radius; of lines the largest share that lies in no stripe.
    pub farthest: f64,
}

impl Stayed {
    fn count(&mut self, far: f64, allowed: f64) {
        self.kept += 1;
        self.off += usize::from(far > allowed);
        self.farthest = self.farthest.max(far);
    }
}

/// How well the drawn marks of a layer stayed, by region. Empty where none was to be among those that grow.
#[must_use]
pub fn stayed(map: &AttributeMap, drawn: &[DrawnMark], lines: bool) -> Vec<Stayed> {
    if drawn.is_empty() {
        return Vec::new();
    }
    let layout = map.layout();
    let mut stayed: Vec<Stayed> =
        map.regions().map(|(_, region)| Stayed { drawn: region.marks, ..Stayed::default() }).collect();
    let allowed = if lines { 1.0 - COVERED } else { OFF };
    for mark in drawn {
        if let Some(off) = mark.off {
            stayed[layout.index(layout.region_of(mark.place))].count(off, allowed);
        }
    }
    stayed
}
