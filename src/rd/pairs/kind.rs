//! What systems of pairs are called, and what they grow.

use crate::attributes::system::{Description, MarkKind, Scaling};

/// A use of systems of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PairKind {
    /// Threads of two to five directions that cross.
    Weave,
}

impl PairKind {
    /// All of them.
    pub const ALL: [Self; 1] = [Self::Weave];

    /// What the rest of the program has to know of it.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Weave => &WEAVE,
        }
    }
}

/// Threads follow from laws, see [`Threads`](super::Threads), so that there are no training rows.
static WEAVE: Description = Description {
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
