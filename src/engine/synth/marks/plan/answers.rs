//! Answers of the training sets to the questions of one layer. An answer takes 0.1 ms, and many questions are repeated, so answers
//! are cached.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::attributes::{Attributes, Spots, Stripes};
use crate::learn::{Found, InCells, Note, TrainingSet};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::asked::Asked;
use crate::synth::marks::plan::cell_size::exact_cell;
use crate::synth::training::Training;

/// Spots that are sparser than the reachable ones by less than this share count as reached.
const TOLERANCE: f64 = 0.02;
/// From this pitch on, spots on a canvas with sparse ones are isolated, with the threshold of single spots.
const ALONE: f64 = 1.7;

/// The kind and the numbers of a question, as bits.
type Question = (System, [u64; 5]);

/// The answers so far.
pub struct Answers<'a> {
    training: &'a Training,
    /// Whether some spots of the layer are isolated: others that have room are then isolated, too. Otherwise the parameters between
    /// dense and sparse regions would be those of the sparsest packed spots, which take twenty times the steps.
    among_sparse: bool,
    known: Mutex<HashMap<Question, Arc<Found>>>,
}

impl<'a> Answers<'a> {
    /// A cache without answers.
    #[must_use]
    pub fn new(training: &'a Training) -> Self {
        Self { training, among_sparse: false, known: Mutex::default() }
    }

    /// These answers, for a layer that has isolated spots if `among_sparse`.
    #[must_use]
    pub fn among_sparse(self, among_sparse: bool) -> Self {
        Self { among_sparse, ..self }
    }

    /// Number of different questions so far.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).len()
    }

    /// A function that looks up attributes (px) for a grid with the given number of px a cell. Spots sparser than those that their
    /// system packs by itself begin farther apart if the system allows it.
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn ask(&self, system: System, wanted: &Attributes, cell: f64) -> Result<Asked<'a>, PlanError> {
        let exact = exact_cell(system, wanted, cell);
        let (set, asked) = (self.training.set(system)?, InCells::from_px(*wanted, exact));
        let alone = if self.among_sparse { set.ask_apart(&asked, 1.0)? } else { None };
        if let Some(alone) = alone.filter(|found| found.pitch >= ALONE) {
            return Ok(Asked::new(set, Arc::new(alone), [exact, cell]));
        }
        let question = (system, bits(&asked));
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let remembered = known().get(&question).cloned();
        let found = match remembered {
            Some(found) => found,
            None => {
                let found = Arc::new(ask_in_cells(set, &asked)?);
                known().entry(question).or_insert(found).clone()
            }
        };
        Ok(Asked::new(set, found, [exact, cell]))
    }

    /// Looks up spots at given places: as isolated spots if the places are far enough apart. `room` is the share of the spacing,
    /// 0..1, that is left to them in the direction in which the places suit their shape least.
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn ask_placed(
        &self,
        system: System,
        wanted: &Attributes,
        room: f64,
        cell: f64,
    ) -> Result<Asked<'a>, PlanError> {
        let exact = exact_cell(system, wanted, cell);
        let (set, asked) = (self.training.set(system)?, InCells::from_px(*wanted, exact));
        let mut found = match set.ask_apart(&asked, room)? {
            Some(found) => found,
            None => set.ask(&asked)?,
        };
        found.notes.0.retain(|note| !matches!(note, Note::Apart { .. }));
        Ok(Asked::new(set, Arc::new(found), [exact, cell]))
    }
}

/// A function that looks up attributes (px) for a grid with the given number of px a cell.
pub(super) type Ask<'f, 'a> = &'f (dyn Fn(&Attributes, f64) -> Result<Asked<'a>, PlanError> + Sync + 'f);

/// The answer to attributes in cells, on a grid that is fine enough that the size of the marks does not matter.
fn ask_in_cells(set: &TrainingSet, asked: &InCells<Attributes>) -> Result<Found, PlanError> {
    let found = set.ask(asked)?;
    let apart = if is_sparser(asked, &found.nearest) { set.ask_apart(asked, 1.0)? } else { None };
    Ok(apart.unwrap_or(found))
}

/// Whether the question is sparser than the reached attributes.
fn is_sparser(InCells(asked): &InCells<Attributes>, InCells(reached): &InCells<Attributes>) -> bool {
    let packing = |attributes: &Attributes| match attributes {
        Attributes::Spots(Spots { area, spacing: Some(spacing), .. }) => Some(area / (spacing * spacing)),
        _ => None,
    };
    packing(asked).zip(packing(reached)).is_some_and(|(asked, reached)| asked < (1.0 - TOLERANCE) * reached)
}

/// The numbers of a question as bits; free attributes have special bits.
fn bits(InCells(asked): &InCells<Attributes>) -> [u64; 5] {
    let free = |length: Option<f64>| length.map_or(u64::MAX, f64::to_bits);
    match *asked {
        Attributes::Spots(Spots { area, aspect, angle, spacing }) => {
            [0, area.to_bits(), aspect.to_bits(), angle.to_bits(), free(spacing)]
        }
        Attributes::Stripes(Stripes { width, angle, wavelength }) => {
            [1, width.to_bits(), angle.to_bits(), free(wavelength), 0]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::marks::plan::cell_size::cell_for;

    #[test]
    fn a_remembered_answer_is_the_answer() {
        let training = Training::built_in();
        let answers = Answers::new(training);
        let spots = |area: f64, spacing: Option<f64>| {
            Attributes::Spots(Spots { area, aspect: 0.7, angle: 30.0, spacing })
        };
        for system in [System::MEINHARDT_SPOTS, System::TURING_SPOTS] {
            for wanted in [spots(90.0, Some(28.0)), spots(90.0, None), spots(120.0, Some(28.0))] {
                let finest = cell_for(system, &wanted);
                for cell in [finest, 0.9 * finest, finest] {
                    let ask = |answers: &Answers| {
                        let asked = answers.ask(system, &wanted, cell).expect("an answer");
                        (asked.setting(), asked.predict().predicted)
                    };
                    assert_eq!(ask(&answers), ask(&Answers::new(training)), "{wanted:?}");
                }
            }
        }
        assert!(answers.count() <= 6 * 2);
    }

    #[test]
    fn spots_with_room_stand_alone_only_among_sparse_ones() {
        let training = Training::built_in();
        let wanted = Attributes::Spots(Spots { area: 90.0, aspect: 0.7, angle: 30.0, spacing: Some(52.0) });
        let cell = cell_for(System::MEINHARDT_SPOTS, &wanted);
        let pitch = |among_sparse| {
            let answers = Answers::new(training).among_sparse(among_sparse);
            answers.ask(System::MEINHARDT_SPOTS, &wanted, cell).expect("an answer").pitch()
        };
        assert!(pitch(false) == 1.0 && pitch(true) >= ALONE, "{} {}", pitch(false), pitch(true));
    }
}
