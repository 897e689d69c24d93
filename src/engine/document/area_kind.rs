//! What grows as areas: marks with outlines of their own, each with its place.

use crate::attributes::system::Description;
use crate::points::patches::PATCHES;
use crate::rd::pairs::polygons::POLYGONS;

/// What a layer of areas grows.
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

    /// What the rest of the program has to know of it.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Patches => &PATCHES,
            Self::Polygons => &POLYGONS,
        }
    }
    /// The one that a description is of.
    #[must_use]
    pub fn of(description: &Description) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.description() == description)
    }
}
