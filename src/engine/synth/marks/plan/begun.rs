//! The last stage of a plan: where its marks begin, one by one or by their distance. It does not change while the layer grows.

use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::spacing_correction::pitches;
use crate::synth::marks::plan::spread::{VariedSpots, vary};

/// A finished plan.
#[derive(Clone, Debug)]
pub struct Begun {
    /// Parameters, obstacles, and how marks are arranged.
    pub plan: Plan,
    /// Starting places of the marks.
    pub nuclei: Nuclei,
}

/// Starting places of the marks of a layer.
#[derive(Clone, Debug)]
pub enum Nuclei {
    /// At the places of spots with parameters of their own.
    Spots(VariedSpots),
    /// At places chosen by the system, or at the given places of the plan. The factors of the system's own distance, by region.
    Apart(Vec<f64>),
}

impl Plan {
    /// Lays the nuclei of its marks, so that the distances and the spread of the grown marks are those asked for. `seed` determines
    /// the places.
    #[must_use]
    pub fn begin(self, seed: u64) -> Begun {
        let nuclei = match vary(&self, seed) {
            Some(spots) => Nuclei::Spots(spots),
            None => Nuclei::Apart(pitches(&self, seed)),
        };
        Begun { plan: self, nuclei }
    }
}
