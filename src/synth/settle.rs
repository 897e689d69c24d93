//! Growing until nothing moves any more.

use super::watch::{Cancelled, Stage, Watch};
use crate::rd::{Growth, Maps, System};

/// When a pattern counts as settled: normalised times (`facts.md` 0) where the reactions are slowest.
struct Criterion {
    /// Looked at this often.
    every: f64,
    /// Not asked before.
    earliest: f64,
    /// Given up after.
    latest: f64,
    /// Settled where the pattern changes by less than this share of itself from one look to the next.
    change: f32,
}

/// Tuned on patches of 36 to 80 spots and 12 wavelengths: where the change is below the bound, area (width) and
/// direction are within 0.5 % and 0.3° of what they are four times later.
fn criterion(system: System) -> Criterion {
    match system {
        System::TuringSpots => Criterion { every: 5.0, earliest: 20.0, latest: 150.0, change: 0.01 },
        System::MeinhardtSpots => Criterion { every: 2.5, earliest: 10.0, latest: 120.0, change: 0.004 },
        System::MeinhardtStripes => Criterion { every: 10.0, earliest: 40.0, latest: 300.0, change: 0.02 },
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
        let end = growth.steps() + growth.steps_in(criterion.every);
        while growth.steps() < end {
            // About as long as one may wait for a key to be heeded, on the largest grids too.
            growth.advance(16.min(end - growth.steps()));
            watch.step(Stage::Grow, growth.time() / (2.0 * criterion.earliest))?;
        }
        let after = growth.marks(maps).values;
        let change = change(&before, &after);
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
fn change(before: &[f32], after: &[f32]) -> f32 {
    let (mut moved, mut total) = (0.0f64, 0.0f64);
    for (b, a) in before.iter().zip(after) {
        moved += f64::from((a - b).abs());
        total += f64::from(a.max(0.0));
    }
    (moved / total) as f32
}
