//! Grown layers of streaks and cracks.

use crate::grid::Field;
use crate::measure::StripeErrors;
use crate::synth::lines::plan::LinePlan;
use crate::synth::pattern::AreaPattern;

/// Shares of the area that the layers beneath left free.
#[derive(Clone, Copy, Debug)]
pub struct LineShare {
    /// The share that lines were to cover.
    pub asked: f64,
    /// The share that they cover.
    pub got: f64,
}

/// Grown streaks or cracks.
#[derive(Clone)]
pub struct GrownLines {
    /// The plan from which they grew.
    pub plan: LinePlan,
    /// 0..1, lines above ½, on the grid.
    pub field: Field,
    /// Errors by region.
    pub errors: Vec<StripeErrors>,
    /// Shares by region.
    pub shares: Vec<LineShare>,
}

impl GrownLines {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> AreaPattern {
        AreaPattern::new(&self.field)
    }
}
