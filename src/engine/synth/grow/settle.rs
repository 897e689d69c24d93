//! Growing until the pattern has settled.

use crate::synth::grow::engine::Engine;
use crate::synth::watch::{Cancelled, Stage, Watch};

/// Cell updates between two calls of the watch: some milliseconds.
pub const UPDATES: u64 = 4_000_000;

/// Grows until settled. Returns whether it did within its time.
///
/// # Errors
/// [`Cancelled`].
pub fn settle(engine: &mut Engine, watch: &Watch) -> Result<bool, Cancelled> {
    settle_seen(engine, None, watch, &mut |_| {})
}

/// As [`settle`], and calls `seen` each `every` of normalised time, at the same moments on any machine; `None` = every few
/// milliseconds.
///
/// # Errors
/// [`Cancelled`].
pub fn settle_seen(
    engine: &mut Engine,
    every: Option<f64>,
    watch: &Watch,
    seen: &mut dyn FnMut(&Engine),
) -> Result<bool, Cancelled> {
    while engine.advance(every.map_or(UPDATES, |time| engine.updates_in(time))) {
        watch.step(Stage::Grow, engine.progress())?;
        seen(engine);
    }
    Ok(engine.settled())
}
