//! How large errors may be, once a set is full.

use super::way::Way;
use crate::rd::System;

/// Median and 95th percentile that are allowed, by attribute: % of area, spacing, width and wavelength, degrees of angle.
pub type Bounds = &'static [(&'static str, [f64; 2])];

/// What is allowed of what grows anew.
pub fn bounds(system: System, way: Way) -> Bounds {
    match (way, system) {
        (Way::REGRESSION, System::TuringSpots) => &[("area", [1.5, 5.0]), ("angle", [1.0, 3.0])],
        (Way::REGRESSION, System::MeinhardtSpots) => {
            &[("area", [3.0, 8.0]), ("spacing", [2.5, 7.0]), ("aspect", [0.008, 0.03]), ("angle", [0.5, 1.5])]
        }
        (Way::REGRESSION, System::MeinhardtStripes) => &[("width", [2.0, 6.0]), ("angle", [1.5, 4.0])],
        (Way::REGRESSION, System::MeinhardtLines) => {
            &[("width", [2.0, 6.0]), ("wavelength", [2.5, 7.0]), ("angle", [1.5, 4.0])]
        }
        (Way::Refined, System::TuringSpots) => {
            &[("area", [0.5, 1.5]), ("spacing", [1.5, 5.0]), ("aspect", [0.006, 0.02]), ("angle", [0.8, 2.5])]
        }
        (Way::Refined, System::MeinhardtSpots) => {
            &[("area", [0.5, 1.5]), ("spacing", [1.5, 5.0]), ("aspect", [0.006, 0.02]), ("angle", [0.4, 1.2])]
        }
        (Way::Refined, System::MeinhardtStripes) => &[("width", [1.0, 3.0])],
        (Way::Refined, System::MeinhardtLines) => &[("width", [1.0, 3.0]), ("wavelength", [2.5, 7.0])],
        _ => &[],
    }
}
