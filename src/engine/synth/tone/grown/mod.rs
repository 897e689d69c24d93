//! The grown layer of a picture or of Turing's growth.
//!
//! ```text
//!  marks that have grown ─▶ relief ─▶ levels, by px: the local share of ink is the tone ─▶ pattern
//! ```

mod levels;
mod measure;
mod pattern;
mod relief;
mod slopes;

pub use levels::levels;
pub use measure::{ToneErrors, compared, measure};
pub use pattern::{Levels, TonePattern};
pub use relief::relief;
pub use slopes::gains;

use crate::grid::Field;
use crate::synth::tone::plan::TonePlan;

/// The grown layer of a picture or of Turing's growth.
#[derive(Clone)]
pub struct GrownTone {
    /// The plan from which it grew.
    pub plan: TonePlan,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
    /// The relief of the grown pattern, on the grid.
    pub relief: Field,
    /// The threshold of the relief at the edges of marks, over the canvas.
    pub levels: Field,
    /// Factors by which the heights above and below the threshold are stretched, so that no edge is blurred.
    pub gains: Field,
    /// The share of the canvas that is ink.
    pub ink: f64,
    /// Errors against the picture, if one drives it.
    pub measured: Option<ToneErrors>,
    /// The concentrations of each chemical on the grid, if the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
}

impl GrownTone {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> TonePattern<'_> {
        TonePattern::new(&self.relief, Levels::Each { levels: &self.levels, gains: &self.gains })
    }
}
