//! Growing until nothing moves any more.

use super::watch::{Cancelled, Stage, Watch};
use crate::rd::{Growth, Maps, System};

/// When a pattern counts as settled: normalised times (`facts.md` 0) where the reactions are slowest.
struct Criterion {
    /// Not asked before.
    earliest: f64,
    /// Given up after.
    latest: f64,
    /// The share of itself by which a pattern may still change a unit of time, where that is steady drift.
    drift: f64,
}

/// Time between two looks.
const EVERY: f64 = 2.5;
/// From look to look what is still forming falls to below this share, drift stays above it.
const FALLING: f64 = 0.8;
/// Steps that are taken at most. Spots sixteen times the area of the smallest (3×3 regions, neighbours a factor 2
/// apart) need some 80,000; a canvas that needs more has no business to take the night.
const STEPS: u64 = 150_000;
/// Change a unit of time that is rest by any measure.
const REST: f64 = 0.0003;

/// Tuned on patches of 90 spots and 10 wavelengths grown to T = 200, and on canvases whose regions differ. Changes
/// fall by a half from look to look while spots form; then they stay: spots slide along gradients and even out
/// their distances, forks of stripes heal, for ever more slowly. From there on the mean area is within 0.3 %
/// (Turing 0.5 %, width of stripes 2 %) of where it goes, and the direction within 0.5°.
fn criterion(system: System) -> Criterion {
    match system {
        System::TuringSpots => Criterion { earliest: 20.0, latest: 150.0, drift: 0.008 },
        System::MeinhardtSpots => Criterion { earliest: 15.0, latest: 120.0, drift: 0.004 },
        System::MeinhardtStripes => Criterion { earliest: 30.0, latest: 300.0, drift: 0.008 },
    }
}

/// Grows until settled. Gives whether it did within the time it was given.
///
/// # Errors
/// [`Cancelled`].
pub fn settle(growth: &mut Growth, maps: &Maps, system: System, watch: &Watch) -> Result<bool, Cancelled> {
    let criterion = criterion(system);
    let mut before = growth.marks(maps).values;
    let mut last = f64::INFINITY;
    loop {
        let end = growth.steps() + growth.steps_in(EVERY).min(STEPS);
        while growth.steps() < end {
            // About as long as one may wait for a key to be heeded, on the largest grids too.
            growth.advance(16.min(end - growth.steps()));
            watch.step(Stage::Grow, growth.time() / (1.5 * criterion.earliest))?;
        }
        let after = growth.marks(maps).values;
        let change = change(&before, &after) / EVERY;
        let steady = change < criterion.drift && change > FALLING * last;
        if growth.time() >= criterion.earliest && (steady || change < REST) {
            return Ok(true);
        }
        if growth.time() >= criterion.latest || growth.steps() >= STEPS || !change.is_finite() {
            return Ok(false);
        }
        (before, last) = (after, change);
    }
}

/// Σ|after − before| ÷ Σ after over what is not ground.
fn change(before: &[f32], after: &[f32]) -> f64 {
    let (mut moved, mut total) = (0.0f64, 0.0f64);
    for (b, a) in before.iter().zip(after) {
        moved += f64::from((a - b).abs());
        total += f64::from(a.max(0.0));
    }
    moved / total
}
