//! The mean period of the strokes of each group.

use super::{PeriodRules, Wanted, pieces, wanted_periods};
use crate::grid::Bounds;
use crate::marks::Path;

/// By group, the mean log period (px) of its strokes; `None` of a group in which no two lie side by side.
///
/// It is the mean of what free strokes want, under the same weights, as far as both strokes are in the group. Strokes beside which none
/// lies say nothing. `group` gives the group of a stroke, of `groups`.
pub(in crate::attributes) fn grouped_periods(
    strokes: &[Path],
    bounds: &Bounds,
    rules: &PeriodRules,
    groups: usize,
    group: impl Fn(usize) -> usize,
) -> Vec<Option<f64>> {
    let mut means = vec![Mean::default(); groups];
    for one in &wanted_periods(strokes, &pieces(strokes), bounds, rules) {
        let [a, b] = one.strokes.map(&group);
        if a == b {
            means[a].add(one, rules);
        }
    }
    means.iter().map(Mean::log_period).collect()
}

/// Sums over the strokes of a group.
#[derive(Clone, Copy, Default)]
struct Mean {
    is_measured: bool,
    log_periods: f64,
    weights: f64,
}

impl Mean {
    fn add(&mut self, wanted: &Wanted, rules: &PeriodRules) {
        let sure = if wanted.is_measured { wanted.weight } else { wanted.beside };
        let weight = sure * wanted.length();
        self.is_measured |= wanted.is_measured;
        self.log_periods += weight * wanted.possible(rules);
        self.weights += weight;
    }

    fn log_period(&self) -> Option<f64> {
        self.is_measured.then(|| self.log_periods / self.weights)
    }
}
