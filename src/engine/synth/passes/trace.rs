//! What the passes over a layer saw, changed and cost.

use super::pass::Pass;

/// What one run of a pass saw, changed and cost, together with the growth that followed from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Which pass.
    pub pass: Pass,
    /// What was wrong: the largest relative error of thresholds; the error of drawn spots that corrections saw; otherwise a number of
    /// spots.
    pub saw: f64,
    /// How many regions, spots or patterns were changed.
    pub changed: usize,
    /// How many rounds it took.
    pub rounds: usize,
    /// Cell updates, and measured px, that it took.
    pub updates: u64,
    /// Seconds that it took by the clock of this thread, see [`profile`](crate::synth::profile); 0 without a clock.
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

    /// Begins to write down a run of `pass`.
    pub(super) fn begin(&mut self, pass: Pass, saw: f64, changed: usize) {
        self.entries.push(Entry { pass, saw, changed, rounds: 0, updates: 0, seconds: 0.0 });
    }

    /// Adds a round to what the last run took.
    pub(super) fn add_round(&mut self) {
        if let Some(entry) = self.entries.last_mut() {
            entry.rounds += 1;
        }
    }

    /// Adds to what the last run took.
    pub(super) fn add(&mut self, updates: u64, seconds: f64) {
        if let Some(entry) = self.entries.last_mut() {
            entry.updates += updates;
            entry.seconds += seconds;
        }
    }
}
