//! The pattern of a layer of any kind.

use std::ops::Range;

use crate::grid::Field;
use crate::synth::grow::areas::AreaPattern;
use crate::synth::grow::pairs::PairPattern;
use crate::synth::grow::pattern::Pattern;
use crate::synth::grow::tone::TonePattern;

/// The pattern of a layer: 0 = ground, ½ = an edge, 1 = the middle of a mark.
pub enum LayerPattern<'a> {
    /// Spots or stripes.
    Marks(Pattern<'a>),
    /// What pairs have grown.
    Pairs(PairPattern),
    /// Patches, cells, streaks, cracks or a field of points.
    Areas(AreaPattern),
    /// What a picture drives.
    Tone(TonePattern<'a>),
}

impl LayerPattern<'_> {
    /// Cells along x and y of the grid that it grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        match self {
            Self::Marks(pattern) => pattern.grid(),
            Self::Pairs(pattern) => pattern.grid(),
            Self::Areas(pattern) => pattern.grid(),
            Self::Tone(pattern) => pattern.grid(),
        }
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        match self {
            Self::Marks(pattern) => pattern.rows(rows, width, height),
            Self::Pairs(pattern) => pattern.rows(rows, width, height),
            Self::Areas(pattern) => pattern.rows(rows, width, height),
            Self::Tone(pattern) => pattern.rows(rows, width, height),
        }
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        match self {
            Self::Marks(pattern) => pattern.field(width, height),
            Self::Pairs(pattern) => pattern.field(width, height),
            Self::Areas(pattern) => pattern.field(width, height),
            Self::Tone(pattern) => pattern.field(width, height),
        }
    }
}
