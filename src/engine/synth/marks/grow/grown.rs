//! Grown spots or stripes.

use std::sync::Arc;

use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::grow::measured::Measured;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::ragged_edges::Ragged;
use crate::synth::marks::plan::Plan;
use crate::synth::passes::Trace;

/// Grown spots or stripes.
#[derive(Clone)]
pub struct GrownMarks {
    /// The plan from which they grew.
    pub plan: Arc<Plan>,
    /// The corrections of the plan during the growth.
    pub corrections: Corrections,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
    /// Factors of the looked-up thresholds, by region.
    pub correction: Vec<f64>,
    /// Further factors of single spots, see [`Pattern::own`].
    pub own_levels: Vec<f64>,
    /// The measurements, by region.
    pub measured: Measured,
    /// Places of marks that are only half grown, px.
    pub half_grown: Vec<[f64; 2]>,
    /// The concentration that shows the marks as a share of the local peak, on the grid.
    pub marks: Field,
    /// The concentrations of each chemical on the grid, if the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
    /// Observations, changes and cost of each correcting pass.
    pub trace: Trace,
    /// The roughened edges, if they were asked for.
    pub ragged: Option<Arc<Ragged>>,
    /// The pattern of the stripes beneath under which its own stripes pass, if they cross any.
    pub crossed: Option<Arc<Field>>,
}

impl GrownMarks {
    /// The pattern at any size, without the parts that pass under stripes that it crosses.
    #[must_use]
    pub fn pattern(&self) -> Pattern<'_> {
        let mut pattern = self.whole_pattern();
        pattern.crossed = self.crossed.as_deref().map(Spline::new);
        pattern
    }

    /// The pattern at any size, including the parts that pass under stripes that it crosses.
    #[must_use]
    pub fn whole_pattern(&self) -> Pattern<'_> {
        let mut pattern = Pattern::new(&self.plan.lookup, &self.marks);
        pattern.correction.clone_from(&self.correction);
        pattern.own.clone_from(&self.own_levels);
        pattern.added = self.ragged.as_deref().map(|ragged| Spline::new(&ragged.added));
        pattern
    }
}
