//! How large errors may be, once a set is full.

use super::way::Way;
use crate::rd::{Bounds, System};

/// What is allowed of what grows anew.
pub fn bounds(system: System, way: Way) -> Bounds {
    let bounds = system.definition().error_bounds;
    match way {
        Way::REGRESSION => bounds.looked_up,
        Way::Refined => bounds.refined,
        Way::Learnt(_) => &[],
    }
}
