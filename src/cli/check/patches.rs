//! What would grow on a layer of patches.

use super::{described, drawn};
use crate::attributes::regions::Region;
use crate::cli::Error;
use crate::document::{Document, Layer};
use crate::points::patches::PATCHES;
use crate::synth::memory;
use crate::synth::plan::patches::PatchPlan;
use serde_json::{Value, json};
use std::fmt::Write;

/// What would grow on layer `index`, for people and as JSON.
pub(super) fn checked(document: &Document, index: usize, source: &str) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let plan = PatchPlan::read(document, index, source, size)?;
    let too_large = memory::check_patches(size, plan.grid.size).err();
    let too_large = too_large.map(|error| format!("cannot be grown on this machine: {error}"));
    let notes: Vec<String> = too_large.into_iter().chain(plan.notes.iter().cloned()).collect();
    let mut text = reach(&plan, index);
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {note}");
    }
    Ok((text, json(&document.layers[index], &plan, &notes)))
}

/// What patches would grow on a layer, and what was asked of each region that has marks.
fn json(layer: &Layer, plan: &PatchPlan, notes: &[String]) -> Value {
    let layout = plan.map.layout();
    let region = |(place, of_region): ([usize; 2], &Region)| {
        let raggedness = plan.wanted(layout.center(place)).raggedness;
        (of_region.marks > 0).then(|| {
            json!({"region": place, "marks": of_region.marks, "asked": plan.map.of_region(place),
                "raggedness": raggedness})
        })
    };
    let regions: Vec<Value> = plan.map.regions().filter_map(region).collect();
    json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible, "drawn": drawn(layer),
        "system": PATCHES.name, "cell": plan.px_a_cell(), "grid": plan.grid.size, "kept": plan.kept.len(),
        "regions": regions, "notes": notes})
}

/// What patches would grow, and what was asked of each region that has marks.
fn reach(plan: &PatchPlan, index: usize) -> String {
    let (layout, [nx, ny]) = (plan.map.layout(), plan.grid.size);
    let mut text =
        format!("layer {}: grown by patches on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for ([column, row], region) in plan.map.regions().filter(|(_, region)| region.marks > 0) {
        let wanted = plan.wanted(layout.center([column, row]));
        let asked = described(&plan.map.of_region([column, row]), false).replacen("spots", "patches", 1);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  region [{column}, {row}]: {asked}, raggedness {:.2}, {:.0} % of the canvas, by {} drawn",
            wanted.raggedness,
            100.0 * wanted.coverage(),
            region.marks
        );
    }
    if !plan.kept.is_empty() {
        let _ = writeln!(text, "  kept as drawn: {}", plan.kept.len());
    }
    text
}
