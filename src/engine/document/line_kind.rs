//! Kinds of lines that are made from scattered points.

use crate::attributes::system::Description;
use crate::points::lines::{CRACKS, STREAKS};

/// The kinds of lines that scattered points can make.
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

    /// The properties of the kind that the rest of the program uses.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Streaks => &STREAKS,
            Self::Cracks => &CRACKS,
        }
    }
    /// The kind with this description; `None` if the description is not one of such lines.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
