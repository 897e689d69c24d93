//! What answers a question, without what it is predicted to grow.

use super::answer::{Answer, Prediction};
use super::coverage::Judgement;
use super::{Coverage, Note, Parameters};
use crate::attributes::Attributes;

/// An [`Answer`] without its prediction, which takes as long again and longer. Lengths are cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// As [`Answer::parameters`].
    pub parameters: Parameters,
    /// As [`Answer::pitch`].
    pub pitch: f64,
    /// As [`Answer::coverage`].
    pub coverage: Coverage,
    /// As [`Answer::nearest`].
    pub nearest: Attributes,
    /// As [`Answer::notes`].
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

impl From<Answer> for Found {
    fn from(answer: Answer) -> Self {
        answer.parts().0
    }
}

impl Prediction {
    /// The same with lengths converted from cells to px, at `cell` px a cell.
    #[must_use]
    pub(super) fn in_px(mut self, cell: f64) -> Self {
        for (attribute, range) in &mut self.interval {
            let factor = match *attribute {
                "area" => cell * cell,
                "spacing" | "width" | "wavelength" => cell,
                _ => 1.0,
            };
            *range = range.map(|end| end * factor);
        }
        Self { attributes: self.attributes.scaled(cell), ..self }
    }
}
