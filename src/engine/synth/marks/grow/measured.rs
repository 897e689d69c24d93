//! Measurements of a layer of spots or stripes.

use crate::attributes::Attributes;
use crate::grid::Field;
use crate::measure::{self, MERGED_FILL, Spot, SpotErrors, StripeErrors, Target};
use crate::synth::marks::plan::laid_out::Plan;

/// Measurements of a layer, by region.
#[derive(Clone, Debug)]
pub enum Measured {
    /// A layer of spots.
    Spots {
        /// Errors by region.
        errors: Vec<SpotErrors>,
        /// All marks, also those cut by the border.
        marks: Vec<Spot>,
    },
    /// A layer of stripes.
    Stripes(Vec<StripeErrors>),
}

/// Measured points per cell of the grid along each side, if the canvas has more px than that: a spot of 48 cells then has 108
/// points, which give its area to 0.1 %.
const FINER: f64 = 1.5;

/// Measures `pattern`, a field of the canvas of `plan`, against the wanted attributes.
#[must_use]
pub fn measured(plan: &Plan, least_area: f64, pattern: &Field) -> Measured {
    if plan.lookup.system.is_striped() {
        return stripes_measured(plan, |target| measure::stripe_errors(pattern, 0.5, target));
    }
    spots_measured(plan, measure::spots_of_at_least(pattern, 0.5, least_area))
}

/// Spots with their errors.
pub(super) fn spots_measured(plan: &Plan, marks: Vec<Spot>) -> Measured {
    Measured::Spots { errors: plan.on_canvas(|target| measure::spot_errors(&marks, target)), marks }
}

/// Stripes with the errors that `measure` finds.
pub(super) fn stripes_measured(plan: &Plan, measure: impl FnOnce(&Target) -> Vec<StripeErrors>) -> Measured {
    let mut errors = plan.by_region(measure);
    if let Some(curves) = plan.curves() {
        errors.iter_mut().enumerate().for_each(|(index, errors)| curves.correct(index, errors));
    }
    Measured::Stripes(errors)
}

impl Measured {
    /// got ÷ wanted − 1 of area or width in region `index`.
    pub(super) fn size_error(&self, index: usize) -> Option<f64> {
        match self {
            Self::Spots { errors, .. } => errors[index].area,
            Self::Stripes(errors) => errors[index].width,
        }
    }

    /// All spots, also those cut by the border; none for stripes.
    #[must_use]
    pub fn spots(&self) -> &[Spot] {
        match self {
            Self::Spots { marks, .. } => marks,
            Self::Stripes(_) => &[],
        }
    }

    /// The whole spots of a layer grown from `plan` that are two merged ones; none for stripes.
    pub fn merged_spots(&self, plan: &Plan) -> impl Iterator<Item = &Spot> {
        // Irregular outlines fill a smaller part of their ellipses.
        let regular = plan.lookup.irregular == 0.0;
        self.spots().iter().filter(move |spot| regular && spot.whole && spot.fill < MERGED_FILL)
    }

    /// The attributes of the marks that grew in region `index`.
    #[must_use]
    pub fn got(&self, index: usize) -> Option<Attributes> {
        match self {
            Self::Spots { errors, .. } => errors[index].got.map(Attributes::Spots),
            Self::Stripes(errors) => errors[index].got.map(Attributes::Stripes),
        }
    }
}

/// Px at which a pattern on a canvas of `size` px is measured.
pub(super) fn measured_size(plan: &Plan, size: [usize; 2]) -> [usize; 2] {
    [0, 1].map(|axis| size[axis].min((FINER * plan.lookup.grid.size[axis] as f64).ceil() as usize))
}
