//! Decides which further restarts are worth their time.

use super::found::{DrawnSpots, MergedSpots};

/// Numbers of restarts by each pass.
#[derive(Clone, Debug)]
pub struct Rounds {
    /// All corrections.
    rounds: usize,
    /// Corrections of spots that grew.
    corrections: usize,
    /// The error before the last correction.
    error: f64,
    /// Number of restarts of each spot.
    begun: Vec<usize>,
    /// Number of separations of merged spots.
    separations: usize,
    /// Whether room has been made for lost spots.
    room: bool,
    /// Number of times half-grown marks were restarted.
    mended: usize,
    /// Number of half-grown marks at the last call.
    half: usize,
}

/// Most corrections: if some spots vanish when others reappear, corrections would go on for long.
const ROUNDS: usize = 4;
/// Most corrections of spots that grew.
const CORRECTIONS: usize = 2;
/// A second correction is made if the first one left less than this share of the error.
const IMPROVED: f64 = 0.8;
/// Most separations of merged spots.
const SEPARATIONS: usize = 2;
/// Most restarts of half-grown marks.
const MENDED: usize = 2;
/// Most restarts of a spot.
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
            room: false,
            mended: 0,
            half: usize::MAX,
        }
    }
}

impl Rounds {
    /// Whether to separate the `merged` spots; if so, the separation is counted.
    pub fn separate(&mut self, merged: &MergedSpots) -> bool {
        let separates = !merged.surplus.is_empty() && self.separations < SEPARATIONS;
        self.separations += usize::from(separates);
        separates
    }

    /// Whether to restart the `half` half-grown marks; if so, it is counted. A second time only if the first one has left fewer.
    pub fn mend(&mut self, half: usize) -> bool {
        let mends = half > 0 && half < self.half && self.mended < MENDED;
        self.mended += usize::from(mends);
        self.half = half;
        mends
    }

    /// Whether to make room for the lost drawn spots before they are restarted. This is done once, since beside the neighbours of
    /// before many of them vanish again, or stay small. Afterwards they and the spots beside them are corrected as at first.
    pub fn make_room(&mut self, found: &DrawnSpots) -> bool {
        let makes_room = !found.lost.is_empty() && !self.room;
        self.room |= makes_room;
        if makes_room {
            self.error = f64::INFINITY;
            self.rounds = self.rounds.min(ROUNDS - CORRECTIONS);
            self.corrections = 0;
        }
        makes_room
    }

    /// Whether to leave out the drawn spots that are too near to each other; they are then no longer counted.
    pub fn leave_out(&mut self, merged: &MergedSpots) -> bool {
        let mut index = 0;
        self.begun.retain(|_| {
            index += 1;
            !merged.crowded.contains(&(index - 1))
        });
        // The errors of their neighbours may change.
        self.error = f64::INFINITY;
        !merged.crowded.is_empty()
    }

    /// Whether to make the correction `found`; if so, it is counted.
    pub fn is_worth(&mut self, found: &DrawnSpots) -> bool {
        self.begun.resize(found.count, 0);
        // If a correction made the pattern worse, another one will not improve it.
        let begins =
            found.error <= self.error && found.lost.iter().any(|index| self.begun[*index] < BEGINNINGS);
        let improves = found.error < IMPROVED * self.error && self.corrections < CORRECTIONS;
        let is_first = self.rounds == 0 && !self.room;
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

#[cfg(test)]
mod tests {
    use super::*;

    fn found(different: &[usize], lost: &[usize], error: f64) -> DrawnSpots {
        let (different, lost) = (different.to_vec(), lost.to_vec());
        DrawnSpots { count: 4, again: !different.is_empty(), different, crowded: lost.clone(), lost, error }
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
        let little = |error| DrawnSpots { again: false, ..found(&[1], &[], error) };
        let mut rounds = Rounds::default();
        assert!(rounds.is_worth(&little(1.0)) && !rounds.is_worth(&little(0.4)));
        assert!(rounds.is_worth(&found(&[1], &[], 0.4)));
        let mut roomy = Rounds::default();
        assert!(roomy.make_room(&found(&[1], &[0], 2.0)) && !roomy.is_worth(&little(0.4)));
    }

    #[test]
    fn room_is_made_once_before_lost_spots_begin_again_beside_the_same_neighbours() {
        let mut rounds = Rounds::default();
        assert!(!rounds.make_room(&found(&[0], &[], 0.4)));
        assert!(rounds.make_room(&found(&[0], &[1], 1.4)));
        assert!(!rounds.make_room(&found(&[0], &[1], 1.4)) && rounds.is_worth(&found(&[0], &[1], 1.4)));
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
    fn after_drawn_spots_are_left_out_the_others_are_corrected_again() {
        let mut rounds = Rounds::default();
        assert!(rounds.is_worth(&found(&[0], &[1, 2], 2.1)) && !rounds.is_worth(&found(&[0], &[], 2.2)));
        let merged = MergedSpots { surplus: vec![], kept: vec![1, 2], crowded: vec![2] };
        assert!(rounds.leave_out(&merged) && rounds.is_worth(&found(&[0], &[], 2.2)));
        assert_eq!(rounds.begun[..3], [0, 1, 0]);
        assert!(!rounds.leave_out(&MergedSpots { surplus: vec![3], kept: vec![0, 1], crowded: vec![] }));
    }

    #[test]
    fn room_is_followed_by_two_corrections_though_others_were_made_before() {
        let mut rounds = Rounds::default();
        assert!((0..4).all(|k| rounds.is_worth(&found(&[], &[k], 1.0))));
        assert!(!rounds.is_worth(&found(&[], &[0], 1.0)) && rounds.make_room(&found(&[], &[0], 1.0)));
        assert!(rounds.is_worth(&found(&[2], &[], 0.4)) && rounds.is_worth(&found(&[2], &[], 0.2)));
        assert!(!rounds.is_worth(&found(&[2], &[], 0.1)));
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
