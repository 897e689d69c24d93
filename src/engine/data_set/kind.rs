//! The kinds of textures in a data set.

/// A kind of texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Ellipses of any aspect.
    Spots,
    /// Beans, bars and drops.
    IrregularSpots,
    /// Stripes that follow the drawn directions; few end.
    Stripes,
    /// Stripes that end and fork.
    PairStripes,
    /// Dots and worms.
    Stucco,
    /// Blotches with ragged edges.
    Patches,
    /// Cells side by side.
    Cells,
}

impl Kind {
    /// All kinds, in the order in which a data set goes through them.
    pub const ALL: [Self; 7] = [
        Self::Spots,
        Self::IrregularSpots,
        Self::Stripes,
        Self::PairStripes,
        Self::Stucco,
        Self::Patches,
        Self::Cells,
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spots => "spots",
            Self::IrregularSpots => "irregular-spots",
            Self::Stripes => "stripes",
            Self::PairStripes => "pair-stripes",
            Self::Stucco => "stucco",
            Self::Patches => "patches",
            Self::Cells => "cells",
        }
    }

    /// The kind of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether its marks have a width and no aspect.
    #[must_use]
    pub fn is_striped(self) -> bool {
        matches!(self, Self::Stripes | Self::PairStripes | Self::Stucco)
    }

    /// Whether its marks have a direction.
    #[must_use]
    pub fn has_direction(self) -> bool {
        self != Self::Stucco
    }

    /// Whether the ends and forks of its marks are labelled.
    #[must_use]
    pub fn has_tips(self) -> bool {
        matches!(self, Self::Stripes | Self::PairStripes)
    }
}
