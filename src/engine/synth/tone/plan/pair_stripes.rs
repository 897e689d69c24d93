//! Pair stripes that a picture drives: one pair with a direction and a size at each cell.

use rayon::prelude::*;

use crate::grid::Domain;
use crate::rd::pairs::work::{Sizes, updates};
use crate::rd::pairs::{Blurs, PairField, PairModel, PairParameterField};
use crate::synth::pairs::plan::{FROM_NOISE, RATIO, stripes};
use crate::synth::tone::plan::TonePlan;

/// Factor of the distance of the lines that is asked for: forks and tips lose details, and closer lines compensate for it
/// (`facts.md` V).
const CLOSER: f64 = 0.93;

impl TonePlan {
    /// The size of the pair at the usual distance, cells.
    fn usual_size(&self) -> f64 {
        stripes::size_of_period(CLOSER * self.wavelength / self.px_a_cell())
    }

    /// Updates of one morphogen in one cell during a growth whose distances ÷ the usual one are between these factors.
    pub(super) fn updates_of_pair_between(&self, factors: [f64; 2]) -> f64 {
        let range = factors.map(|factor| factor * self.usual_size());
        let pair = Sizes { range, blurs: Blurs::Along(stripes::elongation()) };
        updates(self.grid.cells() as f64, &[pair], f64::from(RATIO), FROM_NOISE, true)
    }

    /// Directions and sizes of the pair at each cell.
    pub(super) fn pair_maps(&self) -> PairParameterField {
        let usual = self.usual_size();
        let pair = PairField {
            direction: self.directions.par_iter().map(|(direction, _)| *direction as f32).collect(),
            size: self.factors.par_iter().map(|factor| (usual * f64::from(*factor)) as f32).collect(),
            blurs: Blurs::Along(stripes::elongation()),
        };
        PairParameterField { grid: self.grid, pairs: vec![pair], obstacles: Vec::new(), raised: Vec::new() }
    }
}

/// The reaction, for a pair of these `maps`.
#[must_use]
pub fn pair_model(maps: &PairParameterField) -> PairModel {
    stripes::model(maps.least_size())
}
