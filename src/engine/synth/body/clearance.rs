//! The border around the marks beneath that spots keep clear of.

use crate::grid::Domain;
use crate::rd::{ParameterField, Parameters, System};
use crate::surface::Surface;

/// The width of the border around the marks beneath on which spots do not grow either, pitches. Nothing spreads across the border of an
/// obstacle, so that spots come as near to it as half a spacing, half as near as to each other.
const CLEARANCE: f64 = 0.15;

/// The obstacles and what is beside them, for spots.
#[must_use]
pub fn with_clearance(maps: &ParameterField<Surface>, obstacles: &[bool], system: System) -> Vec<bool> {
    let Some(away) = (!obstacles.is_empty()).then(|| maps.domain.distances(obstacles)).flatten() else {
        return obstacles.to_vec();
    };
    let is_near = |(away, p): (&f64, &Parameters)| *away <= CLEARANCE * system.spacing(p);
    away.iter().zip(&maps.parameters).map(is_near).collect()
}
