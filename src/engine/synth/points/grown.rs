//! Grown layers of fields of points.

use crate::grid::Field;
use crate::synth::pattern::AreaPattern;
use crate::synth::points::plan::FieldPlan;

/// A grown field of points.
#[derive(Clone)]
pub struct GrownPoints {
    /// The plan from which it grew.
    pub plan: FieldPlan,
    /// 0..1 on the grid; edges at ½.
    pub field: Field,
    /// Points of all octaves.
    pub points: usize,
    /// The share above the edge, of the area that the layers beneath left free, 0..1.
    pub share: f64,
}

impl GrownPoints {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> AreaPattern {
        AreaPattern::new(&self.field)
    }
}
