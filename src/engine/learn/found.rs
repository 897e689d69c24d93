//! What answers a question.

use std::sync::OnceLock;

use super::answer::Prediction;
use super::coverage::{Coverage, Judgement};
use super::{InCells, Note, Parameters};
use crate::attributes::Attributes;

/// What answers a question, without what it is predicted to grow: where spots may have any spacing, to predict takes three quarters of
/// the time of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The parameters of the simulation.
    pub parameters: Parameters,
    /// Spacing of the spots ÷ the spacing that the system gives them by itself; 1 = its own.
    pub pitch: f64,
    /// Whether the question lies within the range of the rows.
    pub coverage: Coverage,
    /// The nearest question within the rows; the question itself where it is within.
    pub nearest: InCells<Attributes>,
    /// Remarks for the user.
    pub notes: InCells<Vec<Note>>,
    /// What it is predicted to grow, once that is known.
    pub(super) prediction: OnceLock<InCells<Prediction>>,
}

impl Found {
    /// The parameters for the question `nearest`, of marks as near to each other as their system puts them by itself.
    pub(super) fn judged(parameters: Parameters, nearest: Attributes, judgement: Judgement) -> Self {
        let Judgement { coverage, notes } = judgement;
        let (nearest, notes) = (InCells(nearest), InCells(notes));
        Self { parameters, pitch: 1.0, coverage, nearest, notes, prediction: OnceLock::new() }
    }
}
