//! The report of a growth, layer by layer.

use crate::document::Document;
use crate::synth::drawn::is_replaced;
use crate::synth::growth::Grown;
use crate::synth::layer::GrownLayer;
use crate::synth::one_value::{note_on_layer, note_on_picture};
use crate::synth::report::{LayerReport, Report};

/// The report of `grown`, the growth of `document`, whose file is named `source`.
#[must_use]
pub fn report(document: &Document, source: &str, grown: &Grown, seconds: f64) -> Report {
    Report {
        document: source.to_owned(),
        size: grown.size,
        seed: document.seed,
        seconds,
        layers: layer_reports(document, grown),
    }
}

/// The reports of all layers of `document`. If the picture has a single colour, the note is on the uppermost layer.
#[must_use]
pub fn layer_reports(document: &Document, grown: &Grown) -> Vec<LayerReport> {
    let layers = grown.layers.iter().enumerate().take(document.layers.len());
    let mut reports: Vec<_> = layers.map(|(index, layer)| layer_report(document, index, layer)).collect();
    if let Some(top) = reports.last_mut() {
        top.notes.extend(note_on_picture(document, grown));
    }
    reports
}

/// The report of layer `index` of `document`.
fn layer_report(document: &Document, index: usize, layer: &GrownLayer) -> LayerReport {
    let mut report = LayerReport {
        name: document.layers[index].name.clone(),
        system: layer.system().name,
        inverted: false,
        cell: layer.px_a_cell(),
        grid: layer.grid(),
        steps: layer.steps(),
        settled: layer.settled(),
        regions: Vec::new(),
        threads: Vec::new(),
        points: None,
        tone: None,
        growth: None,
        drawn: layer.drawn(),
        notes: Vec::new(),
        note_on_drawn: None,
        merged: Vec::new(),
        half_grown: Vec::new(),
        shown: is_replaced(document, index).then_some(false),
        gap: None,
        blotches: None,
        share: None,
    };
    layer.report(document, index, &mut report);
    report.notes.extend(note_on_layer(layer));
    report
}
