//! The log of what the passes over a layer saw, changed and cost.

use super::pass::Pass;

/// One run of a pass: its observations, changes and cost, including the growth that followed from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// The pass.
    pub pass: Pass,
    /// The error that it saw: the largest relative error of sizes for thresholds; the error of drawn spots for corrections;
    /// otherwise a number of spots.
    pub saw: f64,
    /// Number of regions, spots or patterns that were changed.
    pub changed: usize,
    /// Number of rounds.
    pub rounds: usize,
    /// Number of cell updates and measured px.
    pub updates: u64,
    /// Seconds by the clock of this thread, see [`profile`](crate::synth::profile); 0 without a clock.
    pub seconds: f64,
}

/// The runs of passes over a layer, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    entries: Vec<Entry>,
}

impl Trace {
    /// The runs that changed something, and the growth.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Begins the entry of a run of `pass`.
    pub(super) fn begin(&mut self, pass: Pass, saw: f64, changed: usize) {
        self.entries.push(Entry { pass, saw, changed, rounds: 0, updates: 0, seconds: 0.0 });
    }

    /// Adds a round to the entry of the last run.
    pub(super) fn add_round(&mut self) {
        if let Some(entry) = self.entries.last_mut() {
            entry.rounds += 1;
        }
    }

    /// Adds work to the entry of the last run.
    pub(super) fn add(&mut self, updates: u64, seconds: f64) {
        if let Some(entry) = self.entries.last_mut() {
            entry.updates += updates;
            entry.seconds += seconds;
        }
    }
}
