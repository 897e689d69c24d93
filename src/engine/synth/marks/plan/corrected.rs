//! The third stage of a plan: its questions, corrected by the results of probes.

use crate::marks::Ellipse;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Ask;
use crate::synth::marks::plan::lattice::Lattice;
use crate::synth::marks::plan::layer_lookup::{Lookup, Start, of_marks};
use crate::synth::marks::plan::offset::{Correction, Offset};
use crate::synth::training::Training;

/// Looked-up parameters, corrected.
#[derive(Clone, Debug)]
pub struct Corrected {
    pub(super) lookup: Lookup,
    /// Corrections by region.
    pub(super) corrections: Vec<Correction>,
}

impl Lookup {
    /// The lookup without corrections.
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
    /// These corrections with the errors `found` in each region subtracted, too.
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
        let cell = lookup.px_a_cell();
        let offsets: Vec<Offset> = corrections.iter().map(|correction| correction.offset).collect();
        let all = lookup.answers_of(training);
        let ask: Ask = &|wanted, cell| all.ask(lookup.system, wanted, cell);
        let lattice = Lattice::looked_up((&lookup.map, lookup.polarity), cell, &offsets, ask)?;
        let mut answers = lookup.answers.clone();
        for ((answer, wanted), offset) in answers.iter_mut().zip(&lookup.wanted_lines()).zip(&offsets) {
            let mut corrected = ask(&offset.applied(-1.0, wanted), cell)?.predict();
            corrected.predicted = offset.applied(1.0, &corrected.predicted);
            answer.parameters = corrected.parameters;
            answer.predicted = of_marks(lookup.polarity, corrected).predicted;
        }
        if let Start::Free { spots, .. } = &lookup.start {
            let ellipses: Vec<(usize, Ellipse)> =
                spots.iter().map(|spot| (spot.mark, spot.ellipse)).collect();
            let corners = |point| lookup.map.layout().corners(point);
            let offset = |point| {
                let sum = |sum: Offset, (region, weight): (usize, f64)| sum.plus(weight, offsets[region]);
                corners(point).into_iter().fold(Offset::default(), sum)
            };
            let again = lookup.drawn_spots(training, &ellipses, &offset)?;
            if let Start::Free { spots, .. } = &mut lookup.start {
                *spots = again;
            }
        }
        (lookup.lattice, lookup.answers) = (lattice, answers);
        Ok(())
    }
}
