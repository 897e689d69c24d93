//! What answers a question, without what it is predicted to grow.

use super::coverage::{Coverage, Judgement};
use super::{Note, Parameters};
use crate::attributes::Attributes;

/// An [`Answer`](super::Answer) without its prediction. Where spots may have any spacing, to predict takes three quarters of the time
/// of an answer. Lengths are cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The parameters of the simulation.
    pub parameters: Parameters,
    /// As [`Answer::pitch`](super::Answer::pitch).
    pub pitch: f64,
    /// Whether the question lies within the range of the rows.
    pub coverage: Coverage,
    /// As [`Answer::nearest`](super::Answer::nearest).
    pub nearest: Attributes,
    /// Remarks for the user.
    pub notes: Vec<Note>,
}

impl Found {
    /// The parameters for the question `nearest`, of marks as near to each other as their system puts them by itself.
    pub(super) fn judged(parameters: Parameters, nearest: Attributes, judgement: Judgement) -> Self {
        let Judgement { coverage, notes } = judgement;
        Self { parameters, pitch: 1.0, coverage, nearest, notes }
    }

    /// The same with lengths converted from cells to px, at `cell` px a cell. Parameters stay those of the grid.
    #[must_use]
    pub fn in_px(self, cell: f64) -> Self {
        Self {
            nearest: self.nearest.scaled(cell),
            notes: self.notes.into_iter().map(|note| note.in_px(cell)).collect(),
            ..self
        }
    }
}
