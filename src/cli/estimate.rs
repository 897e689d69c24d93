//! How long it will take, told before it begins.

use crate::synth::Training;
use crate::synth::estimate::{Needs, Task, in_words};
use std::io::Write;

/// What takes longer than this is told, seconds.
const LONG: f64 = 5.0;
/// px of all canvases and pictures below which a growth is over before its time is worked out.
const SMALL: f64 = 700.0 * 700.0;
/// Documents of a batch that are tried at most; the others take as long for their px as these.
const TRIED: usize = 4;

/// Tells how long work will take.
pub struct Estimate<'a> {
    /// What parameters are looked up in.
    pub training: &'a Training,
    /// Nobody wants to know.
    pub quiet: bool,
}

impl Estimate<'_> {
    /// Tells on stderr how long these will take, each grown `times`, where that is long.
    pub fn tell(&self, tasks: &[Task], times: f64) {
        let px: f64 = tasks.iter().map(|task| task.px()[1]).sum();
        if self.quiet || times * px < SMALL {
            return;
        }
        let every = tasks.len().div_ceil(TRIED).max(1);
        let (mut seconds, mut tried) = (0.0, 0.0);
        for task in tasks.iter().step_by(every) {
            // What cannot be grown says why when it is its turn.
            if let Some(found) = Needs::estimate(task, self.training) {
                seconds += found.seconds;
                tried += task.px()[1];
            }
        }
        if tried > 0.0 {
            self.tell_seconds(times * seconds * px / tried);
        }
    }

    /// Tells on stderr that it will take so many seconds, where these are many.
    pub fn tell_seconds(&self, seconds: f64) {
        if !self.quiet && seconds > LONG {
            // Nobody left to tell is no reason to fail.
            let _ = writeln!(std::io::stderr(), "note: this will take {}", in_words(seconds));
        }
    }
}
