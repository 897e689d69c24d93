//! The output of `check` for a layer that a picture or Turing's growth drives.

use serde_json::json;

use crate::document::Layer;
use crate::synth::kind::{Described, Request};
use crate::synth::tone::plan::TonePlan;

/// A description of the layer that would grow, and of what drives it.
pub(super) fn described(plan: &TonePlan, request: &Request, notes: Vec<String>) -> Described {
    let layer = &request.document.layers[request.index];
    let mut json = json!({"system": plan.system.name(), "inverted": false, "cell": plan.px_a_cell(),
        "grid": plan.grid.size, "notes": notes});
    if let Some(tone) = &layer.tone {
        json["tone"] = json!({"image": tone.image.size(), "range": tone.range, "drives": tone.drives.names(),
            "sketch": tone.sketch, "equalise": tone.equalise, "wavelength": plan.wavelength});
    }
    if let Some([least, most]) = growth_range(plan) {
        json["growth"] = json!({"range": [least, most], "wavelength": plan.wavelength});
    }
    Described::new(reach(layer, plan, request.index), notes, json)
}

/// The lowest and the highest G; `None` for systems without this parameter.
fn growth_range(plan: &TonePlan) -> Option<[f32; 2]> {
    let values = plan.growth.iter().copied();
    Some([values.clone().reduce(f32::min)?, values.reduce(f32::max)?])
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
