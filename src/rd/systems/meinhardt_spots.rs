//! Meinhardt spots.
//!
//! ∂a/∂t = s(0.01 a²β/b − p₁a + p₃) + ∇·(Dₐ∇a)
//! ∂b/∂t = s(0.01 a²β − p₂b + p₃) + ∇·(D_b∇b)
//!
//! Meinhardt, "Models of biological pattern formation" (1982); in this form Turk (1991) and Phan & Grimm
//! (2006), appendix B. A spot is a peak of a. R = D_b/Dₐ sets how far apart spots of one size stand.

use crate::rd::kinetics::{Kinetics, Spread};
use crate::rd::vector::Number;

/// a and b.
pub struct MeinhardtSpots;

/// Decay of a.
const P1: f32 = 0.03;
/// Decay of b.
pub const P2: f32 = 0.04;
/// a and b are no less. Far from any spot both decay for ever; without a bound a² and b leave what 32 bits hold, and
/// a²/b has no value. So low that nothing is seen of it, and b so much above a that a²/b stays nothing.
const LEAST: [f32; 2] = [1e-17, 1e-12];
// β = 1 and p₃ = 0: noise in β makes spots uneven, p₃ > 0 thins them out (`facts.md` B).

impl Kinetics<2> for MeinhardtSpots {
    const SPREAD: [Spread; 2] = [Spread::Tensor(0), Spread::Tensor(1)];

    #[inline(always)]
    fn react<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        let source = V::of(0.01) * a * a;
        [source / b - V::of(P1) * a, source - V::of(P2) * b]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        [a.at_least(LEAST[0]), b.at_least(LEAST[1])]
    }
}

/// a in the middle of a spot. Fitted to `facts.md` B, within 4 % for R 10–200.
pub fn peak(ratio: f32) -> f32 {
    3.3 * libm::powf(ratio / 10.0, 0.765)
}

/// Mean distance between neighbours × √rate. Fitted to `facts.md` B.
pub fn spacing(ratio: f32) -> f64 {
    let r = f64::from(ratio);
    36.0 + 0.045 * (r - 15.0)
}

/// Area of a spot at half its peak × rate. `facts.md` B: area · R is the same within 5 % for R 12–30, 13 % more
/// at 50.
pub fn area(ratio: f32) -> f64 {
    1960.0 / f64::from(ratio)
}

/// Radius of a bell to begin from ÷ spacing: about that of the spot it becomes.
pub fn radius(ratio: f32) -> f64 {
    0.6 * libm::pow(f64::from(ratio), -0.45)
}

/// Concentrations to begin from, `bell` 1 in the middle of a spot to be and 0 far away (`facts.md` G). `peak` is
/// what [`peak`] says of the ratio there.
///
/// Where spots stand far `apart`, the ground has no a: out of their reach a decays as exp(−p₁/p₂·T), more slowly than b,
/// and the ground would turn into pattern once a/b = 3, at T = 15.
pub fn begin(bell: f32, peak: f32, apart: bool) -> [f32; 2] {
    [if apart { 0.0 } else { 0.02 } + peak * bell, 0.3]
}

/// No activator, and as much inhibitor as between spots.
pub const OBSTACLE: [f32; 2] = [0.0, 0.4];
