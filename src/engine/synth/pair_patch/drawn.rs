//! The drawn marks of a patch, as numbers.

use crate::document::LayerOptions;

/// The drawn marks of a patch; numbers that a system does not have are not used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// Number of directions.
    pub directions: usize,
    /// Width ÷ period.
    pub duty: f64,
    /// Width ÷ period of the other directions of a weave.
    pub others: f64,
    /// Period of the others ÷ that of the first direction.
    pub unequal: f64,
    /// Angle between two directions, degrees.
    pub between: f64,
    /// The first direction, degrees.
    pub angle: f64,
    /// Length of the lines of a maze ÷ their period.
    pub long: f64,
    /// Threshold of the edges of a maze ÷ the value at which the reaction is one half.
    pub level: f64,
    /// Decay of stucco.
    pub decay: f64,
    /// √area of a cell ÷ the width of the lines.
    pub sparse: f64,
    /// Aspect of a cell.
    pub aspect: f64,
}

impl Default for Drawn {
    fn default() -> Self {
        Self {
            directions: 2,
            duty: LayerOptions::DUTY,
            others: LayerOptions::DUTY,
            unequal: 1.0,
            between: 90.0,
            angle: 0.0,
            long: 4.0,
            level: 1.0,
            decay: LayerOptions::default().decay,
            sparse: 5.0,
            aspect: 0.7,
        }
    }
}
