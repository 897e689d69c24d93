//! Answers to questions about attributes in px, on a grid.

use std::sync::Arc;

use crate::learn::{Answer, Coverage, Found, Note, Parameters, TrainingSet};
use crate::synth::marks::plan::setting::Setting;

/// The answer to a question. The predicted attributes are computed only on request.
#[derive(Clone)]
pub enum Asked<'a> {
    /// A training set answers.
    Learnt(Learnt<'a>),
    /// A law answers, about the grid itself; lengths are px.
    Law(Box<Answer>),
}

/// The answer of a training set.
#[derive(Clone)]
pub struct Learnt<'a> {
    set: &'a TrainingSet,
    found: Arc<Found>,
    /// px a cell of the grid of the question: so fine that the size of the marks does not matter.
    exact: f64,
    /// px a cell of the grid that the parameters are for.
    cell: f64,
}

impl<'a> Asked<'a> {
    /// The answer that `set` has `found` for a grid of `exact` px a cell, converted to one of `cell` px a cell.
    pub(super) fn new(set: &'a TrainingSet, found: Arc<Found>, [exact, cell]: [f64; 2]) -> Self {
        Self::Learnt(Learnt { set, found, exact, cell })
    }

    /// Parameters on the grid.
    #[must_use]
    pub fn parameters(&self) -> Parameters {
        match self {
            Self::Learnt(Learnt { found, exact, cell, .. }) => {
                let shrink = cell / exact;
                Parameters { rate: found.parameters.rate * (shrink * shrink), ..found.parameters }
            }
            Self::Law(answer) => answer.parameters,
        }
    }

    /// Spacing of the spots ÷ the system's own spacing.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        match self {
            Self::Learnt(learnt) => learnt.found.pitch,
            Self::Law(answer) => answer.pitch,
        }
    }

    /// The parameters, and the pitch at which marks begin.
    #[must_use]
    pub fn setting(&self) -> Setting {
        Setting { parameters: self.parameters(), pitch: self.pitch() }
    }

    /// Whether the question lies within the range of the rows.
    #[must_use]
    pub fn coverage(&self) -> Coverage {
        match self {
            Self::Learnt(learnt) => learnt.found.coverage,
            Self::Law(answer) => answer.coverage,
        }
    }

    /// Remarks for the user; lengths are px.
    #[must_use]
    pub fn notes(&self) -> Vec<Note> {
        match self {
            Self::Learnt(Learnt { found, exact, .. }) => found.notes.clone().in_px(*exact),
            Self::Law(answer) => answer.notes.clone(),
        }
    }

    /// The answer with the predicted attributes; lengths are px, parameters those of the grid.
    #[must_use]
    pub fn predict(&self) -> Answer {
        match self {
            Self::Learnt(Learnt { set, found, exact, .. }) => {
                Answer { parameters: self.parameters(), ..found.predict(set).in_px(*exact) }
            }
            Self::Law(answer) => (**answer).clone(),
        }
    }
}
