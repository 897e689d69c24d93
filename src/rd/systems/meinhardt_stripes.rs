//! Meinhardt stripes: two activators that exclude each other and help each other at a distance.
//!
//! ∂a/∂t = 0.01 a²e/c − k_ab a + ∇·(Dₐ∇a)
//! ∂b/∂t = 0.01 b²d/c − k_ab b + ∇·(Dₐ∇b)
//! ∂c/∂t = 0.01 a²e + 0.01 b²d − k_c c
//! ∂d/∂t = k_de(a − d) + D_d∇²d
//! ∂e/∂t = k_de(b − e) + D_d∇²e
//!
//! Meinhardt (1982); in this form Turk (1991) and Phan & Grimm (2006), appendix C. All reactions share one
//! rate factor s, so that s/Dₐ alone sets the width. Only a and b feel the tensor: with d and e isotropic,
//! stripes run along its long axis (`facts.md` E).

use crate::rd::kinetics::{Kinetics, Spread};
use crate::rd::vector::Number;

/// a, b, c, d, e.
pub struct MeinhardtStripes;

/// Decay of the activators.
pub const K_AB: f32 = 0.04;
/// Decay of the shared inhibitor. The published 0.06 (1.5 k_ab) bursts; 2 k_ab settles (`facts.md` C).
const K_C: f32 = 0.08;
/// Exchange with the helpers.
const K_DE: f32 = 0.04;
/// D_d/Dₐ. `facts.md` C: the wavelength hardly depends on it between 3 and 5; 5 is where its law was fitted.
pub const RATIO: f32 = 5.0;

/// Concentrations at rest: a = b = d = e = k_c/(2 k_ab), c = 0.02 a³/k_c.
pub const REST: [f32; 5] = {
    let a = K_C / (2.0 * K_AB);
    [a, a, 0.02 * a * a * a / K_C, a, a]
};

/// Concentrations on a seed: a raised, b lowered (`facts.md` E).
pub const SEED: [f32; 5] = [1.5, 0.6, REST[2], REST[3], REST[4]];

impl Kinetics<5> for MeinhardtStripes {
    const SPREAD: [Spread; 5] =
        [Spread::Tensor(0), Spread::Tensor(0), Spread::Still, Spread::Isotropic(1), Spread::Isotropic(1)];

    #[inline(always)]
    fn react<V: Number>([a, b, c, d, e]: [V; 5]) -> [V; 5] {
        let [source, k_ab, k_c, k_de] = [0.01, K_AB, K_C, K_DE].map(V::of);
        let from_a = source * a * a * e;
        let from_b = source * b * b * d;
        let inverse = V::of(1.0) / c;
        [
            from_a * inverse - k_ab * a,
            from_b * inverse - k_ab * b,
            from_a + from_b - k_c * c,
            k_de * (a - d),
            k_de * (b - e),
        ]
    }
}

/// Wavelength × √rate (`facts.md` C: 81√(Dₐ/s)).
pub const WAVELENGTH: f64 = 81.0;

/// The ground between stripes: the mirror image, a for b and d for e, of the state that `facts.md` G holds a net's cells
/// at.
pub const OBSTACLE: [f32; 5] = [0.05, 1.95, 0.33, 0.69, 1.31];
