//! What systems of pairs are called, and what they grow.

use crate::attributes::pair_columns;
use crate::attributes::system::{Description, MarkKind, Scaling};
use crate::rd::systems::embedded;

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
            Self::Stripes => &STRIPES,
            Self::Stucco => &STUCCO,
        }
    }
}

/// What differs from a weave.
static MAZE: Description = Description {
    name: "maze",
    title: "Maze",
    help: "Straight pieces of the drawn directions that meet and never cross, two to five directions",
    columns: &pair_columns::MAZE,
    training: embedded!["maze"],
    ..THREADS
};

/// What differs from a weave.
static STRIPES: Description = Description {
    name: "pair-stripes",
    title: "Stripes with tips",
    help: "Stripes of one direction from noise, which end in tips and begin anew",
    tone: true,
    columns: &pair_columns::PAIR_STRIPES,
    training: embedded!["pair-stripes"],
    ..THREADS
};

/// What differs from a weave.
static STUCCO: Description = Description {
    name: "stucco",
    title: "Stucco",
    help: "Dots and worms without a direction, as wide as the drawn marks",
    option_keys: &["decay"],
    columns: &pair_columns::STUCCO,
    training: embedded!["stucco"],
    ..THREADS
};

/// Threads follow from laws, see [`Threads`](super::Threads); training rows say how far these are off.
static WEAVE: Description = Description {
    option_keys: &["duty", "over"],
    columns: &pair_columns::WEAVE,
    training: embedded!["weave"],
    ..THREADS
};

/// What all kinds share, with the names of a weave.
const THREADS: Description = Description {
    name: "weave",
    title: "Weave",
    help: "Threads along lines that cross, two to five directions in one place",
    alternative: None,
    marks: MarkKind::Stripes,
    free_spacing: true,
    irregular: false,
    seeding: false,
    fixed_places: false,
    along_curves: false,
    tone: false,
    option_keys: &["duty"],
    columns: &[],
    training: &[],
    neighbours: &[],
    scaling: Scaling { ratio: 0.0, level: 0.0 },
    isolated: None,
};
