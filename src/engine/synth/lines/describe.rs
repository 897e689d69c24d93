//! The output of `check` for a layer of streaks or cracks.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::document::LineKind;
use crate::synth::kind::{Described, Request};
use crate::synth::lines::plan::LinePlan;

/// A description of the lines that would grow, and of what was asked of each region.
pub(super) fn described(plan: &LinePlan, request: &Request, mut notes: Vec<String>) -> Described {
    notes.extend(plan.notes.iter().cloned());
    let layout = plan.map.layout();
    let region = |index: usize| {
        let place = layout.place(index);
        let (asked, share) = (plan.asked_of_region(place), plan.wanted_of_region(place).share);
        json!({"region": place, "marks": plan.map.region(place).marks, "asked": asked, "share": share})
    };
    let regions: Vec<Value> = (0..layout.len()).map(region).collect();
    let json = json!({"system": plan.kind.description().name, "honours": honoured(plan.kind),
        "cell": plan.px_a_cell(), "grid": plan.grid.size, "regions": regions, "notes": notes});
    Described::new(reach(plan, request.index), notes, json)
}

/// The attributes of the sketch that the growth follows.
fn honoured(kind: LineKind) -> &'static [&'static str] {
    match kind {
        LineKind::Streaks => &["width", "wavelength", "angle"],
        LineKind::Cracks => &["width", "share"],
    }
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
