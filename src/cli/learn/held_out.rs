//! Errors in parameters: rows that were held out are asked for, with more and more others to learn from.

use super::outcome::{Of, Outcome};
use super::way::Way;
use super::{Setting, bar};
use crate::cli::Error;
use crate::learn::{self, Fold, Method, folds, summaries};
use crate::rd::System;
use crate::synth::Training;
use rayon::prelude::*;

/// Rows to learn from, beside all.
const SIZES: [usize; 4] = [30, 100, 300, 1_000];

/// Each way with each number of rows.
pub fn outcomes(setting: &Setting, system: System) -> Result<Vec<Outcome>, Error> {
    let set = setting.training.of(system).map_err(Error::step)?;
    let folds = folds(set.rows(), &SIZES, setting.targets);
    let mut ways: Vec<Way> = Method::ALL.into_iter().map(Way::Learnt).collect();
    ways.extend(setting.grow.then_some(Way::Refined));
    let questions = folds.first().map_or(0, |fold| fold.questions.len());
    let bar = bar(format!("{}, parameters", system.name()), ways.len() * folds.len() * questions);
    let mut outcomes = Vec::new();
    for way in ways {
        for fold in &folds {
            let training = Training::of_rows(system, fold.rows.clone()).map_err(Error::step)?;
            outcomes.push(outcome(setting, system, &training, way, fold, &|| bar.inc(1))?);
        }
    }
    bar.finish_and_clear();
    Ok(outcomes)
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
        // Rows are told in cells.
        let got = way.parameters(training, system, &row.attributes, 1.0, setting.when, setting.watch)?;
        done();
        Ok(learn::Error::of_parameters(&got, &row.parameters))
    };
    let errors = fold.questions.par_iter().map(errors_of).collect::<Result<Vec<_>, Error>>()?;
    Ok(Outcome {
        system,
        of: Of::Parameters,
        way,
        rows: fold.rows.len(),
        all: fold.all,
        asked: fold.questions.len(),
        failed: Vec::new(),
        errors: summaries(errors.into_iter().flatten()),
    })
}
