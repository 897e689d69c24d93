//! Pinned spots are moved back to their places while they form.
//!
//! Where they were drawn unevenly, spots push each other by a tenth to a half of their radius until they settle. So at
//! every check for convergence the pinned ones are moved back: little at a time, and never at the end.

use crate::attributes::regions::RegionGrid;
use crate::grid::Field;
use crate::measure::{Spot, spots};
use crate::rd::{LocalWarp, Maps};
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::pinned_marks::{PinnedMark, displacement, visible_center};

/// Marks nearer to their places than this (÷ radius) are not moved.
const NEAR: f64 = 0.03;
/// A spot farther from the place than this (÷ radius) is another one.
const OWN: f64 = 1.2;
/// Spots are moved no farther at once than this, ÷ radius.
const STEP: f64 = 0.4;

/// Where the pinned spots of a plan shall be.
#[derive(Clone, Debug)]
pub struct PositionControl {
    layout: RegionGrid,
    marks: Vec<Target>,
}

#[derive(Clone, Copy, Debug)]
struct Target {
    /// The centre of the visible part of the spot, px.
    place: [f64; 2],
    radius: f64,
}

impl PositionControl {
    /// `None` where no spot is pinned.
    #[must_use]
    pub fn new(plan: &Plan) -> Option<Self> {
        let layout = *plan.lookup.map.layout();
        let target = |pinned: &PinnedMark| {
            let place = visible_center(&pinned.drawn, &layout);
            Target { place, radius: pinned.radius() }
        };
        let marks: Vec<Target> = plan.pinned_spots().iter().map(target).collect();
        (!marks.is_empty()).then_some(Self { layout, marks })
    }

    /// Warps that move the spots in `field`, grown in `maps`, towards their places.
    #[must_use]
    pub fn warps(&self, field: &Field, maps: &Maps) -> Vec<LocalWarp> {
        let found = spots(field, 0.5);
        self.marks.iter().filter_map(|mark| mark.warp(&found, &self.layout, maps)).collect()
    }
}

impl Target {
    fn warp(&self, found: &[Spot], layout: &RegionGrid, maps: &Maps) -> Option<LocalWarp> {
        let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt() / self.radius;
        let moves = found.iter().map(|spot| {
            let center = spot.ellipse.center;
            (center, displacement(self.place, center, layout))
        });
        let (at, way) = moves.min_by(|(_, a), (_, b)| length(*a).total_cmp(&length(*b)))?;
        let missed = length(way);
        if !(NEAR..OWN).contains(&missed) {
            return None;
        }
        let cells = [0, 1].map(|axis| layout.size[axis] / maps.domain.size[axis] as f64);
        let at = [0, 1].map(|axis| at[axis] / cells[axis]);
        let by = [0, 1].map(|axis| (STEP / missed).min(1.0) * way[axis] / cells[axis]);
        Some(LocalWarp { at, own: maps.at(at), by })
    }
}
