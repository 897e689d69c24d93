//! What ragged edges are made of.

use crate::grid::Field;

/// How the edges of a layer were roughened.
#[derive(Clone, Debug)]
pub struct Ragged {
    /// What was added to the pattern, on a grid over the canvas.
    pub added: Field,
    /// The raggedness that was asked for.
    pub asked: f64,
    /// What was measured, by region; `None` without whole marks.
    pub got: Vec<Option<f64>>,
}
