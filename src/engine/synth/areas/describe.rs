//! The output of `check` for a layer of patches or cells.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::attributes::regions::Region;
use crate::document::AreaKind;
use crate::synth::areas::plan::{AreaForm, AreaPlan};
use crate::synth::kind::{Described, Request, in_words};

/// A description of the areas that would grow, and of what was asked of each region that has marks.
pub(super) fn described(plan: &AreaPlan, request: &Request, mut notes: Vec<String>) -> Described {
    notes.extend(plan.notes.iter().cloned());
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
    let mut json = json!({"system": plan.kind().description().name, "cell": plan.px_a_cell(),
        "grid": plan.grid.size, "kept": plan.kept.len(), "regions": regions, "notes": notes});
    if let AreaForm::Polygons(cells) = &plan.form {
        json["gap"] = json!(cells.gap);
    }
    Described::new(reach(plan, request.index), notes, json)
}

/// The areas that would grow, and what was asked of each region that has marks, as text.
fn reach(plan: &AreaPlan, index: usize) -> String {
    let (layout, [nx, ny]) = (plan.map.layout(), plan.grid.size);
    let name = plan.kind().description().name;
    let mut text =
        format!("layer {}: grown by {name} on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for ([column, row], region) in plan.map.regions().filter(|(_, region)| region.marks > 0) {
        let wanted = plan.wanted(layout.center([column, row]));
        let asked = in_words(&plan.asked_of_region([column, row]), false).replacen("spots", name, 1);
        // Writing to a String cannot fail.
        let form = match &plan.form {
            AreaForm::Patches(_) => {
                format!(
                    "raggedness {:.2}, {:.0} % of the canvas",
                    wanted.raggedness,
                    100.0 * wanted.coverage()
                )
            }
            AreaForm::Polygons(cells) => format!("lines of {:.1} px between them", cells.gap),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  region [{column}, {row}]: {asked}, {form}, by {} drawn", region.marks);
    }
    if !plan.kept.is_empty() {
        let _ = writeln!(text, "  kept as drawn: {}", plan.kept.len());
    }
    text
}
