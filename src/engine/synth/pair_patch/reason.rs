//! Reasons why a patch is not used as training data.

/// The reason why a patch is not used as training data.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairReason {
    /// Nothing grew.
    #[error("no pattern: {0}")]
    Blank(String),
    /// The lines are not as they were drawn.
    #[error("the {what} is {got:.2} times what was drawn")]
    Blotchy {
        /// The property that differs.
        what: &'static str,
        /// Grown value ÷ drawn value.
        got: f64,
    },
    /// Lines have gaps: they are farther apart than drawn.
    #[error("lines are broken: they are {got:.2} times as far apart as drawn")]
    Broken {
        /// Grown period ÷ drawn period.
        got: f64,
    },
    /// Lines of a direction died.
    #[error("the direction {angle:.0}° died")]
    LostDirection {
        /// The direction, degrees.
        angle: f64,
    },
    /// Too few lines or cells to take means over.
    #[error("{found:.1} periods or cells are too few, at least {least} are needed")]
    TooFew {
        /// Periods along a side, or cells.
        found: f64,
        /// The least number.
        least: f64,
    },
    /// Cells merged.
    #[error("{own} of {laid} cells have an area of their own")]
    Merged {
        /// Cells with an area of their own.
        own: usize,
        /// Cells that were laid.
        laid: usize,
    },
}

impl PairReason {
    /// All values of [`Self::kind`].
    pub const KINDS: [&'static str; 6] =
        ["no-pattern", "too-few", "blotchy", "broken", "lost-direction", "merged"];

    /// The reason in one word, for counting.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        let [no_pattern, too_few, blotchy, broken, lost, merged] = Self::KINDS;
        match self {
            Self::Blank(_) => no_pattern,
            Self::TooFew { .. } => too_few,
            Self::Blotchy { .. } => blotchy,
            Self::Broken { .. } => broken,
            Self::LostDirection { .. } => lost,
            Self::Merged { .. } => merged,
        }
    }
}
