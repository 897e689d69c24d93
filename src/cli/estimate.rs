//! Estimates of long durations, before work starts.

use crate::synth::Training;
use crate::synth::estimate::{Needs, Task, in_words};

/// Longer durations than this are announced, seconds.
const LONG: f64 = 3.0;
/// px of all canvases and pictures below which a growth is faster than its estimate.
const SMALL: f64 = 700.0 * 700.0;
/// Most documents of a batch that are estimated; the others are taken to need the same time for each px.
const MAX_ESTIMATED: usize = 4;

/// Announces how long work will take.
pub struct Estimate<'a> {
    /// The training sets.
    pub training: &'a Training,
    /// Announce nothing.
    pub quiet: bool,
}

impl Estimate<'_> {
    /// Writes to stderr how long these tasks will take, each grown `times` times, if that is long.
    pub fn announce(&self, tasks: &[Task], times: f64) {
        let px: f64 = tasks.iter().map(|task| task.px()[1]).sum();
        if self.quiet || times * px < SMALL {
            return;
        }
        let every = tasks.len().div_ceil(MAX_ESTIMATED).max(1);
        let (mut seconds, mut tried) = (0.0, 0.0);
        for task in tasks.iter().step_by(every) {
            // A document that cannot be grown gives its error later.
            if let Some(found) = Needs::estimate(task, self.training) {
                seconds += found.seconds;
                tried += task.px()[1];
            }
        }
        if tried > 0.0 {
            self.announce_seconds(times * seconds * px / tried);
        }
    }

    /// Writes to stderr that the work will take so many seconds, if they are many.
    pub fn announce_seconds(&self, seconds: f64) {
        if !self.quiet && seconds > LONG {
            super::note(&format!("this will take {}", in_words(seconds)));
        }
    }
}
