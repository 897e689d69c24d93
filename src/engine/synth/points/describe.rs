//! The output of `check` for a field of points.

use serde_json::json;

use crate::synth::kind::{Described, Request};
use crate::synth::points::plan::FieldPlan;

/// A description of the layer that would grow, and of the attributes of the sketch that it follows.
pub(super) fn described(plan: &FieldPlan, request: &Request, mut notes: Vec<String>) -> Described {
    notes.extend(plan.notes.iter().cloned());
    let mut json = json!({"system": request.document.layers[request.index].system.name(),
        "honours": honoured(plan), "cell": plan.px_a_cell(), "grid": plan.grid.size,
        "points": {"labels": plan.points.labels.name(), "distance": plan.distances,
            "expected": plan.expected_points().round()},
        "notes": notes});
    if let Some(share) = plan.share {
        json["points"]["share"] = json!(share);
    }
    Described::new(reach(plan, request.index), notes, json)
}

/// The attributes of the sketch that the growth follows.
fn honoured(plan: &FieldPlan) -> Vec<&'static str> {
    let drawn = plan.drawn > 0;
    let distance = drawn && plan.points.distance.is_none();
    let share = drawn && plan.points.share.is_none() && plan.share.is_some();
    [("spacing", distance), ("share", share)]
        .into_iter()
        .filter_map(|(name, honoured)| honoured.then_some(name))
        .collect()
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
