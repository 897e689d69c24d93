//! The result of a lookup.

use std::sync::OnceLock;

use super::answer::Prediction;
use super::coverage::{Coverage, Judgement};
use super::{InCells, Note, Parameters};
use crate::attributes::Attributes;

/// The answer to a question, without the predicted attributes: for spots of any spacing, the prediction takes three quarters of the
/// time of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The parameters of the simulation.
    pub parameters: Parameters,
    /// Spacing of the spots ÷ the system's own spacing.
    pub pitch: f64,
    /// Whether the question lies within the range of the rows.
    pub coverage: Coverage,
    /// The nearest question within the rows; equal to the question if that is within.
    pub nearest: InCells<Attributes>,
    /// Remarks for the user.
    pub notes: InCells<Vec<Note>>,
    /// The predicted attributes, once they have been computed.
    pub(super) prediction: OnceLock<InCells<Prediction>>,
}

impl Found {
    /// The parameters for the question `nearest`, at the system's own spacing.
    pub(super) fn judged(parameters: Parameters, nearest: Attributes, judgement: Judgement) -> Self {
        let Judgement { coverage, notes } = judgement;
        let (nearest, notes) = (InCells(nearest), InCells(notes));
        Self { parameters, pitch: 1.0, coverage, nearest, notes, prediction: OnceLock::new() }
    }
}
