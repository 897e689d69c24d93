//! The marks of a layer that are only half grown, as `measure` finds them.

use crate::attributes::{Attributes, Polarity};
use crate::measure::{FadedAxis, Spot, faded_axes, half_grown_spots};
use crate::synth::marks::grow::measured::Measured;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::pinned_correction::matches;
use crate::synth::marks::plan::Plan;
use crate::synth::marks::plan::pinned_marks::PinnedMark;

/// A spot of a layer with spread is too small if it has less than half the area of a spot that is this number of standard deviations
/// smaller than the mean: one spot in 160 is smaller than that by chance.
const DEVIATIONS: f64 = 2.5;

/// Marks that are only half grown.
#[derive(Clone, Debug, Default)]
pub struct HalfGrown {
    /// Pieces of the lines that grow: of the stripes, or of the gaps between them.
    pub lines: Vec<FadedAxis>,
    /// The centres of spots, px.
    pub spots: Vec<[f64; 2]>,
}

impl HalfGrown {
    /// The half-grown marks of `plan`; the spots `pinned` were drawn.
    #[must_use]
    pub fn new(plan: &Plan, pinned: &[PinnedMark], pattern: &Pattern, measured: &Measured) -> Self {
        match measured {
            Measured::Spots { marks, .. } => Self { spots: spots(plan, pinned, marks), lines: Vec::new() },
            Measured::Stripes(_) => Self { lines: lines(plan, pattern), spots: Vec::new() },
        }
    }

    /// Their number.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lines.len() + self.spots.len()
    }

    /// Their places, px.
    #[must_use]
    pub fn places(&self) -> Vec<[f64; 2]> {
        self.lines.iter().map(|line| line.at).chain(self.spots.iter().copied()).collect()
    }
}

fn lines(plan: &Plan, pattern: &Pattern) -> Vec<FadedAxis> {
    // Rings and webs may be broken on purpose, and their width decreases towards the breaks.
    if plan.curves().is_some() {
        return Vec::new();
    }
    let [nx, ny] = plan.lookup.grid.size;
    let mut field = pattern.field(nx, ny);
    if plan.lookup.polarity == Polarity::Negative {
        field.values.iter_mut().for_each(|value| *value = 1.0 - *value);
    }
    faded_axes(&field, &|at| line_width(plan, at))
}

/// Width of the lines that grow at a place; `None` near the marks beneath, where lines end.
fn line_width(plan: &Plan, at: [f64; 2]) -> Option<f64> {
    let width = plan.lines_at(at)?.width;
    let around = [[0.0, 0.0], [width, 0.0], [-width, 0.0], [0.0, width], [0.0, -width]];
    let is_beneath = |by: &[f64; 2]| plan.is_hidden([at[0] + by[0], at[1] + by[1]]);
    (!around.iter().any(is_beneath)).then_some(width)
}

fn spots(plan: &Plan, pinned: &[PinnedMark], marks: &[Spot]) -> Vec<[f64; 2]> {
    let layout = plan.lookup.map.layout();
    let own = matches(pinned, layout, marks);
    // A drawn spot is to have the size that was drawn.
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
