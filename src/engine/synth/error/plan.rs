//! The reasons why a layer cannot be planned.

use crate::learn::{AskError, TrainingError};
use crate::synth::error::curves::CurvesError;

/// The reason why parameters could not be looked up.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// A training set could not be read.
    #[error(transparent)]
    Training(#[from] TrainingError),
    /// No training set answers the question.
    #[error(transparent)]
    Ask(#[from] AskError),
    /// A system whose parameters follow from laws.
    #[error("{name} is not looked up mark by mark: its parameters follow from the marks of a whole layer")]
    Untrained {
        /// The system.
        name: &'static str,
    },
}

/// The reason why a layer could not be laid out among the marks of the layers beneath.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LayOutError {
    /// None of the layer's marks fits between the marks of the layers beneath.
    #[error("no room between the marks of the layers beneath")]
    NoRoom,
    /// Its lines find no room, or no marks to run around.
    #[error(transparent)]
    Curves(#[from] CurvesError),
}
