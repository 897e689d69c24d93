//! Parameters with the distance of marks.

use crate::learn::{Answer, Parameters};

/// What grows attributes, without what it is predicted to grow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Parameters in cells.
    pub parameters: Parameters,
    /// How many times farther apart than the system's own distance marks begin.
    pub pitch: f64,
}

impl Setting {
    /// The setting of an answer.
    #[must_use]
    pub fn of(answer: &Answer) -> Self {
        Self { parameters: answer.parameters, pitch: answer.pitch }
    }
}
