//! What would grow on a layer of a field of points.

use super::drawn;
use crate::cli::Error;
use crate::document::{Document, Layer, Points};
use crate::machine::free_memory;
use crate::synth::memory;
use crate::synth::plan::point_fields::FieldPlan;
use serde_json::{Value, json};
use std::fmt::Write;

/// What would grow on layer `index`, made of `points`, for people and as JSON.
pub(super) fn checked(
    document: &Document,
    index: usize,
    points: Points,
    source: &str,
) -> Result<(String, Value), Error> {
    let size = document.size.map(f64::from);
    let plan = FieldPlan::read(document, index, points, source, size)?;
    let too_large =
        memory::check_points(plan.expected_points(), size, plan.grid.size, Some(free_memory())).err();
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
fn honoured(plan: &FieldPlan) -> Vec<&'static str> {
    let drawn = plan.drawn > 0;
    let distance = drawn && plan.points.distance.is_none();
    let share = drawn && plan.points.share.is_none() && plan.share.is_some();
    [("spacing", distance), ("share", share)]
        .into_iter()
        .filter_map(|(name, honoured)| honoured.then_some(name))
        .collect()
}

fn json(layer: &Layer, plan: &FieldPlan, notes: &[String]) -> Value {
    let mut found = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible, "drawn": drawn(layer),
        "system": layer.system.name(), "honours": honoured(plan), "cell": plan.px_a_cell(), "grid": plan.grid.size,
        "points": {"labels": plan.points.labels.name(), "distance": plan.distances, "expected": plan.expected_points().round()},
        "notes": notes});
    if let Some(share) = plan.share {
        found["points"]["share"] = json!(share);
    }
    found
}

fn reach(plan: &FieldPlan, index: usize) -> String {
    let [nx, ny] = plan.grid.size;
    let [least, most] = plan.distances;
    let apart = if least == most { format!("{least:.1}") } else { format!("{least:.1} to {most:.1}") };
    let sketch = match (plan.drawn, honoured(plan).as_slice()) {
        (0, _) => "nothing is drawn".to_owned(),
        (drawn, []) => format!("nothing of the {drawn} drawn"),
        (drawn, honoured) => format!("{} by {drawn} drawn", honoured.join(" and ")),
    };
    let share =
        plan.share.map_or("as it comes".to_owned(), |share| format!("{:.0} % of the canvas", 100.0 * share));
    format!(
        "layer {}: a field of points on {nx} × {ny} cells of {:.2} px\n  about {:.0} points, {apart} px apart, labels {}; above the edge {share}; {sketch}\n",
        index + 1,
        plan.px_a_cell(),
        plan.expected_points(),
        plan.points.labels.name(),
    )
}
