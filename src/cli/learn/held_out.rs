//! Errors of parameters: rows that are left out are looked up in training sets of increasing size.

use super::outcome::{Of, Outcome};
use super::way::Way;
use super::{Setting, bar};
use crate::cli::Error;
use crate::learn;
use crate::learn::{Fold, Method, evenly, folds, summaries};
use crate::rd::System;
use crate::synth::Training;
use rayon::prelude::*;

/// Sizes of the reduced training sets.
const SIZES: [usize; 4] = [30, 100, 300, 1_000];

/// The outcome of each method with each number of rows.
pub fn outcomes(setting: &Setting, system: System) -> Result<Vec<Outcome>, Error> {
    let set = setting.training.set(system).map_err(Error::step)?;
    let folds = folds(set.rows(), &SIZES, setting.targets);
    let mut ways: Vec<Way> = Method::ALL.into_iter().map(Way::Learnt).collect();
    ways.extend(setting.grow.then_some(Way::Refined));
    let asked = |way| folds.iter().map(move |fold| questions(fold, way).len());
    let bar = bar(format!("{}, parameters", system.name()), ways.iter().flat_map(|way| asked(*way)).sum());
    let mut outcomes = Vec::new();
    for way in ways {
        for fold in &folds {
            let training = Training::from_rows(system, fold.rows.clone()).map_err(Error::step)?;
            outcomes.push(outcome(setting, system, &training, way, fold, &|| bar.inc(1))?);
        }
    }
    bar.finish_and_clear();
    Ok(outcomes)
}

/// The rows to look up; only a fifth of them for the method that grows patches for each row.
fn questions(fold: &Fold, way: Way) -> Vec<learn::Row> {
    match way {
        Way::Refined => evenly(&fold.questions, fold.questions.len().div_ceil(5)),
        Way::Learnt(_) => fold.questions.clone(),
    }
}

fn outcome(
    setting: &Setting,
    system: System,
    training: &Training,
    way: Way,
    fold: &Fold,
    done: &(dyn Fn() + Sync),
) -> Result<Outcome, Error> {
    let errors_of = |row: &learn::Row| {
        setting.watch.step(crate::synth::Stage::Grow, 0.0).map_err(|_| Error::Interrupted)?;
        // One cell is one px here.
        let asked = row.attributes.in_px(1.0);
        let got = way.parameters(training, system, &asked, 1.0, setting.when, setting.watch)?;
        done();
        Ok(learn::Error::of_parameters(&got, &row.parameters))
    };
    let questions = questions(fold, way);
    let errors = questions.par_iter().map(errors_of).collect::<Result<Vec<_>, Error>>()?;
    Ok(Outcome {
        system: system.name(),
        of: Of::Parameters,
        way: way.name(),
        bounds: &[],
        rows: fold.rows.len(),
        all: fold.all,
        asked: questions.len(),
        failed: Vec::new(),
        errors: summaries(errors.into_iter().flatten()),
    })
}
