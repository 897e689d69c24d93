//! Reasons why a layer does not grow. [`LayerError::in_layer`] adds the layer and the file.

use crate::document::DocumentError;
use crate::synth::error::{CurvesError, GrowError, LayOutError, PlanError, TooFine};
use crate::synth::memory::TooLarge;
use crate::synth::time::TooLong;

/// The reason why a layer does not grow: the part of the message after the name of the layer.
#[derive(Debug, thiserror::Error)]
pub enum LayerError {
    /// The strokes cannot be grown: file, place, value, what is allowed.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error("cannot be grown: {0}")]
    Plan(#[from] PlanError),
    /// The layer does not fit into memory.
    #[error("cannot be grown on this machine: {0}")]
    TooLarge(#[from] TooLarge),
    /// The layer takes too long.
    #[error("takes too long: {0}")]
    TooLong(#[from] TooLong),
    /// The layer needs too much memory or time on its model.
    #[error("cannot be grown on its model: {0}")]
    TooFine(#[from] TooFine),
    /// The marks beneath leave no room for any mark of the layer.
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
        /// The content that has grown instead of a pattern.
        what: &'static str,
        /// The reason, and what to change.
        advice: &'static str,
    },
    /// All points have the same value.
    #[error("is of one value everywhere: {advice}")]
    Flat {
        /// The reason, and what to change.
        advice: &'static str,
    },
    /// The pattern left the range in which its system works.
    #[error("grew no pattern: its concentrations are not finite; try another seed or larger marks")]
    NoPattern,
}

impl LayerError {
    /// The reason why a layer of marks is blank, and what to change.
    pub const MARKS: &str =
        "its marks are too large for the canvas or merged; draw smaller marks, or farther apart";

    /// The error of layer number `layer`, 1 = the lowest, of the document in `file`.
    #[must_use]
    pub fn in_layer(self, file: &str, layer: usize) -> GrowError {
        match self {
            // The message names both already.
            Self::Document(error) => GrowError::Document(error),
            reason => GrowError::Layer { file: file.to_owned(), layer, reason: Box::new(reason) },
        }
    }

    /// Whether the error depends on how this layer or those beneath grow, so that no plan shows it.
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
