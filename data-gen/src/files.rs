//! Runs → the files of a training set: rows, rejected runs, manifest.

use std::io::Write;
use std::path::Path;

use dapple::files::prepare;
use dapple_engine::export::ExportError;

use crate::manifest::manifest;
use crate::plan::Plan;
use crate::run::{Record, headers};
use crate::verdicts::ACCEPTED;

/// Writes `SET.csv`, `SET.rejected.csv` and `SET.json` of each set of `plan` into `folder`: all of them, or none where
/// one cannot be written.
///
/// `records` are all runs, in any order.
pub fn write(folder: &Path, plan: &Plan, mut records: Vec<Record>) -> Result<(), String> {
    make_folder(folder)?;
    records.sort_by_key(|record| (record.set, record.index));
    let failed = |error: ExportError| error.to_string();
    let mut files = Vec::new();
    for (number, set) in plan.sets.iter().enumerate() {
        let from = records.partition_point(|record| record.set < number);
        let to = records.partition_point(|record| record.set <= number);
        let runs = &records[from..to];
        let [mut rows, mut rejected] = headers(set).map(|header| header + "\n");
        for run in runs {
            let table = if run.verdict == ACCEPTED { &mut rows } else { &mut rejected };
            table.push_str(&run.line);
            table.push('\n');
        }
        let manifest = manifest(plan, set, runs)?;
        let manifest = serde_json::to_string_pretty(&manifest).map_err(|error| error.to_string())? + "\n";
        for (ending, text) in [("csv", rows), ("rejected.csv", rejected), ("json", manifest)] {
            let path = folder.join(format!("{}.{ending}", set.name));
            files.push(prepare(&path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(failed)?);
        }
    }
    files.into_iter().try_for_each(|file| file.keep().map_err(failed))
}

/// Makes a folder where there is none.
pub fn make_folder(folder: &Path) -> Result<(), String> {
    dapple::files::make_folder(folder).map_err(|error| error.to_string())
}
