//! Corrections that give drawn spots the size, shape and direction with which they were drawn. The error of each spot is subtracted
//! from its own parameters, and the growth of the pattern continues. Missing spots begin again, with parameters that suit their
//! place better.
//!
//! A correction takes little time compared with the growth: the pattern has settled, and only spots with errors change.

use crate::attributes::regions::RegionGrid;
use crate::grid::PointBuckets;
use crate::learn::NARROWEST;
use crate::marks::Ellipse;
use crate::measure::Spot;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::pinned_marks::{PinnedMark, displacement};
use crate::synth::passes::DrawnSpots;

/// Largest distance of a grown spot from the drawn one that it belongs to, as a share of the radius √(r₁r₂).
pub const THERE: f64 = 0.5;
/// The share of an error in shape that is corrected at once.
const GAIN: f64 = 0.8;
/// The share of an error in ln area that is corrected at once: among near neighbours, only half of a correction takes effect. An
/// excess can be removed by the threshold.
const AREA_GAIN: f64 = 1.6;
/// The largest error of ln area that is not corrected.
const TOLERATED_AREA: f64 = 0.05;
/// The largest error of −ln aspect · (cos 2θ, sin 2θ) that is not corrected.
const TOLERATED_SHAPE: f64 = 0.04;
/// A pattern that has been corrected before is corrected again only if some errors of shape exceed the tolerance, or some errors of
/// area exceed this multiple of it.
const AGAIN: f64 = 2.0;
/// For ellipses with a smaller aspect the tolerance is larger: the error of the aspect itself is then limited.
const NARROW: f64 = 0.4;

/// The grown spot at the place of each pinned one.
#[must_use]
pub fn matched<'a>(pinned: &[PinnedMark], layout: &RegionGrid, spots: &'a [Spot]) -> Vec<Option<&'a Spot>> {
    matches(pinned, layout, spots).into_iter().map(|spot| Some(&spots[spot?])).collect()
}

/// The index of the grown spot at the place of each pinned one: the nearest within half its radius that is nearest to no
/// other.
#[must_use]
pub fn matches(pinned: &[PinnedMark], layout: &RegionGrid, spots: &[Spot]) -> Vec<Option<usize>> {
    let off = |mark: &PinnedMark, spot: &Spot| {
        let [x, y] = displacement(spot.ellipse.center, mark.visible.center, layout);
        (x * x + y * y).sqrt() / mark.radius()
    };
    let centers = spots.iter().map(|spot| spot.ellipse.center).collect();
    let places = PointBuckets::new(layout.bounds(), centers);
    let mut owner: Vec<Option<(usize, f64)>> = vec![None; spots.len()];
    let mut found = vec![None; pinned.len()];
    for (index, mark) in pinned.iter().enumerate() {
        let near = places.within(mark.visible.center, THERE * mark.radius());
        let near = near.into_iter().map(|spot| (spot as usize, off(mark, &spots[spot as usize])));
        let Some((spot, off)) = near.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|near| near.1 <= THERE) else {
            continue;
        };
        if let Some((other, nearer)) = owner[spot] {
            if nearer <= off {
                continue;
            }
            found[other] = None;
        }
        owner[spot] = Some((index, off));
        found[index] = Some(spot);
    }
    found
}

/// Errors of pinned spots, and the corrections that are added to the parameters of each.
#[must_use]
pub fn compared(pinned: &[PinnedMark], layout: &RegionGrid, grown: &[Spot]) -> (DrawnSpots, Vec<NodeOffset>) {
    let mut drawn = DrawnSpots { count: pinned.len(), ..DrawnSpots::default() };
    let mut added = Vec::with_capacity(pinned.len());
    for (index, (mark, spot)) in pinned.iter().zip(matched(pinned, layout, grown)).enumerate() {
        let Some(spot) = spot.filter(|spot| !is_two_side_by_side(mark, spot)) else {
            drawn.lost.push(index);
            drawn.error += 1.0;
            let split = spot.is_some() || is_split(mark, layout, grown);
            added.push(if split { SPLIT } else { CROWDED });
            if !split {
                drawn.crowded.push(index);
            }
            continue;
        };
        let by = difference(mark, spot);
        let [area, shape] = [by[0].abs(), (by[1] * by[1] + by[2] * by[2]).sqrt()];
        drawn.error += (area + shape).min(1.0);
        let narrow = (NARROW / mark.drawn.aspect()).max(1.0);
        let other_shape = shape > narrow * TOLERATED_SHAPE;
        if area <= TOLERATED_AREA && !other_shape {
            added.push(NodeOffset::default());
            continue;
        }
        drawn.different.push(index);
        drawn.again |= other_shape || area > AGAIN * TOLERATED_AREA;
        added.push([AREA_GAIN * by[0], GAIN * by[1], GAIN * by[2], GAIN * by[3]]);
    }
    (drawn, added)
}

/// The change for a spot that has split in two: with a larger ratio spots do not split. The rate keeps the area, or lets it shrink
/// so far that the threshold can correct it.
const SPLIT: NodeOffset = [-0.3, 0.0, 0.0, 0.35];
/// The change for a spot that its neighbours displaced or suppressed: with a smaller ratio it needs less room. See also [`SPLIT`].
const CROWDED: NodeOffset = [0.45, 0.0, 0.0, -0.2];
/// Two spots within this number of radii of a place without a spot are the halves of one.
const HALVES: f64 = 1.6;

/// Whether a missing mark has split in two.
fn is_split(mark: &PinnedMark, layout: &RegionGrid, grown: &[Spot]) -> bool {
    let near = |spot: &&Spot| {
        let [x, y] = displacement(spot.ellipse.center, mark.visible.center, layout);
        (x * x + y * y).sqrt() < HALVES * mark.radius()
    };
    grown.iter().filter(near).count() >= 2
}

/// A spot with at least this multiple of the drawn aspect consists of two narrow ones side by side.
const DOUBLED: f64 = 1.7;

/// Whether a grown spot is two halves of a narrow one, which touch along their length.
fn is_two_side_by_side(mark: &PinnedMark, grown: &Spot) -> bool {
    grown.whole && grown.ellipse.aspect() > DOUBLED * mark.drawn.aspect().max(NARROWEST)
}

/// The correction for a drawn spot that has `grown` like this. For a spot that the border cuts only the area of the visible part is
/// known.
fn difference(mark: &PinnedMark, grown: &Spot) -> NodeOffset {
    let (drawn, got) = (&mark.drawn, &grown.ellipse);
    let larger = libm::log(got.area() / mark.visible.area);
    if !grown.whole {
        return [larger, 0.0, 0.0, 0.0];
    }
    let shape = |ellipse: &Ellipse, aspect: f64| {
        let (long, double) = (-libm::log(aspect), (2.0 * ellipse.major_angle()).to_radians());
        [long * libm::cos(double), long * libm::sin(double)]
    };
    // With a smaller aspect than any spot can have, it would split in two.
    let [[c, s], [got_c, got_s]] = [shape(drawn, drawn.aspect().max(NARROWEST)), shape(got, got.aspect())];
    [larger, c - got_c, s - got_s, 0.0]
}
