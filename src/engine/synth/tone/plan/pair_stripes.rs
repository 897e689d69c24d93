//! Pair stripes that a picture drives: one pair with a direction and a size at each cell.

use rayon::prelude::*;

use crate::rd::pairs::{Blurs, PairField, PairMaps, PairModel};
use crate::synth::pairs::plan::stripes;
use crate::synth::tone::plan::TonePlan;

/// Distance of the lines ÷ that which is asked for: forks and tips cost details, and so much nearer lines make up for them (`facts.md` V).
const CLOSER: f64 = 0.93;

impl TonePlan {
    /// Directions and sizes of the pair at each cell.
    pub(super) fn pair_maps(&self) -> PairMaps {
        let usual = stripes::size_of_period(CLOSER * self.wavelength / self.px_a_cell());
        let pair = PairField {
            direction: self.directions.par_iter().map(|(direction, _)| *direction as f32).collect(),
            size: self.factors.par_iter().map(|factor| (usual * f64::from(*factor)) as f32).collect(),
            blurs: Blurs::Along(stripes::elongation()),
        };
        PairMaps { grid: self.grid, pairs: vec![pair], obstacles: Vec::new(), raised: Vec::new() }
    }
}

/// The reaction, for a pair of these `maps`.
#[must_use]
pub fn pair_model(maps: &PairMaps) -> PairModel {
    stripes::model(maps)
}
