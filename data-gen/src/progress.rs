//! Progress of a sweep: a bar on a terminal, a summary at the end.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use crate::run::Record;
use crate::verdicts::{ACCEPTED, reasons as all_reasons};

/// Runs counted by verdict.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    counts: BTreeMap<&'static str, u64>,
}

impl Tally {
    /// The counts of these runs.
    pub fn count_records<'a>(records: impl IntoIterator<Item = &'a Record>) -> Self {
        let mut tally = Self::default();
        for record in records {
            tally.add(record.verdict);
        }
        tally
    }

    /// Counts one more run.
    pub fn add(&mut self, verdict: &'static str) {
        *self.counts.entry(verdict).or_default() += 1;
    }

    /// Runs with this verdict.
    pub fn count(&self, verdict: &str) -> u64 {
        self.counts.get(verdict).copied().unwrap_or(0)
    }

    /// All runs.
    pub fn all(&self) -> u64 {
        self.counts.values().sum()
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let accepted = self.count(ACCEPTED);
        write!(f, "{accepted} accepted, {} rejected", self.all() - accepted)?;
        let mut reasons = String::new();
        for kind in all_reasons().filter(|kind| self.count(kind) > 0) {
            let comma = if reasons.is_empty() { "" } else { ", " };
            write!(reasons, "{comma}{kind} {}", self.count(kind))?;
        }
        if reasons.is_empty() { Ok(()) } else { write!(f, " ({reasons})") }
    }
}

/// The bar of one set. Nothing is drawn where stderr is not a terminal.
pub struct Bar {
    bar: ProgressBar,
    tally: Mutex<Tally>,
}

impl Bar {
    /// A bar for `runs` runs of the set `name`, of which `before` were done earlier.
    pub fn new(name: &str, runs: u64, before: Tally) -> Self {
        let style =
            ProgressStyle::with_template("{prefix} {bar:20} {pos}/{len}  {elapsed} gone, {eta} left  {msg}");
        let bar = ProgressBar::new(runs)
            .with_prefix(name.to_owned())
            .with_message(before.to_string())
            .with_position(before.all())
            .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        // The time left is estimated from the runs of this start, not from earlier ones.
        bar.reset_eta();
        Self { bar, tally: Mutex::new(before) }
    }

    /// Counts one more finished run.
    pub fn done(&self, verdict: &'static str) {
        self.bar.inc(1);
        if let Ok(mut tally) = self.tally.lock() {
            tally.add(verdict);
            self.bar.set_message(tally.to_string());
        }
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

/// The summary of a set: `ran` runs took this time, the others were done before.
pub fn summary(name: &str, tally: &Tally, ran: u64, time: Duration) -> String {
    let seconds = time.as_secs_f64();
    let speed =
        if ran > 0 { format!(", {:.1} a second", ran as f64 / seconds.max(1e-9)) } else { String::new() };
    let before = tally.all() - ran;
    let earlier = if before > 0 { format!(" ({before} of them earlier)") } else { String::new() };
    format!("{name}: {} runs{earlier} in {seconds:.1} s{speed}: {tally}", tally.all())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_of_a_set_lists_the_reasons_of_rejected_runs() {
        let mut tally = Tally::default();
        assert_eq!(tally.to_string(), "0 accepted, 0 rejected");
        for verdict in [ACCEPTED, "too-small", "touching", ACCEPTED, "touching", ACCEPTED] {
            tally.add(verdict);
        }
        assert_eq!(tally.to_string(), "3 accepted, 3 rejected (touching 2, too-small 1)");
        let output = summary("a-set", &tally, 4, Duration::from_secs(2));
        assert_eq!(
            output,
            "a-set: 6 runs (2 of them earlier) in 2.0 s, 2.0 a second: 3 accepted, 3 rejected (touching 2, too-small 1)"
        );
        assert!(
            summary("a-set", &tally, 0, Duration::ZERO)
                .starts_with("a-set: 6 runs (6 of them earlier) in 0.0 s: 3")
        );
    }
}
