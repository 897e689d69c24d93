use super::*;
use crate::synth::passes::{DrawnSpots, OwnThresholds, SpotArea, Thresholds};

/// A layer without a canvas: three drawn spots and two others on a line, some of which do not grow at first.
#[derive(Default)]
struct OnALine {
    growths: usize,
    compared: usize,
    kept: usize,
    restarts: Vec<Restart>,
    /// For each growth, the lost drawn spots and the merged spots.
    found: Vec<(Vec<usize>, MergedSpots)>,
    drawn: DrawnSpots,
    merged: MergedSpots,
    factor: [f64; 1],
    error: [Option<f64>; 1],
}

impl OnALine {
    fn that_finds(found: Vec<(Vec<usize>, MergedSpots)>) -> Self {
        Self { found, factor: [1.0], error: [Some(0.1)], ..Self::default() }
    }

    fn now(&self) -> (Vec<usize>, MergedSpots) {
        self.found.get(self.growths - 1).cloned().unwrap_or_default()
    }
}

impl Thresholds for OnALine {
    fn thresholds(&self) -> &[f64] {
        &self.factor
    }

    fn range(&self) -> [f64; 2] {
        [0.5, 2.0]
    }

    fn slopes(&self) -> Vec<f64> {
        vec![-1.0]
    }

    fn size_errors(&self) -> &[Option<f64>] {
        &self.error
    }

    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
        let step = wanted[0].unwrap_or(0.0);
        self.factor[0] *= libm::exp(step);
        self.error = [self.error[0].map(|error| (1.0 + error) * libm::exp(-step) - 1.0)];
        vec![step]
    }
}

impl OwnThresholds for OnALine {
    fn drawn_count(&self) -> usize {
        3
    }

    fn drawn_areas(&self) -> Vec<Option<SpotArea>> {
        vec![None; 3]
    }

    fn other_areas(&self) -> Vec<Option<f64>> {
        vec![None]
    }

    fn own_slope(&self) -> f64 {
        -1.0
    }

    fn set_own(&mut self, _: &[f64], _: &[f64]) {}
}

impl Correctable for OnALine {
    fn grow(&mut self, _: u64) -> Result<Grown, LayerError> {
        self.growths += 1;
        Ok(Grown { updates: 100, settled: true })
    }

    fn measured(&self) -> u64 {
        10
    }

    fn compare(&mut self) {
        self.compared += 1;
        self.merged = self.now().1;
    }

    fn merged(&self) -> &MergedSpots {
        &self.merged
    }

    fn keep(&mut self) {
        self.kept += 1;
        let lost = self.now().0;
        let error = lost.len() as f64;
        self.drawn = DrawnSpots { count: 3, crowded: lost.clone(), lost, error, ..DrawnSpots::default() };
    }

    fn drawn(&self) -> &DrawnSpots {
        &self.drawn
    }

    fn half_grown(&self) -> usize {
        0
    }

    fn beside(&self, spot: usize) -> [Option<usize>; 2] {
        [Some((spot + 1) % 3), Some(3)]
    }

    fn restart(&mut self, restart: &Restart) {
        self.restarts.push(restart.clone());
    }

    fn restart_half_grown(&mut self) -> usize {
        0
    }

    fn check(&self) -> Result<(), LayerError> {
        if self.kept > 0 { Ok(()) } else { Err(LayerError::NoPattern) }
    }
}

fn run(layer: &mut OnALine, corrects: bool, without: PassSet) -> Vec<Pass> {
    let mut passes = Passes::new(corrects, without);
    while !passes.advance(layer, u64::MAX).expect("it grows").done {}
    // The work that was done does not depend on the budget.
    assert!(
        passes.trace().entries().iter().all(|entry| (1..1_000).contains(&entry.updates)),
        "{:?}",
        passes.trace()
    );
    passes.trace().entries().iter().map(|entry| entry.pass).collect()
}

#[test]
fn lost_spots_get_room_first_and_then_begin_again_and_each_restart_grows_on_and_is_measured() {
    let nothing = MergedSpots::default;
    let mut layer = OnALine::that_finds(vec![(vec![0, 1], nothing()), (vec![1], nothing())]);
    let passes = run(&mut layer, true, PassSet::NONE);
    assert_eq!(passes, [Pass::Growth, Pass::Thresholds, Pass::Room, Pass::Corrections]);
    assert_eq!((layer.growths, layer.kept, layer.compared), (3, 3, 3));
    let [room, again] = &layer.restarts[..] else { panic!("{:?}", layer.restarts) };
    assert_eq!((&room.away[..], &room.again[..], &room.undo[..]), (&[3][..], &[0, 1, 2][..], &[0, 1, 2][..]));
    assert_eq!((&again.away[..], &again.again[..], again.correct), (&[][..], &[1][..], true));
}

#[test]
fn spots_that_have_grown_together_are_separated_before_drawn_ones_are_corrected() {
    let merged = MergedSpots { surplus: vec![4], kept: vec![2], crowded: vec![] };
    let mut layer = OnALine::that_finds(vec![(vec![0], merged)]);
    let passes = run(&mut layer, true, PassSet::NONE);
    assert_eq!(passes, [Pass::Growth, Pass::Thresholds, Pass::Separation]);
    assert_eq!(layer.restarts, [Restart { away: vec![4], again: vec![2], ..Restart::default() }]);
}

#[test]
fn a_pass_that_is_left_out_changes_nothing_and_without_corrections_it_only_grows() {
    let found = || OnALine::that_finds(vec![(vec![0], MergedSpots::default())]);
    let without = PassSet::NONE.with(Pass::Room).with(Pass::Thresholds);
    assert_eq!(run(&mut found(), true, without), [Pass::Growth, Pass::Corrections]);
    let mut layer = found();
    assert_eq!(run(&mut layer, false, PassSet::NONE), [Pass::Growth]);
    assert_eq!((layer.growths, layer.kept, layer.factor), (1, 1, [1.0]));
}
