//! What a system must say of itself so that the solvers can step it.

/// How a chemical spreads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// By the tensor of each cell, times mobility number `.0`.
    Tensor(usize),
    /// Alike in all directions, times mobility number `.0`.
    Isotropic(usize),
    /// Not at all.
    Still,
}

/// The reaction of a system of `N` chemicals.
pub trait Kinetics<const N: usize>: Send + Sync {
    /// How each chemical spreads.
    const SPREAD: [Spread; N];

    /// What the chemicals `u` do to each other at one point, per unit of time at unit rate.
    fn react(u: [f32; N]) -> [f32; N];

    /// The concentrations that a step may leave, given what it computed.
    #[must_use]
    fn bounded(u: [f32; N]) -> [f32; N] {
        u
    }
}

/// One explicit step at one cell: u + D·Lu + s·F(u), with the time step inside `mobility` and `rate`.
#[inline(always)]
pub fn euler<const N: usize, K: Kinetics<N>>(
    u: [f32; N],
    spread: [f32; N],
    mobility: [f32; 2],
    rate: f32,
) -> [f32; N] {
    let f = K::react(u);
    let mut next = u;
    for i in 0..N {
        let d = match K::SPREAD[i] {
            Spread::Tensor(m) | Spread::Isotropic(m) => mobility[m] * spread[i],
            Spread::Still => 0.0,
        };
        next[i] = u[i] + d + rate * f[i];
    }
    K::bounded(next)
}
