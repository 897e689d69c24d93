//! What would grow on a layer that a picture drives, or a growth.

use super::drawn;
use crate::cli::Error;
use crate::document::{Document, Layer};
use crate::machine::free_memory;
use crate::synth::memory::TooLarge;
use crate::synth::plan::tone::{TonePlan, TonePlanError};
use crate::synth::{GrowError, Training};
use serde_json::{Value, json};

/// What would grow on layer `index`, which a picture or a growth drives, for people and as JSON.
pub(super) fn checked(
    document: &Document,
    index: usize,
    source: &str,
    training: &Training,
) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let plan = TonePlan::read(document, index, source, size, (training, Some(free_memory())));
    let plan = match plan {
        Err(TonePlanError::TooLarge(error)) => return Ok(too_large(&document.layers[index], index, &error)),
        plan => plan.map_err(|error| Error::grown(GrowError::from(error)))?,
    };
    let layer = &document.layers[index];
    let mut json = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible,
        "drawn": drawn(layer), "system": plan.system.name(), "inverted": false, "cell": plan.px_a_cell(),
        "grid": plan.grid.size, "notes": []});
    if let Some(tone) = &layer.tone {
        json["tone"] = json!({"image": tone.image.size(), "range": tone.range, "drives": tone.drives.names(),
            "sketch": tone.sketch, "equalise": tone.equalise, "wavelength": plan.wavelength});
    }
    if let Some([least, most]) = growth_range(&plan) {
        json["growth"] = json!({"range": [least, most], "wavelength": plan.wavelength});
    }
    Ok((reach(layer, &plan, index), json))
}

/// The lowest and the highest growth; `None` of systems without.
fn growth_range(plan: &TonePlan) -> Option<[f32; 2]> {
    let values = plan.growth.iter().copied();
    Some([values.clone().reduce(f32::min)?, values.reduce(f32::max)?])
}

/// What is said of a layer that does not fit into memory.
fn too_large(layer: &Layer, index: usize, error: &TooLarge) -> (String, Value) {
    let note = format!("cannot be grown on this machine: {error}");
    let json = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible,
        "drawn": drawn(layer), "grid": error.grid, "notes": [note]});
    (format!("layer {}: {note}\n", index + 1), json)
}

fn reach(layer: &Layer, plan: &TonePlan, index: usize) -> String {
    let [nx, ny] = plan.grid.size;
    let mut text = format!(
        "layer {}: grown by {} on {nx} × {ny} cells of {:.2} px\n",
        index + 1,
        plan.system.name(),
        plan.px_a_cell()
    );
    let apart = plan.wavelength;
    if let Some(tone) = &layer.tone {
        let [width, height] = tone.image.size();
        let [white, black] = tone.range.map(|share| 100.0 * share);
        let equalised = if tone.equalise { ", equalised" } else { "" };
        let drives = tone.drives.names().join(", ");
        text += &format!(
            "  a picture of {width} × {height} px{equalised} drives its {drives}: {white:.0} % ink at white to {black:.0} % at black, marks {apart:.1} px apart\n"
        );
    }
    if let Some([least, most]) = growth_range(plan) {
        text += &format!("  a growth from {least:.1} to {most:.1}, marks {apart:.1} px apart\n");
    }
    text
}
