//! Outcomes → files: `SYSTEM.csv` for what may be learnt from, `SYSTEM.rejected.csv` for the rest.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use dapple::export::save;
use dapple::learn::{Row, write_rows};
use dapple::rd::System;

use crate::run::Outcome;

/// Writes both files of `system` into `folder`, and tells on stderr what came out.
pub fn write(folder: &Path, system: System, outcomes: &[Outcome]) -> Result<(), String> {
    std::fs::create_dir_all(folder)
        .map_err(|error| format!("cannot make the folder '{}': {error}", folder.display()))?;
    let rows: Vec<Row> = outcomes.iter().filter_map(|outcome| outcome.row.as_ref().ok().copied()).collect();
    let mut table = Vec::new();
    write_rows(system.name(), &rows, &mut table).map_err(|error| error.to_string())?;

    let mut rejected = "seed,rate,ratio,stretch,direction,level,reason\n".to_owned();
    let mut reasons: BTreeMap<String, usize> = BTreeMap::new();
    for outcome in outcomes {
        let Err(reason) = &outcome.row else { continue };
        let p = &outcome.parameters;
        let optional = |value: Option<f64>| value.map(|v| format!("{v:.6}")).unwrap_or_default();
        let _ = writeln!(
            rejected,
            "{},{:.6},{},{:.6},{:.4},{},\"{reason}\"",
            outcome.seed,
            p.rate,
            optional(p.ratio),
            p.stretch,
            p.direction,
            optional(p.level)
        );
        // The sentence without its numbers.
        let kind = reason.split([':', ',']).next().unwrap_or(reason);
        let kind: String = kind.chars().filter(|c| !c.is_ascii_digit() && *c != '.').collect();
        *reasons.entry(kind).or_default() += 1;
    }
    for (name, bytes) in [
        (format!("{}.csv", system.name()), table),
        (format!("{}.rejected.csv", system.name()), rejected.into()),
    ] {
        save(&folder.join(name), |out| {
            std::io::Write::write_all(out, &bytes)?;
            Ok(())
        })
        .map_err(|error| error.to_string())?;
    }
    eprintln!(
        "{}: {} accepted, {} rejected {reasons:?}",
        system.name(),
        rows.len(),
        outcomes.len() - rows.len()
    );
    Ok(())
}
