//! Probes: before the canvas is grown, a small seamless patch is grown to measure the error of the looked-up parameters.
//!
//! The canvas itself cannot correct its parameters: its regions hold few marks, and different ones in every growth (`facts.md` K).
//! A patch holds two hundred of one kind. From the question x and the means m of `n` patches follow the offset of the training set
//! there, and the corrected question:
//!
//! ```text
//! δ = g · mean(mₖ − xₖ)      x₊ = x − δ      g = σ² ÷ (σ² + ν²/n),  σ² = s² − ν₀²
//! ```
//!
//! s is the scatter of the training rows about the question, ν₀ that of rows with equal parameters (random scatter alone), ν that
//! of probes. No probe is grown if s is too small to be seen, or no larger than the random scatter: a full training set needs no
//! correction, but a set with few rows, or a question at its edge, does.

use rayon::prelude::*;

use crate::attributes::{Attribute, Attributes};
use crate::learn::{Answer, Coverage, InCells};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::grow::UPDATES;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::probe_patch::ProbePatch;
use crate::synth::marks::plan::Answers;
use crate::synth::marks::plan::cell_size::exact_cell;
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::marks::plan::offset::{Correction, Offset};
use crate::synth::training::Training;
use crate::synth::watch::{Cancelled, Stage, Watch};

/// Spots on a probe.
const SPOTS: f64 = 200.0;
/// Spots on the patches of the training sets, to which the scatter of equal rows refers.
const TRAINED: f64 = 80.0;
/// Wavelengths along the side of a probe, and of the patches of the training sets.
const WAVELENGTHS: f64 = 20.0;
/// Probes at most.
const GROWTHS: usize = 2;
/// Gains below this do not justify a growth.
const WORTH: f64 = 0.5;
/// Seed of the first probe; the next ones count up.
const SEED: u64 = 0x5eed;

/// The reason why probing ended without a result.
#[derive(Debug, thiserror::Error)]
pub enum ProbeError {
    /// The training set cannot be read.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The probe was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Condition for a probe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum When {
    /// If a probe would be more accurate than the training set.
    #[default]
    Unsure,
    /// Probe always, twice; for comparisons.
    Always,
}

/// Probes each of the questions `wanted` (px) on grids of `cell` px a cell. Equal questions are probed once.
///
/// # Errors
/// The training set cannot be read; or [`Cancelled`].
pub fn probed(
    training: &Training,
    system: System,
    wanted: &[Attributes],
    cell: f64,
    when: When,
    watch: &Watch,
) -> Result<Vec<Correction>, ProbeError> {
    let mut probes = Probes::new(training, system, wanted, cell, when)?;
    while probes.advance(training, UPDATES)?.is_some() {
        watch.step(Stage::Plan, 0.1)?;
    }
    Ok(probes.found())
}

/// Probes that grow side by side.
pub struct Probes {
    /// One probe for each question.
    distinct: Vec<Probe>,
    /// The probe of each region.
    places: Vec<usize>,
}

/// The probe of one question.
struct Probe {
    system: System,
    when: When,
    /// px a cell.
    cell: f64,
    /// The nearest attributes to the question that can be reached.
    goal: Attributes,
    scatter: Offset,
    /// The sum of the errors that were found.
    sum: Offset,
    answer: Answer,
    asked: Attributes,
    found: Correction,
    /// The patch that grows now.
    growing: Option<Engine>,
    done: bool,
}

impl Probes {
    /// The probes of a layer; `None` where its marks stand at given places or along curves.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn of(lookup: &Lookup, training: &Training, when: When) -> Result<Option<Self>, PlanError> {
        if !matches!(lookup.start, Start::Free { .. }) {
            return Ok(None);
        }
        let (wanted, cell) = (lookup.wanted_lines(), lookup.px_a_cell());
        Self::new(training, lookup.system, &wanted, cell, when).map(Some)
    }

    /// The probes of the questions `wanted` (px) on grids of `cell` px a cell, none of which grows yet.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn new(
        training: &Training,
        system: System,
        wanted: &[Attributes],
        cell: f64,
        when: When,
    ) -> Result<Self, PlanError> {
        let mut distinct: Vec<Attributes> = Vec::new();
        let places: Vec<usize> = wanted
            .iter()
            .map(|one| {
                distinct.iter().position(|other| other == one).unwrap_or_else(|| {
                    distinct.push(*one);
                    distinct.len() - 1
                })
            })
            .collect();
        let probe = |one: &Attributes| Probe::new(training, system, one, cell, when);
        let distinct = distinct.par_iter().map(probe).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { distinct, places })
    }

    /// Grows all of them by about `updates` cell updates together. Returns how many were done; `None` = all have ended.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn advance(&mut self, training: &Training, updates: u64) -> Result<Option<u64>, PlanError> {
        let left = self.distinct.iter().filter(|probe| !probe.done).count() as u64;
        if left == 0 {
            return Ok(None);
        }
        let advance = |probe: &mut Probe| probe.advance(training, updates / left);
        self.distinct.par_iter_mut().map(advance).sum::<Result<u64, PlanError>>().map(Some)
    }

    /// The corrections that they have found, by question.
    #[must_use]
    pub fn found(&self) -> Vec<Correction> {
        self.places.iter().map(|place| self.distinct[*place].found.clone()).collect()
    }
}

impl Probe {
    fn new(
        training: &Training,
        system: System,
        wanted: &Attributes,
        cell: f64,
        when: When,
    ) -> Result<Self, PlanError> {
        // The result scales with the size of the marks, and larger ones cost more.
        let cell = exact_cell(system, wanted, cell);
        let answer = Answers::new(training).ask(system, wanted, cell)?.predict();
        // The correction leads to attributes that can be reached.
        let goal = answer.nearest;
        Ok(Self {
            system,
            when,
            cell,
            goal,
            scatter: scatter(&answer),
            sum: Offset::default(),
            // Isolated spots follow a law that is as accurate as a probe.
            done: answer.pitch > 1.0,
            answer,
            asked: goal,
            found: Correction::default(),
            growing: None,
        })
    }

    /// The patch that is grown next.
    fn patch(&self) -> ProbePatch {
        let extent = if self.system.is_striped() { WAVELENGTHS } else { SPOTS };
        let seed = SEED + self.found.growths as u64;
        ProbePatch { system: self.system, parameters: self.answer.parameters, extent, seed }
    }

    /// Grows on by about `updates` cell updates, or measures a grown patch. Returns the number of updates.
    fn advance(&mut self, training: &Training, updates: u64) -> Result<u64, PlanError> {
        if self.done {
            return Ok(0);
        }
        let Some(engine) = &mut self.growing else {
            let gain = self.gain(self.found.growths + 1);
            let ends = self.found.growths == GROWTHS
                || self.when == When::Unsure && !worth(self.system, self.scatter, gain);
            self.done = ends;
            self.growing = (!ends).then(|| self.patch().engine());
            return Ok(1);
        };
        let before = engine.updates();
        if engine.advance(updates) {
            return Ok(engine.updates() - before);
        }
        let (marks, done) = (engine.marks(), engine.updates() - before);
        self.growing = None;
        match self.patch().measure(&marks) {
            Ok(sample) => self.learn(training, &sample.attributes)?,
            Err(_) => self.done = true,
        }
        Ok(done + marks.values.len() as u64)
    }

    /// Uses the attributes that a patch has `got`.
    fn learn(&mut self, training: &Training, got: &InCells<Attributes>) -> Result<(), PlanError> {
        let gain = self.gain(self.found.growths + 1);
        self.found.growths += 1;
        self.sum = self.sum.plus(1.0, Offset::between(&self.asked, &got.in_px(self.cell)));
        let mean = Offset::default().plus(1.0 / self.found.growths as f64, self.sum);
        self.found.offset = mean.zip(gain, |offset, gain| offset * gain);
        let tolerated = self.system.definition().tolerated.into();
        if self.when == When::Unsure && self.found.offset.within(tolerated) {
            self.done = true;
            return Ok(());
        }
        self.asked = self.found.offset.applied(-1.0, &self.goal);
        self.answer = Answers::new(training).ask(self.system, &self.asked, self.cell)?.predict();
        Ok(())
    }

    fn gain(&self, growths: usize) -> Offset {
        gain(self.system, &self.answer, self.scatter, growths, self.when)
    }
}

/// The standard deviation of the training rows about an answer.
fn scatter(answer: &Answer) -> Offset {
    // The interval is that of 90 %.
    let half = |attribute: Attribute, ln: bool| {
        let found = answer.interval.iter().find(|(of, _)| *of == attribute);
        let measure = |end: f64| if ln { libm::log(end) } else { end };
        found.map_or(0.0, |(_, [low, high])| 0.5 * (measure(*high) - measure(*low)) / 1.645)
    };
    match answer.predicted {
        Attributes::Spots(_) => Offset {
            size: half(Attribute::Area, true),
            spacing: half(Attribute::Spacing, true),
            elongation: half(Attribute::Aspect, true),
            turn: half(Attribute::Angle, false),
        },
        Attributes::Stripes(_) => {
            let spacing = half(Attribute::Wavelength, true);
            Offset {
                size: half(Attribute::Width, true),
                spacing,
                turn: half(Attribute::Angle, false),
                elongation: 0.0,
            }
        }
    }
}

/// Whether an attribute is not known well enough, and a probe would measure it.
fn worth(system: System, scatter: Offset, gain: Offset) -> bool {
    let missing = scatter.zip(Offset::from(system.definition().tolerated), |scatter, tolerated| {
        f64::from(u8::from(scatter > tolerated))
    });
    let gains = missing.zip(gain, |missing, gain| missing * gain);
    [gains.size, gains.spacing, gains.elongation, gains.turn].iter().any(|gain| *gain >= WORTH)
}

/// The share of the offset of `growths` probes that is applied, by attribute.
fn gain(system: System, answer: &Answer, scatter: Offset, growths: usize, when: When) -> Offset {
    if when == When::Always {
        return Offset { size: 1.0, spacing: 1.0, elongation: 1.0, turn: 1.0 };
    }
    let chance = Offset::from(system.definition().scatter);
    let shrunk = if system.is_striped() { 1.0 } else { TRAINED / SPOTS };
    let share = |scatter: f64, chance: f64| {
        let probes = chance * chance * shrunk / growths as f64;
        let map = (scatter * scatter - chance * chance).max(0.0);
        // Outside the range of its rows the error of the set is not known.
        let map = if answer.coverage == Coverage::Inside { map } else { map.max(chance * chance) };
        if chance > 0.0 { map / (map + probes) } else { 0.0 }
    };
    scatter.zip(chance, share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Spots;
    use crate::learn::{Row, TrainingSet};

    const WANTED: Attributes =
        Attributes::Spots(Spots { area: 60.0, aspect: 0.6, angle: 30.0, spacing: Some(25.0) });

    /// The built-in rows of Meinhardt's spots, or every `n`-th of them, areas read `wrong` times too large.
    fn training(n: usize, wrong: f64) -> Training {
        let all = TrainingSet::embedded(System::MEINHARDT_SPOTS.description()).unwrap();
        let spoilt = |row: &Row| {
            let InCells(Attributes::Spots(spots)) = row.attributes else { return *row };
            let attributes = InCells(Attributes::Spots(Spots { area: spots.area * wrong, ..spots }));
            Row { attributes, ..*row }
        };
        let rows = all.rows().iter().step_by(n).map(spoilt).collect();
        Training::from_rows(System::MEINHARDT_SPOTS, rows).unwrap()
    }

    fn probed_by(training: &Training, when: When) -> Correction {
        probed(training, System::MEINHARDT_SPOTS, &[WANTED], 1.0, when, &Watch::NONE).unwrap()[0].clone()
    }

    #[test]
    fn a_complete_training_set_needs_no_correction() {
        assert_eq!(probed_by(&training(1, 1.0), When::Unsure).growths, 0);
    }

    #[test]
    fn a_small_training_set_is_corrected() {
        let all = TrainingSet::embedded(System::MEINHARDT_SPOTS.description()).unwrap().rows().len();
        assert!(probed_by(&training(all / 40, 1.0), When::Unsure).growths > 0);
    }

    #[test]
    fn the_error_of_a_set_is_found_within_two_growths() {
        let found = probed_by(&training(1, 1.1), When::Always);
        assert_eq!(found.growths, 2);
        assert!((found.offset.size + libm::log(1.1)).abs() < 0.02, "{found:?}");
        assert!(found.note().unwrap().starts_with("parameters corrected by 2 growths"), "{:?}", found.note());
        assert!(found.offset.turn.abs() < 0.3 && found.offset.elongation.abs() < 0.01, "{found:?}");
    }

    #[test]
    fn equal_questions_are_probed_once_and_a_cancelled_probe_ends() {
        let training = training(1, 1.0);
        let ask = |watch: &Watch| {
            probed(&training, System::MEINHARDT_SPOTS, &[WANTED, WANTED], 1.0, When::Always, watch)
        };
        let both = ask(&Watch::NONE).unwrap();
        assert_eq!(both[0].offset, both[1].offset);
        let stop = Watch { progress: &|_, _| {}, cancelled: &|| true };
        assert!(matches!(ask(&stop), Err(ProbeError::Cancelled(_))));
    }

    #[test]
    fn an_offset_applied_and_taken_back_changes_nothing() {
        let offset = Offset { size: 0.1, spacing: -0.05, elongation: 0.02, turn: 3.0 };
        let back = offset.applied(-1.0, &offset.applied(1.0, &WANTED));
        let left = Offset::between(&WANTED, &back);
        assert!([left.size, left.spacing, left.elongation, left.turn].iter().all(|x| x.abs() < 1e-12));
        let found = Offset::between(&WANTED, &offset.applied(1.0, &WANTED));
        assert!(found.plus(-1.0, offset).within(Offset {
            size: 1e-9,
            spacing: 1e-9,
            elongation: 1e-9,
            turn: 1e-9
        }));
    }
}
