//! The results of the trial as files: documents, pictures, numbers.

use std::io::Write;
use std::path::Path;

use dapple::document::{Colours, Document};
use dapple::files::{self, WriteFile};
use dapple_engine::attributes::Attributes;
use dapple_engine::colour::{Gradient, Painted, Table, paint};
use dapple_engine::export::ExportError;
use dapple_engine::export::png::{gray16, rgb8};
use dapple_engine::grid::Field;
use serde_json::{Map, Value, json};

use super::attribute::ATTRIBUTES;
use super::grown::{Outcome, Region};

/// Writes `NAME.dapple`, `NAME.png` and, of each layer, `NAME.pattern.png` (from the second on with its number).
pub fn pictures(folder: &Path, name: &str, document: &Document, patterns: &[Field]) -> Result<(), String> {
    let failed = |error: ExportError| error.to_string();
    document.write(folder.join(format!("{name}.dapple"))).map_err(|error| error.to_string())?;
    for (k, pattern) in patterns.iter().enumerate() {
        let number = if k == 0 { String::new() } else { format!("-{}", k + 1) };
        let path = folder.join(format!("{name}.pattern{number}.png"));
        files::save(&path, |out| gray16(out, pattern, Some(document.dpi))).map_err(failed)?;
    }
    let tables: Vec<Table> = document
        .layers
        .iter()
        .enumerate()
        .map(|(k, layer)| {
            let own = layer.colours.as_ref().map(Colours::gradient);
            own.unwrap_or_else(|| Gradient::default_for_layer(k)).table()
        })
        .collect();
    let layers = patterns.iter().zip(&tables).zip(&document.layers);
    let painted: Vec<Painted> = layers
        .map(|((pattern, table), layer)| Painted { pattern, free: None, table, visible: layer.visible })
        .collect();
    let size = document.size.map(|side| side as usize);
    let rgb = paint(&painted, size[0], size[1]);
    let path = folder.join(format!("{name}.png"));
    files::save(&path, |out| rgb8(out, size, Some(document.dpi), &rgb)).map_err(failed)
}

/// Writes the numbers of each region, and what failed.
pub fn numbers(path: &Path, seed: u64, outcomes: &[Outcome]) -> Result<(), String> {
    let text = format!("{:#}\n", json(seed, outcomes));
    files::save(path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

/// The same as a value.
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
