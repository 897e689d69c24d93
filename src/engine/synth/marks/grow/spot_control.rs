//! Pinned spots are moved back to their places while they form.
//!
//! Unevenly drawn spots push each other by a tenth of their radius to many radii until they settle. So the pinned ones are followed
//! and moved back at short intervals, a little at a time.

use crate::attributes::regions::RegionGrid;
use crate::grid::{Field, Grid, PointBuckets};
use crate::measure::rough_spots_of_at_least;
use crate::rd::{LocalWarp, ParameterField};
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::pinned_marks::{PinnedMark, displacement};

/// Marks closer to their places than this, in radii, are not moved.
const NEAR: f64 = 0.02;
/// A spot farther than this, in radii, from where a mark was last seen is another spot.
const OWN: f64 = 1.0;
/// The farthest that spots are moved at once, in radii.
const STEP: f64 = 0.3;
/// If no spot was farther than this from its place, in radii, spots are followed half as often. Not tuned.
const CALM: f64 = 0.05;

/// The intended and the current places of the pinned spots of a plan.
#[derive(Clone, Debug)]
pub struct SpotControl {
    layout: RegionGrid,
    marks: Vec<Target>,
    /// Smaller spots than this are specks, px².
    least_area: f64,
    /// Distance of the farthest spot from its place when spots were followed last, in radii.
    farthest: f64,
}

#[derive(Clone, Copy, Debug)]
struct Target {
    /// The centre of the visible part of the spot, px.
    place: [f64; 2],
    /// Place where the spot was last found, px.
    seen: [f64; 2],
    radius: f64,
}

impl SpotControl {
    /// `None` where no spot is pinned.
    #[must_use]
    pub fn new(plan: &Plan, corrections: &Corrections) -> Option<Self> {
        let layout = *plan.lookup.map.layout();
        let target = |pinned: &PinnedMark| {
            let place = pinned.visible.center;
            Target { place, seen: place, radius: pinned.radius() }
        };
        let marks: Vec<Target> = corrections.pinned_spots().iter().map(target).collect();
        let least_area = corrections.least_area();
        (!marks.is_empty()).then_some(Self { layout, marks, least_area, farthest: f64::INFINITY })
    }

    /// Whether the spots hardly move.
    #[must_use]
    pub fn is_calm(&self) -> bool {
        self.farthest < CALM
    }

    /// Warps that move the spots in `field`, grown in `maps`, towards their places, and keep the others; none where no spot
    /// has to move.
    #[must_use]
    pub fn warps(&mut self, field: &Field, maps: &ParameterField) -> Vec<LocalWarp> {
        let spots = rough_spots_of_at_least(field, 0.5, self.least_area);
        let centers: Vec<[f64; 2]> = spots.iter().map(|spot| spot.ellipse.center).collect();
        let cells = [0, 1].map(|axis| self.layout.size[axis] / maps.domain.size[axis] as f64);
        let mut by = vec![[0.0; 2]; centers.len()];
        let followed = self.follow(&centers);
        // A spot that is not seen may be anywhere.
        self.farthest = if followed.len() < self.marks.len() { f64::INFINITY } else { 0.0 };
        for (mark, spot) in followed {
            self.farthest = self.farthest.max(self.marks[mark].missed(&self.layout));
            by[spot] = self.marks[mark].step(&self.layout);
        }
        if by.iter().all(|by| *by == [0.0; 2]) {
            return Vec::new();
        }
        let warp = |(at, by): (&[f64; 2], &[f64; 2])| {
            let [at, by] = [at, by].map(|px| [px[0] / cells[0], px[1] / cells[1]]);
            LocalWarp { at, own: maps.at(at), by }
        };
        centers.iter().zip(&by).map(warp).collect()
    }

    /// Assumes that the `lost` marks are at their places again. Returns where they were last seen, cells of `grid`.
    pub fn forget(&mut self, lost: &[usize], grid: &Grid) -> Vec<[f64; 2]> {
        let mut forgotten = Vec::new();
        self.farthest = f64::INFINITY;
        for index in lost {
            // Spots after the pinned ones are not followed.
            if let Some(mark) = self.marks.get_mut(*index) {
                forgotten.push(grid.to_cells(std::mem::replace(&mut mark.seen, mark.place)));
            }
        }
        forgotten
    }

    /// Finds each mark among spots at these places, px: the spot nearest to where the mark was last seen, unless that is nearer to
    /// another mark. Returns pairs of mark and spot.
    fn follow(&mut self, centers: &[[f64; 2]]) -> Vec<(usize, usize)> {
        let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
        let places = PointBuckets::new(self.layout.bounds(), centers.to_vec());
        let mut owner: Vec<Option<(usize, f64)>> = vec![None; centers.len()];
        for (index, mark) in self.marks.iter().enumerate() {
            let away =
                |center: &[f64; 2]| length(displacement(*center, mark.seen, &self.layout)) / mark.radius;
            let near = places.within(mark.seen, OWN * mark.radius).into_iter().map(|spot| spot as usize);
            let near = near.map(|spot| (spot, away(&centers[spot]))).min_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((spot, away)) = near.filter(|(_, away)| *away < OWN)
                && owner[spot].is_none_or(|(_, other)| away < other)
            {
                owner[spot] = Some((index, away));
            }
        }
        let pairs: Vec<(usize, usize)> =
            owner.iter().enumerate().filter_map(|(spot, owner)| Some((owner.as_ref()?.0, spot))).collect();
        for (mark, spot) in &pairs {
            self.marks[*mark].seen = centers[*spot];
        }
        pairs
    }
}

impl Target {
    /// Distance of the spot from its place, in radii.
    fn missed(&self, layout: &RegionGrid) -> f64 {
        let displacement = displacement(self.place, self.seen, layout);
        (displacement[0] * displacement[0] + displacement[1] * displacement[1]).sqrt() / self.radius
    }

    /// The displacement by which it is moved now, px, and which is added to where it was seen.
    fn step(&mut self, layout: &RegionGrid) -> [f64; 2] {
        let displacement = displacement(self.place, self.seen, layout);
        let missed = self.missed(layout);
        if missed < NEAR {
            return [0.0; 2];
        }
        let step = displacement.map(|displacement| (STEP / missed).min(1.0) * displacement);
        self.seen = [0, 1].map(|axis| self.seen[axis] + step[axis]);
        step
    }
}
