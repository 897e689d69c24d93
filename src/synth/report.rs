//! What was asked, what was looked up, what has grown: the report of a growth, for machines.

use serde_json::{Map, Value, json};

use super::grow::{Grown, GrownLayer};
use super::inside::is_replaced;
use super::keep::{self, Stayed};
use super::recipe::Document;
use super::refine::Measured;
use crate::attributes::Attributes;
use crate::rd::Seeding;

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
    let cell = plan.px_a_cell();
    let [nx, ny] = plan.grid;
    let stayed = keep::stayed(plan, &layer.measured, &|| layer.pattern().field(nx, ny));
    let region = |index| region_report(layer, index, cell, stayed.get(index));
    let regions: Vec<Value> = (0..plan.answers.len()).map(region).collect();
    json!({
        "name": name,
        "system": plan.system.name(),
        "cell": cell,
        "grid": plan.grid,
        "steps": layer.steps,
        "settled": layer.settled,
        "regions": regions,
    })
}

fn region_report(layer: &GrownLayer, index: usize, cell: f64, stayed: Option<&Stayed>) -> Value {
    let plan = &layer.plan;
    let layout = plan.map.layout();
    let place = layout.place(index);
    let answer = &plan.answers[index];
    let mut parameters: Map<String, Value> =
        answer.parameters.named().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect();
    if let Some(level) = answer.parameters.level {
        parameters.insert("level".to_owned(), json!(level * layer.correction[index]));
    }
    if answer.pitch > 1.0 {
        parameters.insert("pitch".to_owned(), json!(answer.pitch));
    }
    if plan.way.is_some() {
        parameters.remove("direction");
    }
    parameters.insert("cell".to_owned(), json!(cell));
    let mut notes: Vec<String> = answer.notes.iter().map(ToString::to_string).collect();
    notes.extend(plan.remarks[index].iter().cloned());
    notes.extend(plan.probed[index].note());
    notes.extend(stayed.and_then(|stayed| stayed.note(plan.system.is_striped())));
    let (marks, mut error) = errors(&layer.measured, index);
    if plan.seeding == Seeding::Initiators {
        // Stripes run round the lines; no direction was asked.
        error.retain(|name, _| name == "width");
    }
    if marks == Some(0) {
        notes.push("no whole mark grew in this region: nothing was measured".to_owned());
    }
    let mut report = Map::new();
    report.insert("region".to_owned(), json!(place));
    if let Some(marks) = marks {
        report.insert("marks".to_owned(), json!(marks));
    }
    let attributes = |what: &Attributes| attributes(what, plan.way.is_none());
    report.insert("asked".to_owned(), attributes(&plan.map.at(layout.center(place))));
    report.insert("parameters".to_owned(), Value::Object(parameters));
    report.insert("predicted".to_owned(), attributes(&answer.predicted));
    if let Some(got) = layer.measured.got(index) {
        report.insert("got".to_owned(), attributes(&got));
    }
    report.insert("error".to_owned(), Value::Object(error));
    if let Some(spread) = spread(layer, place, index) {
        report.insert("spread".to_owned(), spread);
    }
    if let Some(stayed) = stayed {
        report.insert("kept".to_owned(), json!(stayed));
    }
    report.insert("notes".to_owned(), json!(notes));
    Value::Object(report)
}

/// How much the spots of a region were to vary and do; `None` where none was to.
fn spread(layer: &GrownLayer, place: [usize; 2], index: usize) -> Option<Value> {
    let asked = layer.plan.map.region(place).spread;
    if asked.is_even() {
        return None;
    }
    let mut spread = Map::new();
    spread.insert("asked".to_owned(), json!(asked));
    if let Measured::Spots { errors, .. } = &layer.measured
        && let Some(got) = errors[index].spread
    {
        spread.insert("got".to_owned(), json!(got));
    }
    Some(Value::Object(spread))
}

/// Lines round marks, or between them, are not `directed`: they run as these let them.
fn attributes(attributes: &Attributes, directed: bool) -> Value {
    match attributes {
        Attributes::Spots(spots) => json!(spots),
        Attributes::Stripes(stripes) if directed => json!(stripes),
        Attributes::Stripes(stripes) => json!({"width": stripes.width}),
    }
}

/// How many whole marks were measured (of spots), and their errors by attribute.
fn errors(measured: &Measured, index: usize) -> (Option<usize>, Map<String, Value>) {
    let (marks, named) = match measured {
        Measured::Spots { errors, .. } => {
            let e = &errors[index];
            let named =
                vec![("area", e.area), ("aspect", e.aspect), ("angle", e.angle), ("spacing", e.spacing)];
            (Some(e.marks), named)
        }
        Measured::Stripes(errors) => {
            let e = &errors[index];
            let named = [
                ("width", e.width),
                ("wavelength", e.wavelength),
                ("angle", e.angle),
                ("angle_rms", e.angle_rms),
            ];
            (None, named.to_vec())
        }
    };
    let error =
        named.into_iter().filter_map(|(name, value)| Some((name.to_owned(), json!(value?)))).collect();
    (marks, error)
}
