//! What was asked, what was looked up, what has grown: the report of a growth, for people ([`regions`]) and for machines
//! ([`report`]).

mod region;

pub use region::{RegionReport, regions};

use serde_json::{Map, Value, json};

use crate::attributes::Attributes;
use crate::document::Document;
use crate::synth::grow::layer::{Grown, GrownLayer};
use crate::synth::plan::inside::is_replaced;

/// The report of `grown`, in the form that the contract gives. `document` is named `source`.
#[must_use]
pub fn report(document: &Document, source: &str, grown: &Grown, seconds: f64) -> Value {
    let layers: Vec<Value> = grown
        .layers
        .iter()
        .zip(&document.layers)
        .enumerate()
        .map(|(index, (grown, layer))| {
            let mut report = layer_report(grown, &layer.name);
            if is_replaced(document, index) {
                report["shown"] = json!(false);
            }
            report
        })
        .collect();
    json!({
        "document": source,
        "size": grown.size,
        "seed": document.seed,
        "seconds": seconds,
        "layers": layers,
    })
}

fn layer_report(layer: &GrownLayer, name: &str) -> Value {
    let plan = &layer.plan;
    let regions: Vec<Value> = regions(layer).iter().map(region_report).collect();
    json!({
        "name": name,
        "system": plan.system.name(),
        "cell": plan.px_a_cell(),
        "grid": plan.grid,
        "steps": layer.steps,
        "settled": layer.settled,
        "regions": regions,
    })
}

fn region_report(region: &RegionReport) -> Value {
    let numbers = |named: &[(&'static str, f64)]| -> Map<String, Value> {
        named.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect()
    };
    let attributes = |what: &Attributes| attributes(what, region.directed);
    let mut report = Map::new();
    report.insert("region".to_owned(), json!(region.place));
    if let Some(marks) = region.marks {
        report.insert("marks".to_owned(), json!(marks));
    }
    report.insert("asked".to_owned(), attributes(&region.asked));
    report.insert("parameters".to_owned(), Value::Object(numbers(&region.parameters)));
    report.insert("predicted".to_owned(), attributes(&region.predicted));
    if let Some(got) = region.got {
        report.insert("got".to_owned(), attributes(&got));
    }
    report.insert("error".to_owned(), Value::Object(numbers(&region.error)));
    if let Some((asked, got)) = region.spread {
        let mut spread = Map::new();
        spread.insert("asked".to_owned(), json!(asked));
        if let Some(got) = got {
            spread.insert("got".to_owned(), json!(got));
        }
        report.insert("spread".to_owned(), Value::Object(spread));
    }
    if let Some(kept) = &region.kept {
        report.insert("kept".to_owned(), json!(kept));
    }
    report.insert("notes".to_owned(), json!(region.notes));
    Value::Object(report)
}

/// Lines round marks, or between them, are not `directed`: they run as these let them.
fn attributes(attributes: &Attributes, directed: bool) -> Value {
    match attributes {
        Attributes::Spots(spots) => json!(spots),
        Attributes::Stripes(stripes) if directed => json!(stripes),
        Attributes::Stripes(stripes) => json!({"width": stripes.width}),
    }
}
