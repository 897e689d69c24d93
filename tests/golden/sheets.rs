//! Checks that the golden documents, grown to the end, have the stored attributes, within the variation between seeds.
//!
//! The attributes are not compared bit for bit, because solvers and training sets are improved, and the place of each
//! mark depends on the last bit of the first step. The numbers are those of the report, region by region.

use crate::renew::{golden, renew, renews, text};
use crate::textures::{document, names};
use dapple::document::Document;
use dapple_engine::marks::turn;
use dapple_engine::synth::Growth;
use dapple_engine::synth::Options;
use dapple_engine::synth::layer_report::report;
use serde_json::{Map, Value, json};

/// The allowed difference from the stored value, relative or absolute. It is at most the largest change by six other
/// seeds (docs/golden.md), and less where a few marks change much.
#[derive(Clone, Copy)]
enum Allowed {
    Share(f64),
    Difference(f64),
    Degrees(f64),
}

const ALLOWED: [(&str, Allowed); 8] = [
    ("area", Allowed::Share(0.02)),
    ("spacing", Allowed::Share(0.06)),
    ("width", Allowed::Share(0.005)),
    ("wavelength", Allowed::Share(0.15)),
    ("aspect", Allowed::Difference(0.03)),
    ("angle", Allowed::Degrees(4.0)),
    ("marks", Allowed::Share(0.25)),
    // The distance of a kept mark from its place, in radii; a quarter of a radius is allowed in documents.
    ("farthest", Allowed::Difference(0.1)),
];
/// A difference in the number of marks that is always allowed.
const FEW: f64 = 3.0;
/// The aspect above which the direction of spots is random.
const ROUND: f64 = 0.75;

/// The grown attributes of each layer, by region; numbers have four digits.
fn sheet(document: &Document, name: &str) -> Value {
    let grown = Growth::begin(document, &Options { source: name, ..Options::default() }, None).run().unwrap();
    let report = json!(report(document, name, &grown, 0.0));
    let layers = report["layers"].as_array().unwrap().iter().map(|layer| {
        let regions = layer["regions"].as_array().unwrap().iter().map(|region| {
            let mut output = Map::from_iter([("region".to_owned(), region["region"].clone())]);
            let got = region["got"].as_object().unwrap();
            output.extend(got.iter().map(|(key, value)| (key.clone(), short(value))));
            output.extend(region.get("marks").map(|marks| ("marks".to_owned(), marks.clone())));
            output.extend(region.get("kept").map(|kept| ("kept".to_owned(), kept.clone())));
            Value::Object(output)
        });
        let regions: Vec<Value> = regions.collect();
        json!({"system": layer["system"], "settled": layer["settled"], "regions": regions})
    });
    json!({"layers": layers.collect::<Vec<_>>()})
}

fn short(value: &Value) -> Value {
    let value = value.as_f64().unwrap();
    let digits = 10f64.powi(3 - value.abs().max(1e-9).log10().floor() as i32);
    json!((value * digits).round() / digits)
}

/// The differences of `grown` that are too large; `at` is the place of the value.
fn too_far(at: &str, key: &str, stored: &Value, grown: &Value) -> Option<String> {
    let Some((_, allowed)) = ALLOWED.iter().find(|(name, _)| *name == key) else {
        return (stored != grown).then(|| format!("{at}: stored {stored}, grown {grown}"));
    };
    let Some([old, new]) = stored.as_f64().zip(grown.as_f64()).map(|(old, new)| [old, new]) else {
        return Some(format!("{at}: stored {stored}, grown {grown}"));
    };
    let (off, most) = match *allowed {
        Allowed::Share(most) => ((new / old - 1.0).abs(), most),
        Allowed::Difference(most) => ((new - old).abs(), most),
        Allowed::Degrees(most) => (turn(new, old).abs(), most),
    };
    let few = key == "marks" && (new - old).abs() <= FEW;
    (off > most && !few).then(|| format!("{at}: stored {old}, grown {new}, off by {off:.3}, allowed {most}"))
}

/// All differences in a sheet that are too large.
fn compare(at: &str, stored: &Value, grown: &Value) -> Vec<String> {
    match (stored, grown) {
        (Value::Array(old), Value::Array(new))
            if old.len() == new.len() && old.iter().any(Value::is_object) =>
        {
            let pairs = old.iter().zip(new).enumerate();
            pairs.flat_map(|(i, (old, new))| compare(&format!("{at}[{i}]"), old, new)).collect()
        }
        (Value::Object(old), Value::Object(new)) => {
            if old.keys().ne(new.keys()) {
                return vec![format!("{at}: stored {stored}, grown {grown}")];
            }
            let round = |sheet: &Map<String, Value>| {
                sheet.get("aspect").and_then(Value::as_f64).is_some_and(|a| a > ROUND)
            };
            let keys = old.keys().filter(|key| *key != "angle" || !round(old));
            keys.flat_map(|key| {
                let at = format!("{at}.{key}");
                match &old[key] {
                    Value::Array(_) | Value::Object(_) => compare(&at, &old[key], &new[key]),
                    value => too_far(&at, key, value, &new[key]).into_iter().collect(),
                }
            })
            .collect()
        }
        _ if stored == grown => Vec::new(),
        _ => vec![format!("{at}: stored {stored}, grown {grown}")],
    }
}

/// Every value that has changed by a digit; printed when the sheets are renewed.
fn changes(stored: &Value, grown: &Value, at: &str, output: &mut Vec<String>) {
    match (stored, grown) {
        (Value::Array(old), Value::Array(new)) if old.len() == new.len() => {
            old.iter()
                .zip(new)
                .enumerate()
                .for_each(|(i, (old, new))| changes(old, new, &format!("{at}[{i}]"), output));
        }
        (Value::Object(old), Value::Object(new)) if old.keys().eq(new.keys()) => {
            old.iter().for_each(|(key, old)| changes(old, &new[key], &format!("{at}.{key}"), output));
        }
        _ if stored != grown => output.push(format!("{at} {stored} → {grown}")),
        _ => {}
    }
}

fn holds(names: &[String]) {
    let mut wrong = Vec::new();
    for name in names {
        let file = format!("textures/{name}.json");
        let fresh = sheet(&document(name), name);
        if renews() {
            let stored = std::fs::read(golden(&file)).ok().and_then(|old| serde_json::from_slice(&old).ok());
            let mut output = Vec::new();
            changes(&stored.unwrap_or(Value::Null), &fresh, "", &mut output);
            if !output.is_empty() {
                renew(&file, format!("{fresh:#}\n").as_bytes(), &output.join("; "));
            }
            continue;
        }
        let stored: Value = serde_json::from_str(&text(&golden(&file))).unwrap();
        wrong.extend(compare(&format!("tests/golden/{file}: "), &stored, &fresh));
    }
    assert!(wrong.is_empty(), "{}\nIf that is meant: REGENERATE=1", wrong.join("\n"));
}

// Two separate tests, which run in parallel.
#[test]
fn textures_of_one_layer_have_the_stored_attributes() {
    let one: Vec<String> = names().into_iter().filter(|name| document(name).layers.len() == 1).collect();
    holds(&one);
}

#[test]
fn textures_of_two_layers_have_the_stored_attributes() {
    let two: Vec<String> = names().into_iter().filter(|name| document(name).layers.len() > 1).collect();
    holds(&two);
}
