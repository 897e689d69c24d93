//! The systems that a picture or Turing's growth drives.

use crate::attributes::system::Description;
use crate::rd::System;
use crate::rd::pairs::PairKind;
use crate::synth::memory;

/// A system that a picture or Turing's growth drives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToneSystem {
    /// Meinhardt's stripes or spots, or Turing's growth.
    Of(System),
    /// Stripes of one pair of morphogens.
    PairStripes,
}

impl ToneSystem {
    /// The properties of the system that the rest of the program uses.
    #[must_use]
    pub fn description(self) -> &'static Description {
        match self {
            Self::Of(system) => system.description(),
            Self::PairStripes => PairKind::Stripes.description(),
        }
    }

    /// Its name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.description().name
    }

    /// Whether it grows stripes.
    #[must_use]
    pub fn is_striped(self) -> bool {
        match self {
            Self::Of(system) => system.is_striped(),
            Self::PairStripes => true,
        }
    }

    /// The usual parameter G; `None` for systems without it.
    #[must_use]
    pub fn usual_g(self) -> Option<f32> {
        match self {
            Self::Of(system) => system.usual_g(),
            Self::PairStripes => None,
        }
    }

    /// The letters or names of its chemicals, in order.
    #[must_use]
    pub fn chemicals(self) -> Vec<&'static str> {
        match self {
            Self::Of(system) => system.chemicals().to_vec(),
            Self::PairStripes => vec!["C1+", "C1-"],
        }
    }

    /// Bytes for a growth on `grid` cells for a canvas of `size` px, without those for the picture.
    #[must_use]
    pub fn needed(self, size: [f64; 2], grid: [usize; 2]) -> f64 {
        match self {
            Self::Of(system) => memory::needed(system, size, grid),
            Self::PairStripes => memory::needed_by_pairs(1, size, grid),
        }
    }
}
