//! Drawn spots grow as large, long and turned as they were drawn: what each differs by is subtracted from its own
//! parameters, and the pattern goes on growing from where it is.
//!
//! A lone correction is small beside the growth: the pattern has settled, and only the spots that differ change.

use crate::attributes::regions::RegionGrid;
use crate::marks::Ellipse;
use crate::measure::Spot;
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::lattice::NodeOffset;
use crate::synth::plan::pinned_marks::{PinnedMark, displacement, visible_center};

/// A grown spot belongs to a drawn one within this share of its radius √(r₁r₂).
pub const THERE: f64 = 0.5;
/// The share of a difference that is corrected at once.
const GAIN: f64 = 0.8;
/// Differences that are not corrected: of ln area, and of −ln aspect · (cos 2θ, sin 2θ).
const TOLERATED: [f64; 2] = [0.03, 0.025];
/// The largest corrections: of ln rate, and of either part of the shape.
const MOST: [f64; 2] = [0.8, 0.6];

/// The grown spot at the place of each pinned one: the nearest within half its radius that is nearest to no other.
#[must_use]
pub fn matched<'a>(pinned: &[PinnedMark], layout: &RegionGrid, spots: &'a [Spot]) -> Vec<Option<&'a Spot>> {
    let off = |mark: &PinnedMark, spot: &Spot| {
        let [x, y] = displacement(spot.ellipse.center, visible_center(&mark.drawn, layout), layout);
        (x * x + y * y).sqrt() / mark.radius()
    };
    let mut owner: Vec<Option<(usize, f64)>> = vec![None; spots.len()];
    let mut found = vec![None; pinned.len()];
    for (index, mark) in pinned.iter().enumerate() {
        let near = spots.iter().enumerate().map(|(spot, one)| (spot, off(mark, one)));
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
        found[index] = Some(&spots[spot]);
    }
    found
}

/// Corrects the pinned spots of `plan` by the `grown` ones. Returns whether one differs by more than is tolerated.
pub fn correct_pinned(plan: &mut Plan, grown: &[Spot]) -> bool {
    let layout = *plan.lookup.map.layout();
    let found = matched(plan.pinned_spots(), &layout, grown);
    let mut differs = false;
    for (mark, spot) in plan.pinned_spots_mut().iter_mut().zip(found) {
        // A spot that the border cuts has no shape that could be measured.
        let Some(spot) = spot.filter(|spot| spot.whole) else { continue };
        let off = difference(&mark.drawn, &spot.ellipse);
        differs |= off[0].abs() > TOLERATED[0] || off[1].hypot(off[2]) > TOLERATED[1];
        for (part, off) in off.into_iter().enumerate() {
            let most = if part == 0 { MOST[0] } else { MOST[1] };
            mark.correction[part] = (mark.correction[part] + GAIN * off).clamp(-most, most);
        }
    }
    differs
}

/// The change of the parameters that takes a spot that `got` this shape to the one `drawn`.
fn difference(drawn: &Ellipse, got: &Ellipse) -> NodeOffset {
    let shape = |ellipse: &Ellipse| {
        let (long, double) = (-libm::log(ellipse.aspect()), (2.0 * ellipse.major_angle()).to_radians());
        [long * libm::cos(double), long * libm::sin(double)]
    };
    let [[c, s], [got_c, got_s]] = [shape(drawn), shape(got)];
    [libm::log(got.area() / drawn.area()), c - got_c, s - got_s, 0.0]
}
