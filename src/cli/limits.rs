//! The limits of what a command grows.

use crate::synth::time::TimeLimit;

/// Longest time that may be allowed, minutes: a week.
const MOST: i64 = 7 * 24 * 60;

/// How long a growth may take.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Grow what takes up to N minutes of one core [default: 10, of a canvas under 1414 x 1414 px .3 ms a px but at least 5 s]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MOST))]
    pub minutes: Option<u32>,
}

impl Limits {
    /// What it means.
    #[must_use]
    pub fn time(self) -> TimeLimit {
        self.minutes.map_or(TimeLimit::Usual, |minutes| TimeLimit::Seconds(60.0 * f64::from(minutes)))
    }
}
