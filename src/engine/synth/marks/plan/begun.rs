//! Last stage of a plan: where its marks begin, one by one or by their distance. Nothing of it changes while the layer grows.

use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::spacing_correction::pitches;
use crate::synth::marks::plan::spread::{VariedSpots, vary};

/// A finished plan.
#[derive(Clone, Debug)]
pub struct Begun {
    /// Parameters, obstacles, and how marks are arranged.
    pub plan: Plan,
    /// Where marks begin.
    pub nuclei: Nuclei,
}

/// Where the marks of a layer begin.
#[derive(Clone, Debug)]
pub enum Nuclei {
    /// At the places of spots with parameters of their own.
    Spots(VariedSpots),
    /// Where the system puts them, or at the given places of the plan: so many times as far apart as the system's own distance, by region.
    Apart(Vec<f64>),
}

impl Plan {
    /// Lays the nuclei of its marks: as far apart, and as different, as they end as asked. `seed` decides where.
    #[must_use]
    pub fn begin(self, seed: u64) -> Begun {
        let nuclei = match vary(&self, seed) {
            Some(spots) => Nuclei::Spots(spots),
            None => Nuclei::Apart(pitches(&self, seed)),
        };
        Begun { plan: self, nuclei }
    }
}
