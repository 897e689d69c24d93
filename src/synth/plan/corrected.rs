//! Third stage of a plan: its questions corrected by what probes have found.

use crate::attributes::Attributes;
use crate::synth::plan::error::PlanError;
use crate::synth::plan::lattice::Lattice;
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::plan::lookup::{ask, ask_among_sparse};
use crate::synth::plan::offset::{Correction, Offset};
use crate::synth::training::Training;

/// Looked-up parameters, corrected.
#[derive(Clone, Debug)]
pub struct Corrected {
    pub(super) lookup: Lookup,
    /// By region.
    pub(super) corrections: Vec<Correction>,
}

impl Lookup {
    /// The parameters as they were looked up.
    #[must_use]
    pub fn uncorrected(self) -> Corrected {
        let corrections = vec![Correction::default(); self.answers.len()];
        Corrected { lookup: self, corrections }
    }

    /// The parameters corrected by region.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn corrected(
        self,
        training: &Training,
        corrections: Vec<Correction>,
    ) -> Result<Corrected, PlanError> {
        let mut corrected = Corrected { lookup: self, corrections };
        if corrected.corrections.iter().any(|correction| correction.growths > 0) {
            corrected.ask_again(training)?;
        }
        Ok(corrected)
    }
}

impl Corrected {
    /// The same with `found` subtracted, too: by how much what has grown was off, by region.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub(super) fn less(mut self, training: &Training, found: &[Offset]) -> Result<Self, PlanError> {
        for (correction, found) in self.corrections.iter_mut().zip(found) {
            correction.offset = correction.offset.plus(1.0, *found);
        }
        self.ask_again(training)?;
        Ok(self)
    }

    /// Looks up the corrected questions.
    fn ask_again(&mut self, training: &Training) -> Result<(), PlanError> {
        let Self { lookup, corrections } = self;
        let (cell, system) = (lookup.px_a_cell(), lookup.system);
        let asked =
            if lookup.answers.iter().any(|answer| answer.pitch > 1.0) { ask_among_sparse } else { ask };
        let ask = |wanted: &Attributes, cell| asked(training, system, wanted, cell);
        let offsets: Vec<Offset> = corrections.iter().map(|correction| correction.offset).collect();
        lookup.lattice = Lattice::looked_up(&lookup.map, cell, &offsets, &ask)?;
        let wanted = lookup.wanted();
        for ((answer, wanted), offset) in lookup.answers.iter_mut().zip(&wanted).zip(&offsets) {
            let corrected = ask(&offset.applied(-1.0, wanted), cell)?;
            answer.parameters = corrected.parameters;
            answer.predicted = offset.applied(1.0, &corrected.predicted);
        }
        Ok(())
    }
}
