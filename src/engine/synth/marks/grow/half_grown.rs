//! The marks of a layer that have grown by half, as `measure` finds them.

use crate::attributes::Attributes;
use crate::measure::{Spot, half_grown_axes, half_grown_spots};
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::pinned_correction::matches;
use crate::synth::marks::grow::refine::Measured;
use crate::synth::marks::plan::Plan;

/// Spots that vary are small where they are smaller than the mean by so many standard deviations, and half.
const DEVIATIONS: f64 = 2.5;

/// The places of marks of `plan`, px, that have grown by half.
#[must_use]
pub fn half_grown(plan: &Plan, pattern: &Pattern, measured: &Measured) -> Vec<[f64; 2]> {
    match measured {
        Measured::Spots { marks, .. } => spots(plan, marks),
        Measured::Stripes(_) => {
            let [nx, ny] = plan.lookup.grid.size;
            half_grown_axes(&pattern.field(nx, ny), &|at| width(plan, at))
        }
    }
}

/// Width of the stripes at a place; `None` beside the marks beneath, where stripes end.
fn width(plan: &Plan, at: [f64; 2]) -> Option<f64> {
    let Attributes::Stripes(stripes) = plan.lookup.map.at(at) else { return None };
    let width = stripes.width;
    let around = [[0.0, 0.0], [width, 0.0], [-width, 0.0], [0.0, width], [0.0, -width]];
    let is_beneath = |by: &[f64; 2]| plan.is_hidden([at[0] + by[0], at[1] + by[1]]);
    (!around.iter().any(is_beneath)).then_some(width)
}

fn spots(plan: &Plan, marks: &[Spot]) -> Vec<[f64; 2]> {
    let pinned = plan.pinned_spots();
    let layout = plan.lookup.map.layout();
    let own = matches(pinned, layout, marks);
    // A drawn spot is to be as large as it was drawn.
    let drawn = |at: [f64; 2]| {
        let index = own.iter().position(|spot| spot.is_some_and(|spot| marks[spot].ellipse.center == at))?;
        Some(pinned[index].visible.area)
    };
    let area = |at: [f64; 2]| {
        let Attributes::Spots(spots) = plan.lookup.map.at(at) else { return None };
        let spread = plan.lookup.map.spread_at(at).area;
        Some(drawn(at).unwrap_or((1.0 - DEVIATIONS * spread).max(0.0) * spots.area))
    };
    let mut found = half_grown_spots(marks, &area);
    found.retain(|at| !plan.is_hidden(*at));
    found
}
