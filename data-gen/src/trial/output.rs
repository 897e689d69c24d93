//! Writes the numbers of the trial to a file.

use std::io::Write;
use std::path::Path;

use dapple::files;
use dapple_engine::attributes::Attributes;
use serde_json::{Map, Value, json};

use super::attribute::ATTRIBUTES;
use super::grown::{Outcome, Region};

/// Writes the numbers of each region, and the failures.
pub fn numbers(path: &Path, seed: u64, outcomes: &[Outcome]) -> Result<(), String> {
    let text = format!("{:#}\n", json(seed, outcomes));
    files::save(path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

/// The numbers of each region, and the failures, as a JSON value.
pub fn json(seed: u64, outcomes: &[Outcome]) -> Value {
    let documents: Vec<Value> = outcomes
        .iter()
        .map(|outcome| {
            json!({
                "document": outcome.name,
                "random": outcome.random,
                "systems": outcome.systems,
                "settled": outcome.settled,
                "seconds": outcome.seconds,
                "failures": outcome.failures.iter().map(ToString::to_string).collect::<Vec<_>>(),
                "regions": outcome.regions.iter().map(region).collect::<Vec<_>>(),
            })
        })
        .collect();
    json!({"seed": seed, "documents": documents})
}

fn region(region: &Region) -> Value {
    let attributes = |attributes: &Option<Attributes>| match attributes {
        Some(Attributes::Spots(spots)) => json!(spots),
        Some(Attributes::Stripes(stripes)) => json!(stripes),
        None => Value::Null,
    };
    let errors: Map<String, Value> = ATTRIBUTES
        .iter()
        .zip(region.errors)
        .filter_map(|(attribute, error)| Some((attribute.name.to_owned(), json!(error?))))
        .collect();
    json!({
        "layer": region.layer,
        "region": region.place,
        "marks": region.marks,
        "wanted": attributes(&region.wanted),
        "got": attributes(&region.got),
        "error": errors,
    })
}
