//! What would grow on a layer that a picture drives.

use super::drawn;
use crate::cli::Error;
use crate::document::{Document, Tone};
use crate::synth::plan::tone::TonePlan;
use crate::synth::{GrowError, Training, memory};
use serde_json::{Value, json};
use std::fmt::Write;

/// What would grow on layer `index`, which `tone` drives, for people and as JSON.
pub(super) fn checked(
    document: &Document,
    index: usize,
    tone: &Tone,
    source: &str,
    training: &Training,
) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let plan = TonePlan::read(document, index, tone, source, size, training);
    let plan = plan.map_err(|error| Error::grown(GrowError::from(error)))?;
    let too_large = memory::check(plan.system, size, plan.grid.size).err();
    let notes: Vec<String> =
        too_large.iter().map(|error| format!("cannot be grown on this machine: {error}")).collect();
    let mut text = reach(tone, &plan, index);
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {note}");
    }
    let layer = &document.layers[index];
    let json = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible,
        "drawn": drawn(layer), "system": plan.system.name(), "inverted": false, "cell": plan.px_a_cell(),
        "grid": plan.grid.size, "notes": notes,
        "tone": {"image": tone.image.size(), "range": tone.range, "drives": tone.drives.names(),
            "sketch": tone.sketch, "equalise": tone.equalise, "wavelength": plan.wavelength}});
    Ok((text, json))
}

fn reach(tone: &Tone, plan: &TonePlan, index: usize) -> String {
    let [nx, ny] = plan.grid.size;
    let [width, height] = tone.image.size();
    let [white, black] = tone.range.map(|share| 100.0 * share);
    let equalised = if tone.equalise { ", equalised" } else { "" };
    format!(
        "layer {}: grown by {} on {nx} × {ny} cells of {:.2} px\n  a picture of {width} × {height} px{equalised} drives its {}: {white:.0} % ink at white to {black:.0} % at black, marks {:.1} px apart\n",
        index + 1,
        plan.system.name(),
        plan.px_a_cell(),
        tone.drives.names().join(", "),
        plan.wavelength
    )
}
