//! Drawn spots grow as large, long and turned as they were drawn: what each differs by is subtracted from its own
//! parameters, and the pattern goes on growing from where it is. Those that are not there begin again, with parameters that
//! suit their place better.
//!
//! A correction takes little time beside the growth: the pattern has settled, and only the spots that differ change.

use crate::attributes::regions::RegionGrid;
use crate::grid::PointBuckets;
use crate::learn::NARROWEST;
use crate::marks::Ellipse;
use crate::measure::Spot;
use crate::synth::marks::grow::merged_spots::MergedSpots;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::pinned_marks::{PinnedMark, displacement};

/// A grown spot belongs to a drawn one within this share of its radius √(r₁r₂).
pub const THERE: f64 = 0.5;
/// The share of a difference in shape that is corrected at once.
const GAIN: f64 = 0.8;
/// The same of ln area: among near neighbours, spots answer to half of a correction. What was corrected too much is within reach of
/// the levels.
const AREA_GAIN: f64 = 1.6;
/// Differences that are not corrected: of ln area, and of −ln aspect · (cos 2θ, sin 2θ).
const TOLERATED: [f64; 2] = [0.05, 0.04];
/// A pattern that was corrected before is corrected again only where some shapes differ by more than is tolerated, or some areas by
/// this many times as much.
const AGAIN: f64 = 2.0;
/// Of ellipses with a smaller aspect more is tolerated: as much of the aspect itself.
const NARROW: f64 = 0.4;
/// The largest corrections: of ln rate, of either part of the shape, of ln ratio.
const MOST: NodeOffset = [1.2, 0.6, 0.6, 0.7];

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

/// What is done about the pinned spots that grew otherwise than they were drawn.
#[derive(Clone, Debug, Default)]
pub struct PinnedCorrection {
    /// What is added to the correction of each.
    added: Vec<NodeOffset>,
    /// Those that grew, but differ by more than is tolerated.
    pub different: Vec<usize>,
    /// Whether some of these differ by so much that the pattern is corrected again.
    again: bool,
    /// Those that have vanished, moved away or split, and so begin again.
    pub lost: Vec<usize>,
    /// Those of them that have not split: their neighbours leave them too little room.
    pub crowded: Vec<usize>,
    /// The sum over the pinned spots: 1 for one that is lost, what it differs by for one that grew.
    pub error: f64,
}

impl PinnedCorrection {
    /// Compares the pinned spots of `plan` with the `grown` ones.
    #[must_use]
    pub fn new(plan: &Plan, grown: &[Spot]) -> Self {
        let layout = plan.lookup.map.layout();
        let pinned = plan.pinned_spots();
        let mut correction = Self::default();
        for (index, (mark, spot)) in pinned.iter().zip(matched(pinned, layout, grown)).enumerate() {
            let Some(spot) = spot.filter(|spot| !is_two_side_by_side(mark, spot)) else {
                correction.lost.push(index);
                correction.error += 1.0;
                let split = spot.is_some() || is_split(mark, layout, grown);
                correction.added.push(if split { SPLIT } else { CROWDED });
                if !split {
                    correction.crowded.push(index);
                }
                continue;
            };
            let by = difference(mark, spot);
            let [area, shape] = [by[0].abs(), (by[1] * by[1] + by[2] * by[2]).sqrt()];
            correction.error += (area + shape).min(1.0);
            let narrow = (NARROW / mark.drawn.aspect()).max(1.0);
            let other_shape = shape > narrow * TOLERATED[1];
            if area <= TOLERATED[0] && !other_shape {
                correction.added.push(NodeOffset::default());
                continue;
            }
            correction.different.push(index);
            correction.again |= other_shape || area > AGAIN * TOLERATED[0];
            correction.added.push([AREA_GAIN * by[0], GAIN * by[1], GAIN * by[2], GAIN * by[3]]);
        }
        correction
    }

    /// The pinned spots that are changed.
    pub fn changed(&self) -> impl Iterator<Item = usize> {
        self.different.iter().chain(&self.lost).copied()
    }

    /// Corrects the pinned spots of `plan`.
    pub fn apply(&self, plan: &mut Plan) {
        for (mark, added) in plan.pinned_spots_mut().iter_mut().zip(&self.added) {
            for (part, added) in added.iter().enumerate() {
                mark.correction[part] = (mark.correction[part] + added).clamp(-MOST[part], MOST[part]);
            }
        }
    }
}

/// Which further corrections are worth their time.
#[derive(Clone, Debug)]
pub struct Rounds {
    /// All corrections.
    rounds: usize,
    /// Corrections of spots that grew.
    corrections: usize,
    /// The error before the last one.
    error: f64,
    /// How often each spot began again.
    begun: Vec<usize>,
    /// How often spots that had grown together were separated.
    separations: usize,
    /// How often room was made for lost ones.
    rooms: usize,
    /// How often marks that had grown by half were mended.
    mended: usize,
    /// How many had grown by half when that was last asked.
    half: usize,
}

/// Corrections at most: where some spots vanish when others come back it would go on for long.
const ROUNDS: usize = 4;
/// Corrections of spots that grew, at most.
const CORRECTIONS: usize = 2;
/// A second correction is made where the first left less than this share of the error.
const IMPROVED: f64 = 0.8;
/// Spots that have grown together are separated so often at most.
const SEPARATIONS: usize = 2;
/// Room is made for lost spots so often at most.
const ROOMS: usize = 2;
/// Marks that have grown by half are mended so often at most.
const MENDED: usize = 2;
/// A spot begins again so often at most.
const BEGINNINGS: usize = 2;

impl Default for Rounds {
    fn default() -> Self {
        let error = f64::INFINITY;
        Self {
            rounds: 0,
            corrections: 0,
            error,
            begun: Vec::new(),
            separations: 0,
            rooms: 0,
            mended: 0,
            half: usize::MAX,
        }
    }
}

impl Rounds {
    /// Whether to separate the `merged` spots, which is then counted.
    pub fn separate(&mut self, merged: &MergedSpots) -> bool {
        let separates = !merged.surplus.is_empty() && self.separations < SEPARATIONS;
        self.separations += usize::from(separates);
        separates
    }

    /// Whether to mend the marks that have grown by half, `half` of them, which is then counted: once more where it has left fewer.
    pub fn mend(&mut self, half: usize) -> bool {
        let mends = half > 0 && half < self.half && self.mended < MENDED;
        self.mended += usize::from(mends);
        self.half = half;
        mends
    }

    /// Whether to make room for the pinned spots that are lost before they begin again, which is then counted: it is tried first,
    /// and once. Beside the same neighbours many of them vanish again, or stay small.
    pub fn make_room_first(&mut self, found: &PinnedCorrection) -> bool {
        self.rooms == 0 && self.make_room(found)
    }

    /// Whether to make room for the pinned spots that are lost, which is then counted. Afterwards they and what stands beside
    /// them are corrected as at first.
    pub fn make_room(&mut self, found: &PinnedCorrection) -> bool {
        let makes_room = !found.lost.is_empty() && self.rooms < ROOMS;
        self.rooms += usize::from(makes_room);
        if makes_room {
            self.error = f64::INFINITY;
            self.rounds = self.rounds.min(ROUNDS - CORRECTIONS);
            self.corrections = 0;
        }
        makes_room
    }

    /// Whether to leave out the pinned spots that are too near to each other, which are then forgotten.
    pub fn leave_out(&mut self, merged: &MergedSpots) -> bool {
        let mut index = 0;
        self.begun.retain(|_| {
            index += 1;
            !merged.crowded.contains(&(index - 1))
        });
        // Their neighbours may differ again.
        self.error = f64::INFINITY;
        !merged.crowded.is_empty()
    }

    /// Whether to make the correction `found`, which is then counted.
    pub fn is_worth(&mut self, found: &PinnedCorrection) -> bool {
        self.begun.resize(found.added.len(), 0);
        // What grew worse is not mended by more of the same.
        let begins =
            found.error <= self.error && found.lost.iter().any(|index| self.begun[*index] < BEGINNINGS);
        let improves = found.error < IMPROVED * self.error && self.corrections < CORRECTIONS;
        let is_first = self.rounds + self.rooms == 0;
        let corrects = improves && !found.different.is_empty() && (is_first || found.again);
        if self.rounds == ROUNDS || !begins && !corrects {
            return false;
        }
        self.rounds += 1;
        self.error = found.error;
        self.corrections += usize::from(!begins);
        found.lost.iter().for_each(|index| self.begun[*index] += 1);
        true
    }
}

/// The change for a spot that split in two, and for one that its neighbours pushed away or killed: with a larger ratio spots
/// do not split, with a smaller one they take less room. The rate keeps the area, or lets it shrink so far that the level can
/// make up for it.
const SPLIT: NodeOffset = [-0.3, 0.0, 0.0, 0.35];
/// See [`SPLIT`].
const CROWDED: NodeOffset = [0.45, 0.0, 0.0, -0.2];
/// Two spots within so many radii of a place where none is are the halves of one.
const HALVES: f64 = 1.6;

/// Whether a mark that is not there has split in two.
fn is_split(mark: &PinnedMark, layout: &RegionGrid, grown: &[Spot]) -> bool {
    let near = |spot: &&Spot| {
        let [x, y] = displacement(spot.ellipse.center, mark.visible.center, layout);
        (x * x + y * y).sqrt() < HALVES * mark.radius()
    };
    grown.iter().filter(near).count() >= 2
}

/// A spot with this many times the aspect of the drawn one is two narrow ones side by side.
const DOUBLED: f64 = 1.7;

/// Whether a grown spot is two halves of a narrow one, which touch along their length.
fn is_two_side_by_side(mark: &PinnedMark, grown: &Spot) -> bool {
    grown.whole && grown.ellipse.aspect() > DOUBLED * mark.drawn.aspect().max(NARROWEST)
}

/// The change of the parameters that takes a spot that has `grown` so to the one drawn. Of one that the border cuts only the
/// area of the visible part is known.
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
    // Asked for a smaller aspect than any spot can have, it would split in two.
    let [[c, s], [got_c, got_s]] = [shape(drawn, drawn.aspect().max(NARROWEST)), shape(got, got.aspect())];
    [larger, c - got_c, s - got_s, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(different: &[usize], lost: &[usize], error: f64) -> PinnedCorrection {
        let added = vec![NodeOffset::default(); 4];
        let (different, lost) = (different.to_vec(), lost.to_vec());
        PinnedCorrection {
            added,
            again: !different.is_empty(),
            different,
            crowded: lost.clone(),
            lost,
            error,
        }
    }

    #[test]
    fn nothing_is_corrected_where_all_spots_are_as_drawn() {
        assert!(!Rounds::default().is_worth(&found(&[], &[], 0.1)));
    }

    #[test]
    fn spots_that_differ_are_corrected_twice_and_only_while_that_helps() {
        let mut helps = Rounds::default();
        assert!(helps.is_worth(&found(&[0, 2], &[], 2.0)) && helps.is_worth(&found(&[2], &[], 1.0)));
        assert!(!helps.is_worth(&found(&[2], &[], 0.4)));
        let mut hardly = Rounds::default();
        assert!(hardly.is_worth(&found(&[0], &[], 2.0)) && !hardly.is_worth(&found(&[0], &[], 1.9)));
    }

    #[test]
    fn a_pattern_is_corrected_again_only_where_some_spots_still_differ_much() {
        let little = |error| PinnedCorrection { again: false, ..found(&[1], &[], error) };
        let mut rounds = Rounds::default();
        assert!(rounds.is_worth(&little(1.0)) && !rounds.is_worth(&little(0.4)));
        assert!(rounds.is_worth(&found(&[1], &[], 0.4)));
        let mut roomy = Rounds::default();
        assert!(roomy.make_room_first(&found(&[1], &[0], 2.0)) && !roomy.is_worth(&little(0.4)));
    }

    #[test]
    fn room_is_made_once_before_lost_spots_begin_again_beside_the_same_neighbours() {
        let mut rounds = Rounds::default();
        assert!(!rounds.make_room_first(&found(&[0], &[], 0.4)));
        assert!(rounds.make_room_first(&found(&[0], &[1], 1.4)));
        assert!(!rounds.make_room_first(&found(&[0], &[1], 1.4)) && rounds.is_worth(&found(&[0], &[1], 1.4)));
    }

    #[test]
    fn a_lost_spot_does_not_begin_again_where_the_last_correction_made_the_pattern_worse() {
        let mut worse = Rounds::default();
        assert!(worse.is_worth(&found(&[0], &[], 0.7)) && !worse.is_worth(&found(&[], &[1], 2.3)));
        let mut better = Rounds::default();
        assert!(better.is_worth(&found(&[0], &[], 2.3)) && better.is_worth(&found(&[], &[1], 1.7)));
    }

    #[test]
    fn spots_are_separated_twice_and_only_where_some_are_surplus() {
        let mut rounds = Rounds::default();
        assert!(!rounds.separate(&MergedSpots { surplus: vec![], kept: vec![0, 1], crowded: vec![] }));
        let merged = MergedSpots { surplus: vec![1], kept: vec![0], crowded: vec![] };
        assert_eq!([(); 3].map(|()| rounds.separate(&merged)), [true, true, false]);
    }

    #[test]
    fn after_pinned_spots_are_left_out_the_others_are_corrected_again() {
        let mut rounds = Rounds::default();
        assert!(rounds.is_worth(&found(&[0], &[1, 2], 2.1)) && !rounds.is_worth(&found(&[0], &[], 2.2)));
        let merged = MergedSpots { surplus: vec![], kept: vec![1, 2], crowded: vec![2] };
        assert!(rounds.leave_out(&merged) && rounds.is_worth(&found(&[0], &[], 2.2)));
        assert_eq!(rounds.begun[..3], [0, 1, 0]);
        assert!(!rounds.leave_out(&MergedSpots { surplus: vec![3], kept: vec![0, 1], crowded: vec![] }));
    }

    #[test]
    fn room_is_made_twice_and_followed_by_two_corrections_each() {
        let mut rounds = Rounds::default();
        assert!(!rounds.make_room(&found(&[0], &[], 0.4)));
        assert!((0..4).all(|k| rounds.is_worth(&found(&[], &[k], 1.0))));
        assert!(!rounds.is_worth(&found(&[], &[0], 1.0)) && rounds.make_room(&found(&[], &[0], 1.0)));
        assert!(rounds.is_worth(&found(&[2], &[], 0.4)) && rounds.is_worth(&found(&[2], &[], 0.2)));
        assert!(!rounds.is_worth(&found(&[2], &[], 0.1)));
        assert!(rounds.make_room(&found(&[], &[0], 1.0)) && !rounds.make_room(&found(&[], &[0], 1.0)));
    }

    #[test]
    fn each_lost_spot_begins_again_twice_and_all_together_four_times() {
        let mut one = Rounds::default();
        assert!((0..2).all(|_| one.is_worth(&found(&[], &[1], 1.0))));
        assert!(!one.is_worth(&found(&[], &[1], 1.0)));
        let mut others = Rounds::default();
        assert!((0..4).all(|k| others.is_worth(&found(&[], &[k], 1.0))));
        assert!(!others.is_worth(&found(&[], &[0], 1.0)));
    }
}
