//! Answers of the training sets to the questions of one layer. Many questions are the same: an answer takes 0.1 ms, and is
//! remembered.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use crate::attributes::{Attributes, Spots, Stripes};
use crate::learn::{Answer, Found};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::lookup::{ALONE, Setting, ask_in_cells, exact_cell, find_in_cells, on_grid};
use crate::synth::training::Training;

/// The kind and the numbers of a question, as bits.
type Question = (System, [u64; 5]);

/// The answers so far.
pub struct Answers<'a> {
    training: &'a Training,
    known: Mutex<HashMap<Question, Answer>>,
    settings: Mutex<HashMap<Question, Setting>>,
}

impl<'a> Answers<'a> {
    /// None yet.
    #[must_use]
    pub fn new(training: &'a Training) -> Self {
        Self { training, known: Mutex::default(), settings: Mutex::default() }
    }

    /// How many different questions were asked.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).len()
    }

    /// As [`super::lookup::ask`].
    ///
    /// # Errors
    /// As there.
    pub fn ask(&self, system: System, wanted: &Attributes, cell: f64) -> Result<Answer, PlanError> {
        let exact = exact_cell(system, wanted, cell);
        let asked = wanted.scaled(1.0 / exact);
        let question = (system, bits(&asked));
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner).get(&question).cloned();
        let answer = match known {
            Some(answer) => answer,
            None => {
                let answer = ask_in_cells(self.training, system, &asked)?;
                let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
                known.insert(question, answer.clone());
                answer
            }
        };
        Ok(on_grid(answer, cell, exact))
    }

    /// What [`Self::ask`] answers with, without what it is predicted to grow.
    ///
    /// # Errors
    /// As there.
    pub fn setting(&self, system: System, wanted: &Attributes, cell: f64) -> Result<Setting, PlanError> {
        let exact = exact_cell(system, wanted, cell);
        let asked = wanted.scaled(1.0 / exact);
        let question = (system, bits(&asked));
        let answered =
            self.known.lock().unwrap_or_else(PoisonError::into_inner).get(&question).map(Setting::of);
        let settings = || self.settings.lock().unwrap_or_else(PoisonError::into_inner);
        let known = answered.or_else(|| settings().get(&question).copied());
        let setting = match known {
            Some(setting) => setting,
            None => {
                let Found { parameters, pitch, .. } = find_in_cells(self.training, system, &asked)?;
                let setting = Setting { parameters, pitch };
                settings().insert(question, setting);
                setting
            }
        };
        Ok(setting.on_grid(cell, exact))
    }

    /// As [`Self::ask`], on a canvas where some spots stand alone: others do, too, where they have the room. Otherwise the
    /// parameters between dense and sparse regions would be those of the sparsest packed spots, which take twenty times the
    /// steps.
    ///
    /// # Errors
    /// As [`Self::ask`].
    pub fn ask_among_sparse(
        &self,
        system: System,
        wanted: &Attributes,
        cell: f64,
    ) -> Result<Answer, PlanError> {
        match self.ask_alone(system, wanted, cell)? {
            Some(answer) => Ok(answer),
            None => self.ask(system, wanted, cell),
        }
    }

    /// What [`Self::ask_among_sparse`] answers with.
    ///
    /// # Errors
    /// As [`Self::ask`].
    pub fn setting_among_sparse(
        &self,
        system: System,
        wanted: &Attributes,
        cell: f64,
    ) -> Result<Setting, PlanError> {
        match self.ask_alone(system, wanted, cell)? {
            Some(answer) => Ok(Setting::of(&answer)),
            None => self.setting(system, wanted, cell),
        }
    }

    /// How spots that stand alone grow; `None` where they are too near to each other for that.
    fn ask_alone(&self, system: System, wanted: &Attributes, cell: f64) -> Result<Option<Answer>, PlanError> {
        let exact = exact_cell(system, wanted, cell);
        let apart = self.training.set(system)?.ask_apart(&wanted.scaled(1.0 / exact), 1.0)?;
        Ok(apart.filter(|answer| answer.pitch >= ALONE).map(|answer| on_grid(answer, cell, exact)))
    }
}

/// The numbers of a question as bits; those that it leaves free have bits of their own.
fn bits(asked: &Attributes) -> [u64; 5] {
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
    use crate::synth::marks::plan::lookup::{ask, cell_for};

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
                    let [first, again] =
                        [(); 2].map(|()| answers.ask(system, &wanted, cell).expect("an answer"));
                    let expected = ask(training, system, &wanted, cell).expect("an answer");
                    assert_eq!(first.parameters, expected.parameters);
                    // Of a question that was answered, and of one that was not.
                    for answers in [&answers, &Answers::new(training)] {
                        let setting = answers.setting(system, &wanted, cell).expect("a setting");
                        assert_eq!(setting, Setting::of(&expected), "{wanted:?}");
                    }
                    assert_eq!(
                        (again.parameters, again.predicted),
                        (expected.parameters, expected.predicted)
                    );
                }
            }
        }
    }
}
