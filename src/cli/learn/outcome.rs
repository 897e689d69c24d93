//! The outcome of one method.

use crate::learn::Errors;
use crate::rd::Bounds;

/// What was compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The parameters that were found for rows that were left out, compared with those of the rows.
    Parameters,
    /// The attributes of new growths, compared with those that were asked for.
    Grown,
}

impl Of {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Parameters => "parameters",
            Self::Grown => "grown",
        }
    }
}

/// The errors of one method with a training set of some size.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The name of the system.
    pub system: &'static str,
    /// What was compared.
    pub of: Of,
    /// The name of the method.
    pub way: &'static str,
    /// The allowed errors of new growths with all rows.
    pub bounds: Bounds,
    /// Rows in the training set.
    pub rows: usize,
    /// Whether these are all rows.
    pub all: bool,
    /// Number of questions.
    pub asked: usize,
    /// The questions that were refused or that grew no texture, with reasons.
    pub failed: Vec<String>,
    /// Errors of the other questions, by quantity.
    pub errors: Vec<Errors>,
}

impl Outcome {
    /// The allowed median and 95th percentile of a quantity; only training sets with all rows have bounds.
    pub fn bound(&self, quantity: &str) -> Option<[f64; 2]> {
        let bounds = if self.all && self.of == Of::Grown { self.bounds } else { &[] };
        bounds.iter().find(|(attribute, _)| attribute.name() == quantity).map(|(_, allowed)| *allowed)
    }

    /// Whether the errors are as small as allowed; `None` if there is no bound.
    pub fn holds(&self, errors: &Errors) -> Option<bool> {
        self.bound(errors.quantity).map(|[median, p95]| errors.median <= median && errors.p95 <= p95)
    }

    /// Whether nothing failed; `None` if there is no bound.
    pub fn none_failed(&self) -> Option<bool> {
        let bound = self.all && self.of == Of::Grown && !self.bounds.is_empty();
        bound.then_some(self.failed.is_empty())
    }
}

/// `ok`, `MISSED`, or nothing if there is no bound.
pub fn verdict(holds: Option<bool>) -> &'static str {
    match holds {
        Some(true) => "ok",
        Some(false) => "MISSED",
        None => "",
    }
}
