//! The output of `check` for a layer of pairs.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::attributes::Stripes;
use crate::synth::kind::{Described, Request};
use crate::synth::pairs::plan::PairPlan;

/// A description of the layer that would grow, and of what was asked of each direction.
pub(super) fn described(plan: &PairPlan, request: &Request, mut notes: Vec<String>) -> Described {
    notes.extend(plan.notes.iter().cloned());
    let threads = plan.threads.iter();
    let threads = threads.map(|threads| json!({"lines": threads.lines.len(), "asked": threads.mean()}));
    let json = json!({"system": plan.kind().description().name, "cell": plan.px_a_cell(), "grid": plan.grid.size,
        "threads": threads.collect::<Vec<Value>>(), "notes": notes});
    Described::new(reach(plan, request.index), notes, json)
}

/// The layer that would grow, and what was asked of each direction, as text.
fn reach(plan: &PairPlan, index: usize) -> String {
    let [nx, ny] = plan.grid.size;
    let name = plan.kind().description().name;
    let mut text =
        format!("layer {}: grown by {name} on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for threads in &plan.threads {
        let Stripes { width, angle, wavelength } = threads.mean();
        let apart = wavelength.unwrap_or_default();
        let lines = threads.lines.len();
        let plural = if lines == 1 { "" } else { "s" };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  threads {width:.1} px wide at {angle:.0}°, {apart:.1} px apart, by {lines} line{plural}"
        );
    }
    text
}
