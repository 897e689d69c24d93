//! The initial noise of pair stripes and stucco, and the drawn lines in it.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::grid::Domain;
use crate::rd::pairs::PairKind;
use crate::synth::pairs::grow::nearest_line::{NearestLine, nearest_lines};
use crate::synth::pairs::plan::PairPlan;

/// Distance from a drawn line at which the noise begins, in periods: if it were closer, the next line would not keep its distance.
pub const BESIDE: f64 = 0.5;

/// The reaction at each cell, 0..1: white noise; on the drawn lines of pair stripes 1, and beside them 0.
pub(super) fn noise_around_lines(plan: &PairPlan, seed: u64) -> Vec<f32> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut reaction: Vec<f32> = (0..plan.grid.cells()).map(|_| random.random::<f32>()).collect();
    if plan.kind() == PairKind::Stripes {
        // The threshold is 0, so that lines grow half as wide as their period.
        for (value, line) in reaction.iter_mut().zip(nearest_lines(plan, BESIDE)) {
            if let Some(NearestLine { away, period, .. }) = line {
                *value = ((0.25 * period - away) / plan.px_a_cell() + 0.5).clamp(0.0, 1.0) as f32;
            }
        }
    }
    for (value, taken) in reaction.iter_mut().zip(&plan.obstacles) {
        *value *= f32::from(u8::from(!taken));
    }
    reaction
}
