//! The reaction-diffusion systems, one file each. A new one is a file with its [`Definition`](super::Definition), a line
//! in [`System::ALL`], with which the list of all systems (`document::systems`) begins, and its training files.

pub mod meinhardt_lines;
pub mod meinhardt_spots;
pub mod meinhardt_stripes;
pub mod turing_growth;
pub mod turing_spots;

use super::System;
use crate::attributes::system::Description;

/// The rows of a training file.
#[cfg(not(feature = "late-assets"))]
macro_rules! rows {
    ($name:literal) => {
        include_bytes!(concat!(env!("OUT_DIR"), "/", $name, ".rows"))
    };
}
/// No rows: they are brought later.
#[cfg(feature = "late-assets")]
macro_rules! rows {
    ($name:literal) => {
        &[]
    };
}
pub(super) use rows;

/// The training files of these names, compiled in.
macro_rules! embedded {
    ($($name:literal),*) => {
        &[$($crate::attributes::system::TrainingFile {
            name: $name,
            rows: $crate::rd::systems::rows!($name),
        }),*]
    };
}
pub(super) use embedded;

impl System {
    /// All systems, in the order in which they are listed.
    pub const ALL: [Self; 4] =
        [Self::TURING_SPOTS, Self::MEINHARDT_SPOTS, Self::MEINHARDT_STRIPES, Self::MEINHARDT_LINES];

    /// The system of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|system| system.name() == name)
    }

    /// The first of all systems whose description has a property.
    #[must_use]
    pub fn first(property: impl Fn(&Description) -> bool) -> Option<Self> {
        Self::ALL.into_iter().find(|system| property(system.description()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_description_agrees_with_the_definition() {
        for system in System::ALL {
            let (description, definition) = (system.description(), system.definition());
            assert_eq!(description.along_curves, definition.along_curves.is_some(), "{system:?}");
            assert_eq!(description.irregular, definition.decay_noise.is_some(), "{system:?}");
            assert_eq!(description.is_striped(), definition.spots.is_none(), "{system:?}");
        }
    }
}
