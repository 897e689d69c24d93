//! Estimates of long durations, before work starts.

use std::sync::atomic::{AtomicBool, Ordering};

use super::progress::overall;
use crate::machine::clock::Instant;
use crate::synth::estimate::{Needs, Task, in_words};
use crate::synth::{Stage, Training};

/// Longer durations than this are announced, seconds.
const LONG: f64 = 3.0;
/// Canvases and pictures of fewer px than this, in all, mostly grow faster than their estimate. If such a growth takes
/// long all the same, [`Underway`] announces that while it runs.
const SMALL: f64 = 700.0 * 700.0;
/// The most documents of a batch that are estimated; the others are assumed to need the same time for each px.
const MAX_ESTIMATED: usize = 4;

/// Announces how long work will take.
pub struct Estimate<'a> {
    /// The training sets.
    pub training: &'a Training,
    /// Announce nothing.
    pub quiet: bool,
}

impl Estimate<'_> {
    /// Writes to stderr how long these tasks will take, each grown `times` times with `pictures` finished pictures, if that
    /// is long. Returns whether it was written.
    pub fn announce(&self, tasks: &[Task], times: f64, pictures: f64) -> bool {
        let px: f64 = tasks.iter().map(|task| task.px()[1]).sum();
        if self.quiet || times.max(pictures) * px < SMALL {
            return false;
        }
        let every = tasks.len().div_ceil(MAX_ESTIMATED).max(1);
        let (mut seconds, mut tried) = (0.0, 0.0);
        for task in tasks.iter().step_by(every) {
            // A document that cannot be grown reports its error later.
            if let Some(found) = Needs::estimate(task, self.training) {
                seconds += times * found.seconds + pictures * found.finish;
                tried += task.px()[1];
            }
        }
        tried > 0.0 && self.announce_seconds(seconds * px / tried)
    }

    /// Writes to stderr that the work will take this number of seconds, if that is long. Returns whether it was
    /// written.
    pub fn announce_seconds(&self, seconds: f64) -> bool {
        let is_long = !self.quiet && seconds > LONG;
        if is_long {
            super::note(&format!("this will take {}", in_words(seconds)));
        }
        is_long
    }
}

/// Work must have run for this long before its whole duration is estimated from its progress, seconds.
const BEGUN: f64 = 1.0;
/// The least progress from which the whole duration is estimated.
const LEAST: f64 = 0.02;

/// Work that is running. It reports its estimated duration once, where none was announced before.
pub struct Underway {
    started: Instant,
    /// The number of such growths in all.
    times: f64,
    said: AtomicBool,
}

impl Underway {
    /// The first of `times` growths starts now. `said`: the duration was already announced, or is not to be announced.
    pub fn begin(times: usize, said: bool) -> Self {
        Self { started: Instant::now(), times: times.max(1) as f64, said: AtomicBool::new(said) }
    }

    /// Notes the share (0..1) of a stage of the first growth that is done. Returns, once, a message about the duration
    /// of all growths if it is long.
    #[must_use]
    pub fn show(&self, stage: Stage, share: f64) -> Option<String> {
        if self.said.load(Ordering::Relaxed) {
            return None;
        }
        let seconds = judged(self.started.elapsed().as_secs_f64(), overall(stage, share), self.times)?;
        let is_first = !self.said.swap(true, Ordering::Relaxed);
        (is_first && seconds > LONG).then(|| format!("this will take {}", in_words(seconds)))
    }
}

/// The estimated seconds of `times` growths, where one has run for `elapsed` seconds and is done by this share; `None`
/// while that is too uncertain.
fn judged(elapsed: f64, done: f64, times: f64) -> Option<f64> {
    (elapsed >= BEGUN && done >= LEAST).then(|| times * elapsed / done)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_duration_is_estimated_from_the_progress() {
        assert_eq!(judged(0.5, 0.5, 1.0), None);
        assert_eq!(judged(2.0, 0.01, 1.0), None);
        assert_eq!(judged(2.0, 0.25, 3.0), Some(24.0));
    }
}
