//! One run: parameters → simulation → a row, or the reason why not.

use dapple::learn::{Parameters, Row};
use dapple::rd::System;
use dapple::synth::{Patch, Sample, Watch};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::plan::Set;

/// Spots that a patch holds: enough that its means are known to a per cent.
const SPOTS: f64 = 80.0;
/// Wavelengths along the side of a patch of stripes.
const WAVELENGTHS: f64 = 20.0;

/// What came of a run.
pub struct Outcome {
    /// Its seed.
    pub seed: u64,
    /// What had been set.
    pub parameters: Parameters,
    /// What was measured, or why it cannot be learnt from.
    pub row: Result<Row, String>,
}

/// Runs 0..`runs` of a set, in parallel, in their order.
pub fn all(set: &Set, runs: u64) -> Vec<Outcome> {
    let style = ProgressStyle::with_template("{msg:18} {bar:40} {pos}/{len}  {elapsed} gone, {eta} left");
    let bar = ProgressBar::new(runs)
        .with_message(set.system.name())
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let outcomes = (0..runs)
        .into_par_iter()
        .map(|index| {
            let outcome = one(set, index);
            bar.inc(1);
            outcome
        })
        .collect();
    bar.finish();
    outcomes
}

fn one(set: &Set, index: u64) -> Outcome {
    let (seed, parameters) = (set.seed(index), set.draw(index));
    let extent = if set.system == System::MeinhardtStripes { WAVELENGTHS } else { SPOTS };
    let patch = Patch { system: set.system, parameters, extent, seed };
    let row = grown(&patch).map(|Sample { extent, evenness, attributes }| Row {
        seed,
        extent,
        evenness,
        attributes,
        parameters,
    });
    Outcome { seed, parameters, row }
}

fn grown(patch: &Patch) -> Result<Sample, String> {
    let (marks, settled) = patch.grow(&Watch::NOBODY).map_err(|cancelled| cancelled.to_string())?;
    if !settled {
        return Err("did not settle".to_owned());
    }
    patch.measure(&marks).map_err(|reason| reason.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::sets;

    #[test]
    fn the_rows_do_not_depend_on_the_number_of_threads() {
        let [.., set] = sets();
        let rows = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let outcomes = pool.install(|| all(&set, 3));
            outcomes.into_iter().map(|outcome| outcome.row.unwrap()).collect::<Vec<_>>()
        };
        assert_eq!(rows(1), rows(3));
    }
}
