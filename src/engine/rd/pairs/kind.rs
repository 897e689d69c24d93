//! The kinds of systems of pairs.

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
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Weave, Self::Maze, Self::Stripes, Self::Stucco];

    /// The properties of the kind that the rest of the program uses.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Weave => &WEAVE,
            Self::Maze => &MAZE,
            Self::Stripes => &PAIR_STRIPES,
            Self::Stucco => &STUCCO,
        }
    }

    /// The kind with this description; `None` if the description is not one of pairs.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
