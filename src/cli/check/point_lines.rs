//! What would grow on a layer of streaks or cracks.

use super::drawn;
use crate::cli::Error;
use crate::document::{Document, Layer, LineKind};
use crate::machine::free_memory;
use crate::synth::memory;
use crate::synth::plan::point_lines::LinePlan;
use serde_json::{Value, json};
use std::fmt::Write;

/// What would grow on layer `index` by `kind`, for people and as JSON.
pub(super) fn checked(
    document: &Document,
    index: usize,
    kind: LineKind,
    source: &str,
) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let plan = LinePlan::read(document, index, kind, source, size)?;
    let too_large = memory::check_lines(size, plan.grid.size, Some(free_memory())).err();
    let too_large = too_large.map(|error| format!("cannot be grown on this machine: {error}"));
    let notes: Vec<String> = too_large.into_iter().chain(plan.notes.iter().cloned()).collect();
    let mut text = reach(&plan, index);
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {note}");
    }
    Ok((text, json(&document.layers[index], &plan, &notes)))
}

/// What of the sketch decides what grows.
fn honoured(kind: LineKind) -> &'static [&'static str] {
    match kind {
        LineKind::Streaks => &["width", "wavelength", "angle"],
        LineKind::Cracks => &["width", "share"],
    }
}

fn json(layer: &Layer, plan: &LinePlan, notes: &[String]) -> Value {
    let layout = plan.map.layout();
    let region = |index: usize| {
        let place = layout.place(index);
        let (asked, share) = (plan.asked_of_region(place), plan.wanted_of_region(place).share);
        json!({"region": place, "marks": plan.map.region(place).marks, "asked": asked, "share": share})
    };
    let regions: Vec<Value> = (0..layout.len()).map(region).collect();
    json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible, "drawn": drawn(layer),
        "system": plan.kind.description().name, "honours": honoured(plan.kind), "cell": plan.px_a_cell(), "grid": plan.grid.size,
        "regions": regions, "notes": notes})
}

fn reach(plan: &LinePlan, index: usize) -> String {
    let (layout, [nx, ny]) = (plan.map.layout(), plan.grid.size);
    let name = plan.kind.description().name;
    let mut text =
        format!("layer {}: grown by {name} on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for ([column, row], region) in plan.map.regions().filter(|(_, region)| region.marks > 0) {
        let wanted = plan.wanted_of_region(layout.place(layout.index([column, row])));
        let course = match plan.kind {
            LineKind::Streaks => format!(" along {:.0}°", wanted.angle),
            LineKind::Cracks => " whatever their direction".to_owned(),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  region [{column}, {row}]: {name} {:.1} px wide{course}, {:.0} % of the canvas, by {} drawn",
            wanted.width,
            100.0 * wanted.share,
            region.marks
        );
    }
    text
}
