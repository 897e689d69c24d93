//! Kept marks are brought back while they form.
//!
//! Spots push each other, where they were drawn unevenly, by a tenth to a half of their radius until they come to rest.
//! So whenever the growth is looked at, those that are to stay where they were drawn are moved back: little at a time,
//! and never at the end.

use crate::attributes::regions::RegionGrid;
use crate::grid::Field;
use crate::measure::{Spot, spots};
use crate::rd::{LocalWarp, Maps};
use crate::synth::plan::Plan;
use crate::synth::plan::pinned_marks::{Kept, apart, seen};

/// Marks nearer to where they are to be than this (÷ radius) are left alone.
const NEAR: f64 = 0.03;
/// A spot farther than this (÷ radius) is another's.
const OWN: f64 = 1.2;
/// Spots are moved no farther at once than this, ÷ radius.
const STEP: f64 = 0.4;

/// Where the kept marks of a plan are to be.
#[derive(Clone, Debug)]
pub struct Aim {
    layout: RegionGrid,
    marks: Vec<Aimed>,
}

#[derive(Clone, Copy, Debug)]
struct Aimed {
    /// What is seen of it is to have its centre here, px.
    target: [f64; 2],
    radius: f64,
}

impl Aim {
    /// `None` where nothing is kept.
    #[must_use]
    pub fn of(plan: &Plan) -> Option<Self> {
        let layout = *plan.map.layout();
        let aimed = |kept: &Kept| Aimed { target: seen(&kept.drawn, &layout), radius: kept.radius() };
        let marks: Vec<Aimed> = plan.kept.iter().map(aimed).collect();
        (!marks.is_empty()).then_some(Self { layout, marks })
    }

    /// How the spots in `field`, grown in `maps`, are to be moved.
    #[must_use]
    pub fn slides(&self, field: &Field, maps: &Maps) -> Vec<LocalWarp> {
        let found = spots(field, 0.5);
        self.marks.iter().filter_map(|mark| mark.slide(&found, &self.layout, maps)).collect()
    }
}

impl Aimed {
    fn slide(&self, found: &[Spot], layout: &RegionGrid, maps: &Maps) -> Option<LocalWarp> {
        let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt() / self.radius;
        let ways =
            found.iter().map(|spot| (spot.ellipse.center, apart(self.target, spot.ellipse.center, layout)));
        let (at, way) = ways.min_by(|(_, a), (_, b)| length(*a).total_cmp(&length(*b)))?;
        let missed = length(way);
        if !(NEAR..OWN).contains(&missed) {
            return None;
        }
        let cells = [0, 1].map(|axis| layout.size[axis] / maps.grid.size[axis] as f64);
        let at = [0, 1].map(|axis| at[axis] / cells[axis]);
        let by = [0, 1].map(|axis| (STEP / missed).min(1.0) * way[axis] / cells[axis]);
        Some(LocalWarp { at, own: maps.at(at), by })
    }
}
