//! The allowed errors of complete training sets.

use super::way::Way;
use crate::rd::{Bounds, System};

/// The allowed errors of new growths.
pub fn bounds(system: System, way: Way) -> Bounds {
    let bounds = system.definition().error_bounds;
    match way {
        Way::REGRESSION => bounds.looked_up,
        Way::Refined => bounds.refined,
        Way::Learnt(_) => &[],
    }
}
