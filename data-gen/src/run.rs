//! One run: parameters → simulation → verdict → a line of one of the two files.

use dapple_engine::learn::{Parameters, Row, six_digits, write_rows};
use dapple_engine::measure::Reason;
use dapple_engine::rd::System;
use dapple_engine::synth::{ProbePatch, Sample, Watch};

use crate::pairs;
use crate::plan::Set;
use crate::swept::Swept;
use crate::verdicts::ACCEPTED;

/// The result of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// The index of its set in the plan.
    pub set: usize,
    /// Its index in the set.
    pub index: u64,
    /// `ACCEPTED`, or the reason for its rejection, in one word.
    pub verdict: &'static str,
    /// Its line in the file of rows, or in that of rejected runs.
    pub line: String,
}

/// Grows, measures and judges run `index` of `set`.
pub fn run(set: &Set, index: u64) -> Result<(&'static str, String), String> {
    let system = match set.system {
        Swept::System(system) => system,
        Swept::Pairs(of) => return pairs::run(set, of, index),
    };
    let (seed, parameters) = (set.seed_of(index), set.parameters_of(index));
    let patch = ProbePatch { system, parameters, extent: set.patch.grown, seed };
    let (marks, settled) = patch.grow(&Watch::NONE).map_err(|cancelled| cancelled.to_string())?;
    match patch.judge(&marks, settled, set.patch.least) {
        Ok(sample) => Ok((ACCEPTED, accepted(set, system, seed, parameters, sample)?)),
        Err(reason) => Ok((reason.kind(), rejected(seed, &parameters, &reason))),
    }
}

fn accepted(
    set: &Set,
    system: System,
    seed: u64,
    parameters: Parameters,
    sample: Sample,
) -> Result<String, String> {
    let Sample { extent, evenness, attributes } = sample;
    let row = Row { seed, extent, evenness, attributes, parameters };
    let mut table = Vec::new();
    let failed = |error: String| format!("set '{}', seed {seed}: {error}", set.name);
    write_rows(system.description(), &[row], &mut table).map_err(|error| failed(error.to_string()))?;
    let table = String::from_utf8(table).map_err(|error| failed(error.to_string()))?;
    Ok(table.lines().nth(1).unwrap_or_default().to_owned())
}

fn rejected(seed: u64, parameters: &Parameters, reason: &Reason) -> String {
    let mut line = seed.to_string();
    for (_, value) in parameters.named() {
        line.push(',');
        line.push_str(&six_digits(value));
    }
    // The texts contain no quotes.
    format!("{line},{},\"{reason}\"", reason.kind())
}

/// The header of the file of rows and that of the file of rejected runs.
pub fn headers(set: &Set) -> [String; 2] {
    if let Swept::Pairs(_) = set.system {
        return pairs::headers(set);
    }
    let rows: Vec<&str> = set.system.description().all_columns().map(|column| column.name).collect();
    let output = set.parameters_of(0).named();
    let output: Vec<&str> = output.iter().map(|(name, _)| *name).collect();
    [rows.join(","), format!("seed,{},reason,detail", output.join(","))]
}
