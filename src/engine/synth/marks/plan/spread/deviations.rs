//! Random deviations of spots from the means of their regions.

use rand::seq::SliceRandom;
use rand_pcg::Pcg64Mcg;

use crate::attributes::{Spots, Spread};
use crate::grid::Edges;
use crate::marks::Ellipse;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::one_spot::Deviation;
use crate::synth::marks::plan::spread_limits::{ASPECTS, beyond, by_itself};

/// The deviations of each spot from its region in size, direction and aspect, in standard deviations. The first spots are the
/// pinned ones, which have parameters of their own.
pub struct Scores(Vec<[f64; 3]>);

impl Scores {
    /// Scores of spots at these places, px.
    pub fn new(plan: &Plan, px: &[[f64; 2]], rng: &mut Pcg64Mcg) -> Self {
        let mut scores = vec![[0.0; 3]; px.len()];
        for group in groups(plan, px) {
            let drawn = [(); 3].map(|()| stratified(group.len(), rng));
            for (k, i) in group.iter().enumerate() {
                scores[*i] = [0, 1, 2].map(|attribute: usize| drawn[attribute][k]);
            }
        }
        Self(scores)
    }

    /// Deviations for `pinned` pinned spots, and for others, each with the index of an existing spot or `None` for a new one.
    pub fn among(&self, pinned: usize, others: &[Option<usize>], rng: &mut Pcg64Mcg) -> Self {
        let new = others.iter().filter(|index| index.is_none()).count();
        let drawn = [(); 3].map(|()| stratified(new, rng));
        let mut new = (0..new).map(|k| [0, 1, 2].map(|attribute: usize| drawn[attribute][k]));
        let score = |index: &Option<usize>| {
            index.map_or_else(|| new.next().unwrap_or_default(), |index| self.0[index])
        };
        let scores: Vec<[f64; 3]> = others.iter().map(score).collect();
        Self(vec![[0.0; 3]; pinned].into_iter().chain(scores).collect())
    }

    /// The deviations of these spots, now at `px`. In each region the means of the whole spots are those of the region map, with
    /// the spread asked for; likewise for the spots that the border cuts.
    pub fn deviations(&self, plan: &Plan, px: &[[f64; 2]]) -> Vec<Deviation> {
        let lookup = &plan.lookup;
        let mut all = vec![Deviation { area: 1.0, turn: 0.0, aspect: 0.0 }; px.len()];
        for group in groups(plan, px) {
            let asked: Vec<Spots> = group.iter().map(|i| lookup.spots_at(px[*i])).collect();
            let own = asked.iter().map(|wanted| by_itself(lookup.system, wanted));
            let spreads = group.iter().zip(own).map(|(i, own)| lookup.spread_at(px[*i]).with(&own, beyond));
            let spreads: Vec<Spread> = spreads.collect();
            let of = |attribute: usize| group.iter().map(move |i| self.0[*i][attribute]);
            let areas = areas(of(0).zip(spreads.iter().map(|spread| spread.area)));
            let aspects = aspects(of(1).zip(spreads.iter().map(|spread| spread.aspect)), &asked);
            let weights = asked.iter().zip(&aspects).map(|(wanted, aspect)| 1.0 - wanted.aspect - aspect);
            let turns = turns(of(2).zip(spreads.iter().map(|spread| spread.angle)), weights);
            for (k, i) in group.iter().enumerate() {
                all[*i] = Deviation { area: areas[k], turn: turns[k], aspect: aspects[k] };
            }
        }
        all
    }
}

/// The groups of spots that together have the means of their region: the whole ones, which will be measured, and those that the
/// border cuts. Pinned spots are in neither.
fn groups(plan: &Plan, px: &[[f64; 2]]) -> Vec<Vec<usize>> {
    let layout = plan.lookup.map.layout();
    let mut groups = vec![Vec::new(); 2 * layout.len()];
    for (i, point) in px.iter().enumerate().skip(plan.pinned_spots().len()) {
        let reach = reach(&plan.lookup.spots_at(*point));
        let inside = |axis: usize| (reach[axis]..=layout.size[axis] - reach[axis]).contains(&point[axis]);
        let whole = layout.edges == Edges::Wrap || inside(0) && inside(1);
        groups[2 * layout.index(layout.region_of(*point)) + usize::from(!whole)].push(i);
    }
    groups
}

/// Extent of a spot from its centre along x and y.
fn reach(spots: &Spots) -> [f64; 2] {
    let [a, b] = Ellipse::from_area([0.0; 2], spots.area, spots.aspect, 0.0).radii;
    let angle = spots.angle.to_radians();
    let (s, c) = (libm::sin(angle), libm::cos(angle));
    [(a * a * c * c + b * b * s * s).sqrt(), (a * a * s * s + b * b * c * c).sqrt()]
}

/// `n` numbers of mean 0 and variance 1 in random order: the boundaries of equal parts of a triangular distribution. A few spots
/// then vary as much as many, and none by more than √6 standard deviations.
pub fn stratified(n: usize, rng: &mut Pcg64Mcg) -> Vec<f64> {
    let quantile = |share: f64| {
        let end = 1.0 - (2.0 * share.min(1.0 - share)).sqrt();
        if share < 0.5 { -end } else { end }
    };
    let mut scores: Vec<f64> = (0..n).map(|k| quantile((k as f64 + 0.5) / n as f64)).collect();
    let deviation = (scores.iter().map(|score| score * score).sum::<f64>() / n as f64).sqrt();
    if deviation > 0.0 {
        scores.iter_mut().for_each(|score| *score /= deviation);
    }
    scores.shuffle(rng);
    scores
}

/// Rounds in which bounds, mean and spread are satisfied together.
const ROUNDS: usize = 12;

/// Mean under weights.
fn mean(values: &[f64], weights: &[f64]) -> f64 {
    let total: f64 = weights.iter().sum();
    if total <= 0.0 { 0.0 } else { values.iter().zip(weights).map(|(v, w)| v * w).sum::<f64>() / total }
}

/// Shifts and scales `values` to a weighted mean of 0, and to the weighted variance of the `spreads`, inside their bounds.
fn standardise(values: &mut [f64], weights: &[f64], spreads: &[f64], bounds: impl Fn(usize) -> [f64; 2]) {
    let squares = |values: &[f64]| mean(&values.iter().map(|v| v * v).collect::<Vec<_>>(), weights);
    let wanted = squares(spreads);
    for _ in 0..ROUNDS {
        let average = mean(values, weights);
        values.iter_mut().for_each(|value| *value -= average);
        let got = squares(values);
        // A single spot has no variance.
        let factor = if got > 1e-12 * wanted { (wanted / got).sqrt().clamp(0.7, 1.4) } else { 0.0 };
        for (i, value) in values.iter_mut().enumerate() {
            let [low, high] = bounds(i);
            *value = (*value * factor).clamp(low, high);
        }
    }
    let average = mean(values, weights);
    values.iter_mut().for_each(|value| *value -= average);
}

/// Areas ÷ the mean: logarithms from the scores, so that none is negative; mean 1, and the variation asked for.
pub fn areas(drawn: impl Iterator<Item = (f64, f64)>) -> Vec<f64> {
    let (scores, spreads): (Vec<f64>, Vec<f64>) = drawn.unzip();
    let n = scores.len().max(1) as f64;
    let wanted = (spreads.iter().map(|spread| spread * spread).sum::<f64>() / n).sqrt();
    let mut wider = 1.0;
    let mut areas = Vec::new();
    for _ in 0..ROUNDS {
        // A log-normal area of coefficient of variation v has a logarithm of variance ln(1 + v²).
        let area =
            |(score, spread): (&f64, &f64)| libm::exp(wider * score * libm::log1p(spread * spread).sqrt());
        areas = scores.iter().zip(&spreads).map(area).collect();
        let mean = areas.iter().sum::<f64>() / n;
        areas.iter_mut().for_each(|area| *area /= mean);
        let got = (areas.iter().map(|area| (area - 1.0) * (area - 1.0)).sum::<f64>() / n).sqrt();
        if got > 0.0 {
            wider *= (wanted / got).clamp(0.7, 1.4);
        }
    }
    areas
}

/// Aspects − the mean.
pub fn aspects(drawn: impl Iterator<Item = (f64, f64)>, wanted: &[Spots]) -> Vec<f64> {
    let (scores, spreads): (Vec<f64>, Vec<f64>) = drawn.unzip();
    let mut aspects: Vec<f64> = scores.iter().zip(&spreads).map(|(score, spread)| score * spread).collect();
    let bounds = |i: usize| {
        let mean: f64 = wanted[i].aspect;
        [(ASPECTS[0] - mean).min(0.0), (ASPECTS[1] - mean).max(0.0)]
    };
    standardise(&mut aspects, &vec![1.0; scores.len()], &spreads, bounds);
    aspects
}

/// Rotations from the mean direction, degrees; rounder spots have less weight.
pub fn turns(drawn: impl Iterator<Item = (f64, f64)>, weights: impl Iterator<Item = f64>) -> Vec<f64> {
    let (scores, spreads): (Vec<f64>, Vec<f64>) = drawn.unzip();
    let mut turns: Vec<f64> = scores.iter().zip(&spreads).map(|(score, spread)| score * spread).collect();
    let weights: Vec<f64> = weights.collect();
    standardise(&mut turns, &weights, &spreads, |_| [-180.0, 180.0]);
    turns
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;

    fn moments(values: &[f64]) -> (f64, f64) {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        (mean, (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n).sqrt())
    }

    #[test]
    fn scores_of_few_spots_are_as_wide_as_those_of_many() {
        for n in [2, 3, 7, 40, 1_000] {
            let scores = stratified(n, &mut Pcg64Mcg::seed_from_u64(3));
            let (mean, deviation) = moments(&scores);
            assert!(mean.abs() < 1e-12 && (deviation - 1.0).abs() < 1e-12, "{n}: {mean} {deviation}");
            assert!(scores.iter().all(|score| score.abs() < 6.0f64.sqrt()), "{n}");
        }
        assert_eq!(stratified(1, &mut Pcg64Mcg::seed_from_u64(3)), [0.0]);
        assert!(stratified(0, &mut Pcg64Mcg::seed_from_u64(3)).is_empty());
    }

    #[test]
    fn drawn_areas_have_the_mean_and_the_variation_asked_for() {
        for (n, spread) in [(5, 0.1), (12, 0.3), (200, 0.6)] {
            let scores = stratified(n, &mut Pcg64Mcg::seed_from_u64(1));
            let areas = areas(scores.into_iter().map(|score| (score, spread)));
            let (mean, deviation) = moments(&areas);
            assert!(
                (mean - 1.0).abs() < 1e-12 && (deviation / spread - 1.0).abs() < 1e-3,
                "{n}: {deviation}"
            );
            assert!(areas.iter().all(|area| *area > 0.0));
        }
        assert_eq!(areas([(0.0, 0.3)].into_iter()), [1.0]);
    }

    #[test]
    fn drawn_aspects_stay_in_bounds_and_keep_their_mean() {
        let wanted = Spots { area: 100.0, aspect: 0.9, angle: 0.0, spacing: None };
        let scores = stratified(30, &mut Pcg64Mcg::seed_from_u64(1));
        let aspects = aspects(scores.into_iter().map(|score| (score, 0.05)), &[wanted; 30]);
        let (mean, deviation) = moments(&aspects);
        assert!(mean.abs() < 1e-9 && (deviation - 0.05).abs() < 0.003, "{mean} {deviation}");
        assert!(aspects.iter().all(|aspect| *aspect < ASPECTS[1] - 0.9 + 0.005), "{aspects:?}");
    }

    #[test]
    fn weighted_drawn_turns_cancel() {
        let scores = stratified(20, &mut Pcg64Mcg::seed_from_u64(1));
        let weights: Vec<f64> = (1..=20).map(|k| f64::from(k) / 20.0).collect();
        let turns = turns(scores.into_iter().map(|score| (score, 12.0)), weights.iter().copied());
        let squares: Vec<f64> = turns.iter().map(|turn| turn * turn).collect();
        assert!(mean(&turns, &weights).abs() < 1e-9);
        assert!((mean(&squares, &weights).sqrt() - 12.0).abs() < 0.05);
        assert_eq!(self::turns([(1.0, 0.0), (-1.0, 0.0)].into_iter(), [0.5, 0.5].into_iter()), [0.0, 0.0]);
    }
}
