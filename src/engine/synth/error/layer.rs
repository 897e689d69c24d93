//! Why a layer does not grow. Which layer it is, of which file, is added by [`LayerError::in_layer`].

use crate::document::DocumentError;
use crate::synth::error::{CurvesError, GrowError, LayOutError, PlanError, TooFine};
use crate::synth::memory::TooLarge;
use crate::synth::time::TooLong;

/// Why a layer does not grow: what is said after the name of the layer.
#[derive(Debug, thiserror::Error)]
pub enum LayerError {
    /// What was drawn cannot be grown there: file, place, value, what is allowed.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error("cannot be grown: {0}")]
    Plan(#[from] PlanError),
    /// It does not fit into memory.
    #[error("cannot be grown on this machine: {0}")]
    TooLarge(#[from] TooLarge),
    /// It takes too long.
    #[error("takes too long: {0}")]
    TooLong(#[from] TooLong),
    /// It needs too much on its model.
    #[error("cannot be grown on its model: {0}")]
    TooFine(#[from] TooFine),
    /// The marks beneath leave no place for any of its own.
    #[error(
        "finds no room: none of its marks fits between those of the layers beneath; draw smaller ones, or those beneath farther apart"
    )]
    NoRoom,
    /// Rings or a web find nothing to go round, or no room.
    #[error("cannot be grown: {0}")]
    Curves(CurvesError),
    /// Nothing grew, or no ground was left.
    #[error("grew {what}: {advice}")]
    Blank {
        /// What it is instead of a pattern.
        what: &'static str,
        /// Why that is so, and what to change.
        advice: &'static str,
    },
    /// All points have the same value.
    #[error("is of one value everywhere: {advice}")]
    Flat {
        /// Why that is so, and what to change.
        advice: &'static str,
    },
    /// The pattern left the range in which its system works.
    #[error("grew no pattern: its concentrations are not finite; try another seed or larger marks")]
    NoPattern,
}

impl LayerError {
    /// Why marks are blank, and what to change.
    pub const MARKS: &str =
        "its marks are too large for the canvas or merged; draw smaller marks, or farther apart";

    /// The error of layer number `layer`, 1 = the lowest, of the document in `file`.
    #[must_use]
    pub fn in_layer(self, file: &str, layer: usize) -> GrowError {
        match self {
            // It names both already.
            Self::Document(error) => GrowError::Document(error),
            reason => GrowError::Layer { file: file.to_owned(), layer, reason: Box::new(reason) },
        }
    }

    /// Whether it depends on what grows, on this layer or beneath: no plan shows it.
    #[must_use]
    pub fn is_shown_by_growing(&self) -> bool {
        match self {
            Self::NoRoom | Self::Curves(_) | Self::Blank { .. } | Self::Flat { .. } | Self::NoPattern => true,
            Self::Document(_) | Self::Plan(_) | Self::TooLarge(_) | Self::TooLong(_) | Self::TooFine(_) => {
                false
            }
        }
    }
}

impl From<LayOutError> for LayerError {
    fn from(error: LayOutError) -> Self {
        match error {
            LayOutError::NoRoom => Self::NoRoom,
            LayOutError::Curves(reason) => Self::Curves(reason),
        }
    }
}
