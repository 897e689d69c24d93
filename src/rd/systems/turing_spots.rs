//! Turing spots.
//!
//! ∂a/∂t = kₐ(16 − ab) + ∇·(Dₐ∇a)
//! ∂b/∂t = kₐ(ab − b − β) + ∇·(D_b∇b), b ≥ 0
//!
//! Turing, "The chemical basis of morphogenesis" (1952); in this form Turk, "Generating textures on arbitrary
//! surfaces using reaction-diffusion" (1991), and Phan & Grimm, "Sketching reaction-diffusion texture"
//! (2006), appendix A. A spot is where b runs out. Its size and the spacing go together: area ≈ 0.22
//! spacing². a stays above 2 in patterns; it is held at 0 as well, for at rates of 0.38 and more the first spots of a canvas
//! with room for one or two can hold so much b that a step of a overshoots.

use crate::rd::kinetics::{Kinetics, Spread};
use crate::rd::vector::Number;

/// a and b.
pub struct TuringSpots;

/// Growth of a: 16, as printed.
const GROWTH: f32 = 16.0;
/// Decay of b, the same over the grid unless spots are to be irregular: [`UnevenTuringSpots`].
pub const BETA: f32 = 12.0;

/// Dₐ/D_b. `facts.md` A: well-formed spots at 3.6–4.0, roundest below 3.8.
pub const RATIO: f32 = 3.8;
/// Mean distance between neighbours × √(kₐ/√(DₐD_b)). Measured: see `facts.md` A (2.10 √5.7).
pub const SPACING: f64 = 5.0;

impl Kinetics<2> for TuringSpots {
    const SPREAD: [Spread; 2] = [Spread::Tensor(0), Spread::Tensor(1)];

    #[inline(always)]
    fn react<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        let ab = a * b;
        [V::of(GROWTH) - ab, ab - b - V::of(BETA)]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        [a.at_least(0.0), b.at_least(0.0)]
    }
}

/// a, b and β, which differs from place to place and stays as it is.
pub struct UnevenTuringSpots;

impl Kinetics<3> for UnevenTuringSpots {
    const SPREAD: [Spread; 3] = [Spread::Tensor(0), Spread::Tensor(1), Spread::Still];

    #[inline(always)]
    fn react<V: Number>([a, b, beta]: [V; 3]) -> [V; 3] {
        let ab = a * b;
        [V::of(GROWTH) - ab, ab - b - beta, V::of(0.0)]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b, beta]: [V; 3]) -> [V; 3] {
        [a.at_least(0.0), b.at_least(0.0), beta]
    }
}

/// Concentrations to begin from, `bell` 1 in the middle of a spot to be and 0 far away (`facts.md` G).
pub fn begin(bell: f32) -> [f32; 2] {
    [3.3 + 4.0 * bell, (5.6 * (1.0 - 1.3 * bell)).max(0.0)]
}

/// Radius of a bell to begin from ÷ spacing: about that of the spot it becomes.
pub const RADIUS: f64 = 0.26;

/// Where the concentration `a` lies between the ground (0) and the middle of a spot (1): a runs from 3.0 to
/// 7.5 in settled patterns of 20 to 300 cells a spot.
pub fn share(a: f32) -> f32 {
    (a - 3.0) / 4.5
}

/// Area of a spot × rate (`facts.md` A).
pub const AREA: f64 = 5.7;

/// The middle of a spot, which keeps others away (`facts.md` G, cheetah).
pub const OBSTACLE: [f32; 2] = [7.3, 0.0];
