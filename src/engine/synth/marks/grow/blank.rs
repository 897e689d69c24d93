//! Layers without a pattern.

use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::plan::Plan;
use crate::synth::pattern::EDGE;

/// Rows that are tested together.
const SEEN_AT_ONCE: usize = 64;

/// The content of a layer that has no marks, or only marks; `None` for a pattern.
pub fn blank(plan: &Plan, pattern: &Pattern) -> Option<&'static str> {
    let [nx, ny] = plan.lookup.grid.size;
    let (mut marks, mut ground) = (false, false);
    for first in (0..ny).step_by(SEEN_AT_ONCE) {
        let rows = first..ny.min(first + SEEN_AT_ONCE);
        for (cell, value) in (first * nx..).zip(pattern.rows(rows, nx, ny)) {
            let free = !plan.obstacles.get(cell).is_some_and(|taken| *taken);
            marks |= free && value >= EDGE;
            ground |= free && value < EDGE;
        }
        // True after the first rows of most patterns.
        if marks && ground {
            return None;
        }
    }
    match (marks, ground) {
        (false, _) => Some("no marks"),
        (true, false) if plan.obstacles.is_empty() => Some("marks without any ground between them"),
        _ => None,
    }
}
