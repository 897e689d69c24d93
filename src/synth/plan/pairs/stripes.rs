//! Plans of pair stripes: one pair from noise, whose lines end in tips.

use super::base_model;
use super::cut::{Sorted, cut};
use crate::grid::{Field, Grid};
use crate::rd::pairs::{PairMaps, PairModel, Threads};
use crate::synth::plan::pairs::thread_map::ThreadMap;

/// e: 2 as in Witkin and Kass's zebra. The longer the blurs, the straighter the lines and the fewer their tips.
const ELONGATION: f32 = 2.0;
/// Distance of the lines ÷ Λ: after a time of 14 lines from noise are .81 to .86 Λ apart (`facts.md` X).
const PERIOD: f64 = 0.83;

/// The size s of the pair of these threads, px, for periods `factor` times as long as they are wanted.
pub(super) fn size(threads: &Threads, factor: f64) -> f64 {
    factor * threads.period / (PERIOD * base_model().wavelength())
}

/// e of the pair.
pub(super) fn elongation() -> f32 {
    ELONGATION
}

/// The difference D, so scaled at each cell that 1 is the value above which the wanted share of all cells lies: the threshold of the
/// reaction is 0 and half of the cells are above it, so that lines are cut from D as wide as they are wanted.
pub(super) fn shown(difference: &Field, threads: &ThreadMap, grid: &Grid) -> Field {
    let sorted = Sorted::new(difference);
    cut(difference, &sorted, |cell| sorted.quantile(1.0 - threads.threads_at(grid.center_px(cell)).duty()))
}

/// The reaction, for a pair of these `maps`.
pub(super) fn model(maps: &PairMaps) -> PairModel {
    PairModel { softness: 1.0 / (3.0 * maps.least_size()), ..base_model() }
}
