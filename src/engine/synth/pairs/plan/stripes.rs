//! Plans of pair stripes: one pair that grows from noise, with lines that end in tips.

use super::base_model;
use crate::rd::pairs::{PairModel, Threads};

/// e: 2 as for Witkin and Kass's zebra. The longer the blurs, the straighter the lines and the fewer their tips.
const ELONGATION: f32 = 2.0;
/// Distance of the lines ÷ Λ: after a time of 14 lines from noise are 0.81 to 0.86 Λ apart (`facts.md` X).
const PERIOD: f64 = 0.83;

/// The size s of the pair of these threads, px, for periods of `factor` times the wanted ones.
pub(super) fn size(threads: &Threads, factor: f64) -> f64 {
    size_of_period(factor * threads.period)
}

/// The size s of a pair whose lines are `period` apart, in the unit of the period.
pub fn size_of_period(period: f64) -> f64 {
    period / (PERIOD * base_model().wavelength())
}

/// e of the pair.
pub fn elongation() -> f32 {
    ELONGATION
}

/// The reaction, for a pair whose smallest size is `least` cells.
pub fn model(least: f32) -> PairModel {
    PairModel { softness: 1.0 / (3.0 * least), ..base_model() }
}
