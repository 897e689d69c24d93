//! The list of all systems. A new one is a file with its description, a line here and a training set; a system of reaction and
//! diffusion has its line in [`System::ALL`], with which this list begins.

use crate::attributes::system::{Description, LookupBy};
use crate::points::lines::{CRACKS, STREAKS};
use crate::rd::System;
use crate::rd::pairs::PairKind;

pub use crate::points::fields::POINTS;
pub use crate::points::patches::PATCHES;
pub use crate::rd::pairs::polygons::POLYGONS;

/// Turing's system whose parameter G varies over the canvas.
pub const TURING_GROWTH: &Description = System::with_growth().description();

/// The systems after the ones of [`System::ALL`].
const OTHERS: &[&Description] = &[
    PairKind::Weave.description(),
    PairKind::Maze.description(),
    PairKind::Stripes.description(),
    PairKind::Stucco.description(),
    &PATCHES,
    &POLYGONS,
    &STREAKS,
    &CRACKS,
    &POINTS,
    TURING_GROWTH,
    #[cfg(test)]
    &made_up_tests::MADE_UP,
];

/// The descriptions of all systems, in the order in which they are listed.
pub static SYSTEMS: [&Description; System::ALL.len() + OTHERS.len()] = {
    let (first, mut all) = (System::ALL.len(), [TURING_GROWTH; System::ALL.len() + OTHERS.len()]);
    let mut index = 0;
    while index < all.len() {
        all[index] = if index < first { System::ALL[index].description() } else { OTHERS[index - first] };
        index += 1;
    }
    all
};

/// The system of this name.
#[must_use]
pub fn named(name: &str) -> Option<&'static Description> {
    SYSTEMS.iter().copied().find(|system| system.name == name)
}

/// The systems whose training rows are of simulations with parameters that were drawn.
pub fn of_parameters() -> impl Iterator<Item = &'static Description> {
    SYSTEMS.iter().copied().filter(|system| matches!(system.lookup, LookupBy::Rows))
}

/// The systems of pairs, whose training rows hold the errors of their laws.
pub fn of_pairs() -> impl Iterator<Item = &'static Description> {
    SYSTEMS.iter().copied().filter(|system| matches!(system.lookup, LookupBy::Pairs(_)))
}

#[cfg(test)]
mod made_up_tests;
#[cfg(test)]
mod tests;
