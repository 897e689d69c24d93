//! What grows as lines of scattered points.

use crate::attributes::system::Description;
use crate::points::lines::{CRACKS, STREAKS};

/// What a layer of such lines grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LineKind {
    /// Ragged stripes with ends.
    Streaks,
    /// A net.
    Cracks,
}

impl LineKind {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Streaks, Self::Cracks];

    /// What the rest of the program has to know of it.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Streaks => &STREAKS,
            Self::Cracks => &CRACKS,
        }
    }
    /// The one that a description is of.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
