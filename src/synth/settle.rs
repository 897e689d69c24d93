//! Growing until nothing moves any more.

use super::watch::{Cancelled, Stage, Watch};
use crate::rd::{Growth, Maps, System};

/// When a pattern counts as settled: normalised times (`facts.md` 0) where the reactions are slowest.
struct Criterion {
    /// Not asked before.
    earliest: f64,
    /// Given up after.
    latest: f64,
    /// Settled where the pattern changes by less than this share of itself a unit of time.
    change: f64,
}

/// Time between two looks.
const EVERY: f64 = 2.5;

/// Tuned on patches of 90 spots and 10 wavelengths grown to T = 200: where the change has fallen to the bound,
/// the mean area is within 0.3 % (Turing 0.5 %, width of stripes 2 %) of where it goes, and direction within
/// 0.5°. What is left is drift: spots that still even out their distances, forks of stripes that heal.
fn criterion(system: System) -> Criterion {
    match system {
        System::TuringSpots => Criterion { earliest: 20.0, latest: 150.0, change: 0.006 },
        System::MeinhardtSpots => Criterion { earliest: 15.0, latest: 120.0, change: 0.0012 },
        System::MeinhardtStripes => Criterion { earliest: 30.0, latest: 300.0, change: 0.005 },
    }
}

/// Grows until settled. Gives whether it did within the time it was given.
///
/// # Errors
/// [`Cancelled`].
pub fn settle(growth: &mut Growth, maps: &Maps, system: System, watch: &Watch) -> Result<bool, Cancelled> {
    let criterion = criterion(system);
    let mut before = growth.marks(maps).values;
    loop {
        let end = growth.steps() + growth.steps_in(EVERY);
        while growth.steps() < end {
            // About as long as one may wait for a key to be heeded, on the largest grids too.
            growth.advance(16.min(end - growth.steps()));
            watch.step(Stage::Grow, growth.time() / (1.5 * criterion.earliest))?;
        }
        let after = growth.marks(maps).values;
        let change = change(&before, &after) / EVERY;
        if growth.time() >= criterion.earliest && change < criterion.change {
            return Ok(true);
        }
        if growth.time() >= criterion.latest || !change.is_finite() {
            return Ok(false);
        }
        before = after;
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
