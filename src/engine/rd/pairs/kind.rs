//! What systems of pairs grow.

use super::maze::MAZE;
use super::pair_stripes::PAIR_STRIPES;
use super::stucco::STUCCO;
use super::weave::WEAVE;
use crate::attributes::system::Description;

/// A use of systems of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PairKind {
    /// Threads of two to five directions that cross.
    Weave,
    /// Straight pieces of two to five directions that do not cross.
    Maze,
    /// Lines of one direction that end in tips.
    Stripes,
    /// Blotches and worms without a direction.
    Stucco,
}

impl PairKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Weave, Self::Maze, Self::Stripes, Self::Stucco];

    /// What the rest of the program has to know of it.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Weave => &WEAVE,
            Self::Maze => &MAZE,
            Self::Stripes => &PAIR_STRIPES,
            Self::Stucco => &STUCCO,
        }
    }

    /// The one that a description is of.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
