//! What a system must say of itself so that the solvers can step it.

use super::vector::Number;

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
    fn react<V: Number>(u: [V; N]) -> [V; N];

    /// The concentrations that a step may leave, given what it computed.
    #[must_use]
    #[inline(always)]
    fn bounded<V: Number>(u: [V; N]) -> [V; N] {
        u
    }
}

/// One explicit step at one cell: u + D·Lu + s·F(u), with the time step inside `mobility` and `rate`.
#[inline(always)]
pub fn euler<const N: usize, K: Kinetics<N>, V: Number>(
    u: [V; N],
    spread: [V; N],
    mobility: [V; 2],
    rate: V,
) -> [V; N] {
    let f = K::react(u);
    let mut next = u;
    for i in 0..N {
        let moved = match K::SPREAD[i] {
            Spread::Tensor(m) | Spread::Isotropic(m) => u[i] + mobility[m] * spread[i],
            Spread::Still => u[i],
        };
        next[i] = moved + rate * f[i];
    }
    K::bounded(next)
}
