//! Errors of systems of pairs: for rows that are left out, and for random targets that are grown.

use super::outcome::{Of, Outcome};
use super::{Setting, bar};
use crate::attributes::system::Description;
use crate::cli::Error;
use crate::learn::{self, HeldOut, TrainingError, held_out, summaries};
use crate::synth::{Drawn, PairPatch, Training};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

/// The methods whose answers are grown: by the law alone, with the correction from the rows, and refined as in `dapple
/// grow`.
const GROWN: [&str; 3] = ["law alone", "LWR", "LWR + refinement"];
/// Periods along the side of a patch, and cells along it.
const PERIODS: [f64; 2] = [16.0, 120.0];

/// The outcomes of one system of pairs; none where it has no rows, or where a folder with all systems has no files for
/// it.
pub fn outcomes(setting: &Setting, system: &'static Description) -> Result<Vec<Outcome>, Error> {
    let set = match setting.training.pairs(system) {
        Err(TrainingError::NoFiles { .. }) if setting.all => None,
        found => found.map_err(Error::step)?,
    };
    let Some(set) = set else { return Ok(Vec::new()) };
    let rows = set.rows().len();
    let one_of = (rows / setting.targets.max(1)).max(5);
    let held = held_out(set, one_of).map_err(Error::step)?;
    let asked = held.first().map_or(0, |held| held.errors[0].len());
    let mut outcomes: Vec<Outcome> = (0..HeldOut::WAYS.len())
        .map(|way| Outcome {
            system: system.name,
            of: Of::Parameters,
            way: HeldOut::WAYS[way],
            bounds: &[],
            rows: rows - asked,
            all: true,
            asked,
            failed: Vec::new(),
            errors: summaries(held.iter().flat_map(|held| of_parameter(held, way))),
        })
        .collect();
    if setting.grow {
        outcomes.extend(grown(setting, system, rows)?);
    }
    Ok(outcomes)
}

/// The errors of one method for a parameter.
fn of_parameter(held: &HeldOut, way: usize) -> impl Iterator<Item = learn::Error> + '_ {
    // A relative error of the factor on the size is the same relative error of the size.
    let quantity = match held.answered {
        "factor" => "size",
        "apart" => "distance",
        other => other,
    };
    held.errors[way].iter().map(move |error| learn::Error { quantity, unit: "%", value: 100.0 * error })
}

/// The errors of random targets by each of the methods.
fn grown(setting: &Setting, system: &'static Description, rows: usize) -> Result<Vec<Outcome>, Error> {
    let law = Training::with_pairs(system, Vec::new()).map_err(Error::step)?;
    let bar = bar(format!("{}, grown anew", system.name), GROWN.len() * setting.targets);
    let targets: Vec<PairPatch> =
        (0..setting.targets as u64).map(|index| target(system, setting.seed, index)).collect();
    let ways = [(&law, false, 0), (setting.training, false, rows), (setting.training, true, rows)];
    let mut outcomes = Vec::new();
    for (way, (training, corrects, rows)) in GROWN.into_iter().zip(ways) {
        let errors = |patch: &PairPatch| {
            let errors = patch.errors(training, corrects, setting.watch).map_err(|_| Error::Interrupted);
            bar.inc(1);
            errors
        };
        let found = targets.par_iter().map(errors).collect::<Result<Vec<_>, Error>>()?;
        let described = targets.iter().zip(&found);
        let failed = described
            .filter_map(|(patch, found)| Some(format!("seed {}: {}", patch.seed, found.as_ref().err()?)));
        let error = |(quantity, error): (&'static str, f64)| learn::Error {
            quantity,
            unit: "%",
            value: 100.0 * error.abs(),
        };
        outcomes.push(Outcome {
            system: system.name,
            of: Of::Grown,
            way,
            bounds: if corrects { system.grown_errors } else { &[] },
            rows,
            all: true,
            asked: targets.len(),
            failed: failed.collect(),
            errors: summaries(found.into_iter().flatten().flatten().map(error)),
        });
    }
    bar.finish_and_clear();
    Ok(outcomes)
}

/// Random target number `index`, with attributes that the system is made for.
fn target(system: &'static Description, seed: u64, index: u64) -> PairPatch {
    let mut rng = Pcg64::seed_from_u64(seed.wrapping_mul(1_000_003).wrapping_add(index));
    let mut between = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
    let directions = if between(0.0, 3.0) < 2.0 { 2 } else { 3 };
    let [low, high] = system.coordinates().map_or([0.5; 2], |coordinates| coordinates.duty[directions - 2]);
    let drawn = Drawn {
        directions,
        duty: between(low, high),
        others: between(low, high),
        unequal: libm::exp(between(-0.6, 0.6)),
        between: if directions == 2 { between(45.0, 90.0) } else { between(50.0, 70.0) },
        angle: between(0.0, 180.0),
        long: between(2.8, 6.0),
        decay: between(0.0, 0.85),
        sparse: libm::exp(between(libm::log(2.8), libm::log(10.0))),
        aspect: between(0.5, 1.0),
        ..Drawn::default()
    };
    let [periods, cells] = PERIODS;
    let periods = if system.is_striped() { periods } else { cells };
    PairPatch { system, drawn, periods, least: 1.0, seed: seed.wrapping_add(index) }
}
