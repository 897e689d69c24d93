//! A part of a sweep: every N-th run.

use std::fmt;
use std::str::FromStr;

/// Part `part` of `of` parts, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    /// The number of this part.
    pub part: u64,
    /// The number of parts.
    pub of: u64,
}

/// The most parts into which a sweep can be divided.
const MOST: u64 = 100_000;

impl Shard {
    /// The whole sweep as one part.
    pub const WHOLE: Self = Self { part: 1, of: 1 };

    /// Whether this run belongs to the part.
    pub fn holds(self, index: u64) -> bool {
        index % self.of == self.part - 1
    }

    /// The number of runs among 0..`runs` that belong to the part.
    pub fn count(self, runs: u64) -> u64 {
        (runs + self.of - self.part) / self.of
    }

    /// The name of its journal.
    pub fn journal(self) -> String {
        match self {
            Self::WHOLE => "sweep.journal".to_owned(),
            Self { part, of } => format!("sweep-{part}-of-{of}.journal"),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers =
            text.split_once('/').and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
        match numbers {
            Some((part, of)) if 1 <= part && part <= of && of <= MOST => Ok(Self { part, of }),
            _ => Err(format!("a part is I/N, with I from 1 to N and N up to {MOST}, such as 3/16")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_any_number_hold_each_run_once() {
        for of in 1..=7 {
            for index in 0..20 {
                assert_eq!((1..=of).filter(|part| Shard { part: *part, of }.holds(index)).count(), 1);
            }
            for runs in 0..20 {
                for part in 1..=of {
                    let shard = Shard { part, of };
                    let held = (0..runs).filter(|index| shard.holds(*index)).count() as u64;
                    assert_eq!(shard.count(runs), held, "{shard} of {runs}");
                }
            }
        }
    }

    #[test]
    fn a_part_is_written_as_it_is_read() {
        assert_eq!("3/16".parse::<Shard>().unwrap().to_string(), "3/16");
        for wrong in ["", "3", "0/4", "5/4", "1/0", "1/100001", "-1/4", "a/b", "1/2/3", "1.0/2"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
