//! Data of ragged edges.

use crate::grid::Field;

/// The roughening of the edges of a layer.
#[derive(Clone, Debug)]
pub struct Ragged {
    /// The field that was added to the pattern, on a grid over the canvas.
    pub added: Field,
    /// The raggedness that was asked for.
    pub asked: f64,
    /// The measured raggedness, by region; `None` without whole marks.
    pub got: Vec<Option<f64>>,
}
