//! Kinds of areas: marks that each have an outline of their own and a given place.

use crate::attributes::system::Description;
use crate::points::patches::PATCHES;
use crate::rd::pairs::polygons::POLYGONS;

/// The kinds of areas that a layer can grow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AreaKind {
    /// Patches of scattered points.
    Patches,
    /// Polygons side by side, parted by lines: the system "cells".
    Polygons,
}

impl AreaKind {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Patches, Self::Polygons];

    /// The properties of the kind that the rest of the program uses.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Patches => &PATCHES,
            Self::Polygons => &POLYGONS,
        }
    }
    /// The kind with this description; `None` if the description is not one of areas.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
