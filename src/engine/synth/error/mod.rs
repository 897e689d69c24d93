//! Reasons why a document does not grow.

mod curves;
mod layer;
mod plan;
mod too_fine;

pub use curves::CurvesError;
pub use layer::LayerError;
pub use plan::{LayOutError, PlanError};
pub use too_fine::TooFine;

use std::error::Error;
use std::fmt;

use crate::document::DocumentError;
use crate::synth::watch::Cancelled;

/// The reason why a document was not grown. Every message except that of a cancellation names the file and the place in it.
#[derive(Debug)]
pub enum GrowError {
    /// The document is not valid.
    Document(DocumentError),
    /// One of its layers does not grow.
    Layer {
        /// The name of the document in messages, such as its path.
        file: String,
        /// 1 = the lowest.
        layer: usize,
        /// Why.
        reason: Box<LayerError>,
    },
    /// The growth was cancelled.
    Cancelled(Cancelled),
}

impl GrowError {
    /// Whether the error depends on the growth, so that no plan shows it.
    #[must_use]
    pub fn is_shown_by_growing(&self) -> bool {
        matches!(self, Self::Layer { reason, .. } if reason.is_shown_by_growing())
    }
}

impl fmt::Display for GrowError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Document(error) => error.fmt(f),
            Self::Layer { file, layer, reason } => write!(f, "{file}: layer {layer} {reason}"),
            Self::Cancelled(cancelled) => cancelled.fmt(f),
        }
    }
}

impl Error for GrowError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Document(error) => error.source(),
            // The message contains the reason already.
            Self::Layer { reason, .. } => match &**reason {
                LayerError::Plan(error) => error.source(),
                _ => None,
            },
            Self::Cancelled(_) => None,
        }
    }
}

impl From<DocumentError> for GrowError {
    fn from(error: DocumentError) -> Self {
        Self::Document(error)
    }
}

impl From<Cancelled> for GrowError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}
