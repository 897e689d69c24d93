//! The manifest of each file of rows: the meaning of its columns, what was swept, and how to repeat the sweep.

use serde_json::{Map, Value, json};

use crate::journal::DAPPLE;
use crate::plan::{Plan, Set};
use crate::progress::Tally;
use crate::run::Record;
use crate::verdicts::{ACCEPTED, reasons_of};

/// The version of the files of rows that the manifest describes.
const VERSION: u64 = 1;

/// The manifest of `set`, whose runs are `records`. It does not depend on when, where or in how many parts they ran.
pub fn manifest(plan: &Plan, set: &Set, records: &[Record]) -> Result<Value, String> {
    let tally = Tally::count_records(records);
    let rejected: Map<String, Value> =
        reasons_of(set.system).iter().map(|kind| ((*kind).to_owned(), json!(tally.count(kind)))).collect();
    Ok(json!({
        "format": "dapple training set",
        "version": VERSION,
        "set": set.name,
        "system": set.system.name(),
        "why": set.why,
        "dapple": DAPPLE,
        "files": {"rows": format!("{}.csv", set.name), "rejected": format!("{}.rejected.csv", set.name)},
        "command": command(set)?,
        "counts": {"runs": tally.all(), "accepted": tally.count(ACCEPTED), "rejected": rejected},
        "seeds": {"first": set.seed, "last": set.seed_of(set.runs - 1)},
        "columns": columns(set, records)?,
        "plan": serde_json::to_value(plan.only(set)).map_err(|error| error.to_string())?,
    }))
}

/// The command that makes the files of this set again.
fn command(set: &Set) -> Result<String, String> {
    let sweep = "cargo run --release -p data-gen -- sweep";
    let built_in = Plan::built_in()?;
    let own = built_in.sets.iter().find(|planned| planned.name == set.name);
    Ok(match own {
        Some(planned) if planned == set => format!("{sweep} --set {}", set.name),
        Some(planned) if *planned == (Set { runs: planned.runs, ..set.clone() }) => {
            format!("{sweep} --set {} --runs {}", set.name, set.runs)
        }
        // The path of the plan does not matter, because the plan itself follows below.
        _ => format!("{sweep} --plan PLAN.json -o DIR   # PLAN.json: the value of \"plan\" in this file"),
    })
}

/// Each column with its unit and the range that was found.
fn columns(set: &Set, records: &[Record]) -> Result<Vec<Value>, String> {
    let columns: Vec<_> = set.system.description().all_columns().collect();
    let mut found = vec![[f64::INFINITY, f64::NEG_INFINITY]; columns.len()];
    for record in records.iter().filter(|record| record.verdict == ACCEPTED) {
        let values = record.line.split(',').map(str::parse::<f64>);
        for ([low, high], value) in found.iter_mut().zip(values) {
            let value =
                value.map_err(|error| format!("set '{}', run {}: {error}", set.name, record.index))?;
            (*low, *high) = (low.min(value), high.max(value));
        }
    }
    let number = |value: f64| {
        if value.fract() == 0.0 && value.abs() < 9e15 { json!(value as i64) } else { json!(value) }
    };
    let described = columns.iter().zip(&found).map(|(column, [low, high])| {
        let range = if low <= high { json!([number(*low), number(*high)]) } else { Value::Null };
        json!({"name": column.name, "unit": column.unit, "meaning": column.meaning, "range": range})
    });
    Ok(described.collect())
}
