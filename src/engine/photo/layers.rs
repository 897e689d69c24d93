//! Two layers for spots of two sizes.
//!
//! The logarithms of the areas are fitted by one and by two normal distributions (expectation maximisation). Two are taken
//! where they are far better (Bayesian information criterion), clearly apart (Ashman's D), of different sizes and of some
//! spots each.
//!
//! K. Ashman, C. Bird & S. Zepf, "Detecting bimodality in astronomical datasets", AJ 108 (1994):
//! D = √2·|μ₁ − μ₀| ÷ √(σ₀² + σ₁²).

/// Least gain of the criterion: "very strong" is 10 (R. Kass & A. Raftery, "Bayes factors", JASA 90 (1995)).
const GAIN: f64 = 10.0;
/// Least D: above 2 two peaks are apart; pictures of two sizes have 10 and more.
const APART: f64 = 2.5;
/// Least ratio of the areas of larger and smaller spots.
const LARGER: f64 = 2.0;
/// Fewest spots of either size.
const LEAST: f64 = 6.0;
/// Least standard deviation of ln area: spots of one size differ by 2 % by their px alone.
const FLOOR: f64 = 0.02;
/// Rounds; the means of distributions that are apart are constant after ten.
const ROUNDS: usize = 60;

/// A normal distribution and its share.
#[derive(Clone, Copy, Debug)]
struct Normal {
    mean: f64,
    deviation: f64,
    share: f64,
}

impl Normal {
    fn density(&self, x: f64) -> f64 {
        let z = (x - self.mean) / self.deviation;
        self.share * libm::exp(-0.5 * z * z) / (self.deviation * std::f64::consts::TAU.sqrt())
    }
}

/// The area between two sizes of spots with these areas; `None` if they have one size. With `wanted` the criteria are ignored.
#[must_use]
pub fn between_sizes(areas: &[f64], wanted: bool) -> Option<f64> {
    let mut logs: Vec<f64> = areas.iter().map(|area| libm::log(*area)).collect();
    logs.sort_by(f64::total_cmp);
    let n = logs.len();
    if n < 2 {
        return None;
    }
    let one = fitted(&logs, |_| 1.0, n as f64);
    let [small, large] = two(&logs)?;
    let density = |x: f64| (small.density(x) + large.density(x)).max(f64::MIN_POSITIVE);
    let likelihood: f64 = logs.iter().map(|x| libm::log(density(*x))).sum();
    let single: f64 = logs.iter().map(|x| libm::log(one.density(*x).max(f64::MIN_POSITIVE))).sum();
    // Two distributions have three more parameters.
    let gain = 2.0 * (likelihood - single) - 3.0 * libm::log(n as f64);
    let squares = small.deviation * small.deviation + large.deviation * large.deviation;
    let apart = std::f64::consts::SQRT_2 * (large.mean - small.mean) / squares.sqrt();
    let clear = gain > GAIN && apart > APART && large.mean - small.mean > libm::log(LARGER);
    let several = [small, large].iter().all(|normal| normal.share * n as f64 >= LEAST);
    if !(wanted || clear && several) {
        return None;
    }
    // Between the means, where both are equally likely.
    let (mut low, mut high) = (small.mean, large.mean);
    for _ in 0..ROUNDS {
        let middle = 0.5 * (low + high);
        if small.density(middle) > large.density(middle) { low = middle } else { high = middle }
    }
    Some(libm::exp(0.5 * (low + high)))
}

/// The two distributions of ascending numbers, the one of the smaller numbers first; `None` if they coincide.
fn two(logs: &[f64]) -> Option<[Normal; 2]> {
    // Starting at the widest gap between neighbours that leaves enough on either side, or else in the middle.
    let least = (LEAST as usize).min(logs.len() / 2).max(1);
    let gaps = least..=logs.len() - least;
    let gap = |k: &usize| logs[*k] - logs[*k - 1];
    let cut = gaps.max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(logs.len() / 2);
    let n = logs.len() as f64;
    let mut pair = [fitted(&logs[..cut], |_| 1.0, n), fitted(&logs[cut..], |_| 1.0, n)];
    for _ in 0..ROUNDS {
        let [small, large] = pair;
        let part = |x: f64| small.density(x) / (small.density(x) + large.density(x)).max(f64::MIN_POSITIVE);
        pair = [fitted(logs, part, n), fitted(logs, |x| 1.0 - part(x), n)];
    }
    (pair[0].mean < pair[1].mean && pair.iter().all(|normal| normal.share > 0.0)).then_some(pair)
}

/// The distribution of numbers that each count as `part`, of `n` in all.
fn fitted(logs: &[f64], part: impl Fn(f64) -> f64, n: f64) -> Normal {
    let weight: f64 = logs.iter().map(|x| part(*x)).sum();
    let mean = logs.iter().map(|x| part(*x) * x).sum::<f64>() / weight.max(f64::MIN_POSITIVE);
    let square =
        logs.iter().map(|x| part(*x) * (x - mean) * (x - mean)).sum::<f64>() / weight.max(f64::MIN_POSITIVE);
    Normal { mean, deviation: square.sqrt().max(FLOOR), share: weight / n }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn areas(means: &[(f64, usize)], variation: f64) -> Vec<f64> {
        let place = |k: usize| 2.0 * ((k * 37 % 100) as f64 / 99.0) - 1.0;
        means
            .iter()
            .flat_map(|(mean, count)| (0..*count).map(move |k| mean * (1.0 + variation * place(k))))
            .collect()
    }

    #[test]
    fn the_limit_between_two_sizes_is_found() {
        let found = between_sizes(&areas(&[(400.0, 30), (60.0, 80)], 0.3), false).unwrap();
        assert!((80.0..280.0).contains(&found), "{found}");
    }

    #[test]
    fn one_size_however_it_varies_and_a_few_larger_ones_are_one_layer() {
        assert_eq!(between_sizes(&areas(&[(400.0, 100)], 0.6), false), None);
        assert_eq!(between_sizes(&areas(&[(400.0, 50), (640.0, 50)], 0.2), false), None);
        assert_eq!(between_sizes(&areas(&[(60.0, 80), (400.0, 3)], 0.2), false), None);
        assert_eq!(between_sizes(&[5.0], true), None);
    }

    #[test]
    fn two_that_are_wanted_are_found() {
        assert!(between_sizes(&areas(&[(400.0, 50), (640.0, 50)], 0.1), true).is_some());
    }
}
