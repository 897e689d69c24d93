//! Deviation of pinned marks from their places.

use serde::Serialize;

use crate::attributes::AttributeMap;
use crate::synth::report::covered::COVERED;
use crate::synth::report::drawn::DrawnMark;

/// Largest distance of a pinned spot from its place, as a share of its radius √(r₁r₂).
const OFF: f64 = 0.25;

/// Number of marks of a region that grew where they were drawn, and their deviations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Stayed {
    /// Drawn marks of the region.
    pub drawn: usize,
    /// Drawn marks that grew.
    pub kept: usize,
    /// Number of kept marks with a deviation: spots by more than a quarter of their radius √(r₁r₂), lines with less than nine
    /// tenths in a stripe.
    pub off: usize,
    /// The largest deviation: of a kept spot, in radii; of a line, the share that lies in no stripe.
    pub farthest: f64,
}

impl Stayed {
    fn count(&mut self, far: f64, allowed: f64) {
        self.kept += 1;
        self.off += usize::from(far > allowed);
        self.farthest = self.farthest.max(far);
    }
}

/// Deviation of the drawn marks of a layer from their places, by region. Empty if no marks were to be kept.
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
