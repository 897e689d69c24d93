//! How much other seeds change the attributes of the golden textures.

use std::collections::BTreeMap;

use dapple::document::Document;
use dapple_engine::marks::turn;
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::{Growth, Options};
use serde_json::{Value, json};

use super::golden;
use crate::say;

/// The attributes that are compared relative to the first value; others are compared by their difference.
const SHARES: [&str; 5] = ["area", "spacing", "width", "wavelength", "marks"];

/// The largest change of each attribute over six other seeds, texture by texture.
pub fn print() -> Result<(), String> {
    for (name, document) in golden()? {
        let stored = regions(&document)?;
        let mut worst: BTreeMap<String, f64> = BTreeMap::new();
        for seed in 101..107 {
            let other = regions(&Document { seed, ..document.clone() })?;
            for (old, new) in stored.iter().zip(&other) {
                for (key, off) in changes(old, new) {
                    let worst = worst.entry(key).or_default();
                    *worst = worst.max(off);
                }
            }
        }
        let cells: Vec<String> = worst.iter().map(|(key, off)| format!("{key} {off:.4}")).collect();
        say(&format!("{name}: {}", cells.join(", ")))?;
    }
    Ok(())
}

/// The grown attributes of each region of each layer, with the count of its marks.
fn regions(document: &Document) -> Result<Vec<BTreeMap<String, f64>>, String> {
    let grown =
        Growth::begin(document, &Options::default(), None).run().map_err(|error| error.to_string())?;
    let report = json!(report(document, "document", &grown, 0.0));
    let all = |value: &Value, key: &str| value[key].as_array().cloned().unwrap_or_default();
    let regions = all(&report, "layers").into_iter().flat_map(|layer| all(&layer, "regions"));
    let numbers = regions.map(|region| {
        let got = region["got"].as_object().cloned().unwrap_or_default();
        let marks = region.get("marks").map(|marks| ("marks".to_owned(), marks.clone()));
        got.into_iter().chain(marks).filter_map(|(key, value)| Some((key, value.as_f64()?))).collect()
    });
    Ok(numbers.collect())
}

fn changes(old: &BTreeMap<String, f64>, new: &BTreeMap<String, f64>) -> Vec<(String, f64)> {
    let both = old.iter().filter_map(|(key, old)| Some((key, *old, *new.get(key)?)));
    let change = both.map(|(key, old, new)| {
        let off = match key.as_str() {
            "angle" => turn(new, old).abs(),
            _ if SHARES.contains(&key.as_str()) => (new / old - 1.0).abs(),
            _ => (new - old).abs(),
        };
        (key.clone(), off)
    });
    change.collect()
}
