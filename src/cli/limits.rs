//! The limits of what a command may grow.

use crate::synth::time::TimeLimit;

/// The longest time that can be allowed, minutes: a week.
const MOST: i64 = 7 * 24 * 60;

/// How long a growth may take.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Allow growths that take up to N minutes of one core [default: 10; for a canvas under 1414 x 1414 px 0.3 ms for
    /// each px, but at least 5 s]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MOST))]
    pub minutes: Option<u32>,
}

impl Limits {
    /// The time limit that the arguments ask for.
    #[must_use]
    pub fn time(self) -> TimeLimit {
        self.minutes.map_or(TimeLimit::Usual, |minutes| TimeLimit::Seconds(60.0 * f64::from(minutes)))
    }
}
