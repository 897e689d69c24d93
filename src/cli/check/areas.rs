//! What would grow on a layer of patches or cells.

use super::{described, drawn};
use crate::attributes::regions::Region;
use crate::cli::Error;
use crate::document::{AreaKind, Document, Layer};
use crate::machine::free_memory;
use crate::synth::plan::areas::{AreaForm, AreaPlan, rows_of_cells};
use crate::synth::{Training, memory};
use serde_json::{Value, json};
use std::fmt::Write;

/// What would grow on layer `index`, for people and as JSON.
pub(super) fn checked(
    document: &Document,
    index: usize,
    source: &str,
    training: &Training,
) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let rows = rows_of_cells(document, index, training).map_err(Error::step)?;
    let plan = AreaPlan::read(document, index, source, size, rows)?;
    let too_large = memory::check_areas(plan.kind(), size, plan.grid.size, Some(free_memory())).err();
    let too_large = too_large.map(|error| format!("cannot be grown on this machine: {error}"));
    let notes: Vec<String> = too_large.into_iter().chain(plan.notes.iter().cloned()).collect();
    let mut text = reach(&plan, index);
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {note}");
    }
    Ok((text, json(&document.layers[index], &plan, &notes)))
}

/// What areas would grow on a layer, and what was asked of each region that has marks.
fn json(layer: &Layer, plan: &AreaPlan, notes: &[String]) -> Value {
    let layout = plan.map.layout();
    let region = |(place, of_region): ([usize; 2], &Region)| {
        let raggedness = plan.wanted(layout.center(place)).raggedness;
        (of_region.marks > 0).then(|| {
            let mut region =
                json!({"region": place, "marks": of_region.marks, "asked": plan.asked_of_region(place)});
            if plan.kind() == AreaKind::Patches {
                region["raggedness"] = json!(raggedness);
            }
            region
        })
    };
    let regions: Vec<Value> = plan.map.regions().filter_map(region).collect();
    let mut found = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible, "drawn": drawn(layer),
        "system": plan.kind().description().name, "cell": plan.px_a_cell(), "grid": plan.grid.size, "kept": plan.kept.len(),
        "regions": regions, "notes": notes});
    if let AreaForm::Cells(cells) = &plan.form {
        found["gap"] = json!(cells.gap);
    }
    found
}

/// What areas would grow, and what was asked of each region that has marks.
fn reach(plan: &AreaPlan, index: usize) -> String {
    let (layout, [nx, ny]) = (plan.map.layout(), plan.grid.size);
    let name = plan.kind().description().name;
    let mut text =
        format!("layer {}: grown by {name} on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for ([column, row], region) in plan.map.regions().filter(|(_, region)| region.marks > 0) {
        let wanted = plan.wanted(layout.center([column, row]));
        let asked = described(&plan.asked_of_region([column, row]), false).replacen("spots", name, 1);
        // Writing to a String cannot fail.
        let form = match &plan.form {
            AreaForm::Patches(_) => {
                format!(
                    "raggedness {:.2}, {:.0} % of the canvas",
                    wanted.raggedness,
                    100.0 * wanted.coverage()
                )
            }
            AreaForm::Cells(cells) => format!("lines of {:.1} px between them", cells.gap),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  region [{column}, {row}]: {asked}, {form}, by {} drawn", region.marks);
    }
    if !plan.kept.is_empty() {
        let _ = writeln!(text, "  kept as drawn: {}", plan.kept.len());
    }
    text
}
