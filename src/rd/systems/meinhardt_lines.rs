//! Meinhardt lines: thin stripes on wide ground.
//!
//! ∂a/∂t = s(0.01 a²/b − p₁a) + ∇·(Dₐ∇a)
//! ∂b/∂t = s(0.01 a² − p₂b) + D_b∇²b
//!
//! The kinetics of [`crate::rd::systems::meinhardt_spots`], but only the activator feels the tensor: where it spreads farther along
//! than across, spots grow together to lines along its long axis (`facts.md` D, "oriented thin stripes"). Between the
//! lines a is next to nothing, and nothing begins there by itself: lines stand where they were begun. R = D_b/Dₐ sets
//! how wide they are beside their distance.

use crate::rd::kinetics::{Kinetics, Spread};
use crate::rd::systems::meinhardt_spots::MeinhardtSpots;
use crate::rd::vector::Number;

/// a and b.
pub struct MeinhardtLines;

impl Kinetics<2> for MeinhardtLines {
    const SPREAD: [Spread; 2] = [Spread::Tensor(0), Spread::Isotropic(1)];

    #[inline(always)]
    fn react<V: Number>(u: [V; 2]) -> [V; 2] {
        MeinhardtSpots::react(u)
    }

    #[inline(always)]
    fn bounded<V: Number>(u: [V; 2]) -> [V; 2] {
        MeinhardtSpots::bounded(u)
    }
}

/// a along the middle of a line. Fitted to straight lines at their own distance, R 10–36, within 2 %; where a line ends a
/// is higher by up to a tenth.
pub fn peak(ratio: f32) -> f32 {
    2.23 * libm::powf(ratio / 10.0, 0.458)
}

/// Distance from line to line × √rate, the rate being s/√(DₐD_b) with Dₐ that across the lines.
///
/// Lines stay where they begin, so that any distance is the system's own. At this one they leave the least ends: nearer
/// ones (31 at all ratios) go out here and there, and lines of higher ratios, which are thinner at the same distance,
/// break into pieces: at R = 60 and 38, 21 of them where R = 30 and 53 has 3.
pub fn wavelength(ratio: f32) -> f64 {
    32.0 * libm::pow(f64::from(ratio) / 12.0, 0.55)
}

/// Width of a line at half its peak × √rate. Fitted as [`peak`] is.
pub fn width(ratio: f32) -> f64 {
    14.8 * libm::pow(f64::from(ratio) / 10.0, -0.37)
}

/// Concentrations to begin from, `crest` 1 along the middle of a line to be and 0 far away. `peak` is what [`peak`] says
/// of the ratio there.
pub fn begin(crest: f32, peak: f32) -> [f32; 2] {
    [0.02 + peak * crest, 0.3]
}

/// No activator, and as much inhibitor as between lines.
pub const OBSTACLE: [f32; 2] = [0.0, 0.4];
