//! Distances of pinned spots from their places.

use crate::attributes::regions::RegionGrid;
use crate::measure::Spot;
use crate::synth::marks::plan::pinned_marks::{PinnedMark, displacement};

/// The distance from each pinned mark to the nearest of the grown `spots`, in radii.
#[must_use]
pub fn distances(pinned: &[PinnedMark], layout: &RegionGrid, spots: &[Spot]) -> Vec<f64> {
    let distance = |a: [f64; 2], b: [f64; 2]| {
        let [x, y] = displacement(a, b, layout);
        (x * x + y * y).sqrt()
    };
    let nearest = |pinned: &PinnedMark| {
        let at = pinned.visible.center;
        let distances = spots.iter().map(|spot| distance(spot.ellipse.center, at));
        distances.fold(f64::INFINITY, f64::min) / pinned.radius()
    };
    pinned.iter().map(nearest).collect()
}
