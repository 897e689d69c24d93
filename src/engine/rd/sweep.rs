//! Quantities that the sweeps of several systems vary.

use crate::rd::definition::SweepQuantity;
use crate::rd::selling::MIN_STRETCH;

const fn quantity(name: &'static str, unit: &'static str, allowed: [f64; 2]) -> SweepQuantity {
    SweepQuantity { name, unit, allowed }
}

/// Area of a spot.
pub const AREA: SweepQuantity = quantity("area", "cells", [1.0, 2_000.0]);
/// Width of a stripe.
pub const WIDTH: SweepQuantity = quantity("width", "cells", [1.0, 100.0]);
/// Diffusion rate of the inhibitor ÷ the activator's.
pub const RATIO: SweepQuantity = quantity("ratio", "Db/Da", [1.0, 1_000.0]);
/// Threshold of a mark's edge, as a share of the peak.
pub const LEVEL: SweepQuantity = quantity("level", "of the peak", [0.02, 0.98]);
/// Minor ÷ major axis of the tensor; thinner tensors than [`MIN_STRETCH`] do not fit the stencil.
pub const STRETCH: SweepQuantity = quantity("stretch", "minor/major", [0.13, 1.0]);
/// Direction of the long axis of the tensor.
pub const DIRECTION: SweepQuantity = quantity("direction", "degrees", [0.0, 180.0]);

const _: () = assert!(MIN_STRETCH == 0.13);
