//! Parameters with the distance of marks.

use crate::learn::{Answer, Parameters};

/// Parameters that grow some attributes, without the predicted attributes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Parameters in cells.
    pub parameters: Parameters,
    /// Distance at which marks begin ÷ the system's own distance.
    pub pitch: f64,
}

impl Setting {
    /// The setting of an answer.
    #[must_use]
    pub fn of(answer: &Answer) -> Self {
        Self { parameters: answer.parameters, pitch: answer.pitch }
    }
}
