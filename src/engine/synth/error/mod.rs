//! Why a document does not grow.

mod curves;
mod plan;

pub use curves::CurvesError;
pub use plan::{LayOutError, PlanError};

use crate::document::DocumentError;
use crate::synth::memory::TooLarge;
use crate::synth::time::TooLong;
use crate::synth::watch::Cancelled;

impl GrowError {
    /// Why layer number `layer` could not be laid out.
    #[must_use]
    pub fn laying_out(layer: usize, error: LayOutError) -> Self {
        match error {
            LayOutError::NoRoom => Self::NoRoom { layer },
            LayOutError::Curves(reason) => Self::Curves { layer, reason },
        }
    }
}

/// Why a document was not grown.
#[derive(Debug, thiserror::Error)]
pub enum GrowError {
    /// The document is not valid.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// It does not fit into memory.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// It takes too long.
    #[error(transparent)]
    TooLong(#[from] TooLong),
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The marks beneath leave no place for any of its own.
    #[error(
        "layer {layer} finds no room: none of its marks fits between those of the layers beneath; draw smaller ones, or those beneath farther apart"
    )]
    NoRoom {
        /// 1 = the lowest.
        layer: usize,
    },
    /// Rings or a web find nothing to go round, or no room.
    #[error("layer {layer} cannot be grown: {reason}")]
    Curves {
        /// 1 = the lowest.
        layer: usize,
        /// Why.
        reason: CurvesError,
    },
    /// Nothing grew, or no ground was left.
    #[error(
        "layer {layer} grew {what}: its marks are too large for the canvas or merged; draw smaller marks, or farther apart"
    )]
    Blank {
        /// 1 = the lowest.
        layer: usize,
        /// What it is instead of a pattern.
        what: &'static str,
    },
    /// All points have the same value.
    #[error(
        "layer {layer} is of one value everywhere: all its points are dark, or all are light; take another probability or size of labels, or a smaller distance"
    )]
    Flat {
        /// 1 = the lowest.
        layer: usize,
    },
    /// The pattern left the range in which its system works.
    #[error(
        "layer {layer} grew no pattern: its concentrations are not finite; try another seed or larger marks"
    )]
    NoPattern {
        /// 1 = the lowest.
        layer: usize,
    },
}
