//! How well one way did.

use super::bounds::bounds;
use super::way::Way;
use crate::learn::Errors;
use crate::rd::System;

/// What was compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The parameters found for rows that were held out, against theirs.
    Parameters,
    /// What grows anew, against what was asked.
    Grown,
}

impl Of {
    /// In the table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Parameters => "parameters",
            Self::Grown => "grown",
        }
    }
}

/// How well a way did with so many rows to learn from.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The system.
    pub system: System,
    /// What was compared.
    pub of: Of,
    /// The way.
    pub way: Way,
    /// Rows that were learnt from.
    pub rows: usize,
    /// Whether that was all there are.
    pub all: bool,
    /// Questions.
    pub asked: usize,
    /// Those that were refused or grew no texture, in words.
    pub failed: Vec<String>,
    /// Errors of the others, by quantity.
    pub errors: Vec<Errors>,
}

impl Outcome {
    /// Median and 95th percentile that are allowed of this quantity; only all rows are bound by anything.
    pub fn bound(&self, quantity: &str) -> Option<[f64; 2]> {
        let bounds = if self.all && self.of == Of::Grown { bounds(self.system, self.way) } else { &[] };
        bounds.iter().find(|(bound, _)| *bound == quantity).map(|(_, allowed)| *allowed)
    }

    /// Whether the errors are as small as allowed; `None` where nothing is said.
    pub fn holds(&self, errors: &Errors) -> Option<bool> {
        self.bound(errors.quantity).map(|[median, p95]| errors.median <= median && errors.p95 <= p95)
    }

    /// Whether nothing failed; `None` where nothing is said.
    pub fn none_failed(&self) -> Option<bool> {
        let bound = self.all && self.of == Of::Grown && !bounds(self.system, self.way).is_empty();
        bound.then_some(self.failed.is_empty())
    }
}

/// `ok`, `MISSED`, or nothing where nothing is said.
pub fn verdict(holds: Option<bool>) -> &'static str {
    match holds {
        Some(true) => "ok",
        Some(false) => "MISSED",
        None => "",
    }
}
