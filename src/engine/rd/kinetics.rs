//! The reaction of a system, as the solvers step it.

use std::fmt::Debug;

use super::vector::Number;

/// The kind of diffusion of a chemical.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spreading {
    /// A tensor for each cell.
    Tensor {
        /// The number of the tensor.
        tensor: usize,
        /// The number of the mobility by which the tensor is multiplied.
        mobility: usize,
    },
    /// Isotropically.
    Isotropic {
        /// The number of the mobility.
        mobility: usize,
    },
    /// Not at all.
    Still,
}

/// Number of mobilities of a cell. Systems with more tensors include the other factors in the tensors, whose determinant
/// need not be 1.
pub const MOBILITIES: usize = 2;

/// The number of tensors that these chemicals use.
#[must_use]
pub const fn tensors(spread: &[Spreading]) -> usize {
    let (mut count, mut index) = (0, 0);
    while index < spread.len() {
        if let Spreading::Tensor { tensor, .. } = spread[index]
            && tensor >= count
        {
            count = tensor + 1;
        }
        index += 1;
    }
    count
}

/// The reaction of a system of `N` chemicals. The value holds the parameters that change with time.
pub trait Kinetics<const N: usize>: Copy + Debug + Send + Sync + 'static {
    /// For each chemical, the kind of its diffusion.
    const SPREAD: [Spreading; N];
    /// The number of tensors.
    const TENSORS: usize = tensors(&Self::SPREAD);

    /// The reaction at a normalised time (`facts.md` 0), counted from the start of the growth.
    #[must_use]
    fn at(&self, _time: f64) -> Self {
        *self
    }

    /// The change of the chemicals `u` at one point by reaction, per unit of time at unit rate.
    fn react<V: Number>(&self, u: [V; N]) -> [V; N];

    /// The computed concentrations, clamped to their allowed range.
    #[must_use]
    #[inline(always)]
    fn bounded<V: Number>(u: [V; N]) -> [V; N] {
        u
    }
}

/// One stage at one cell: `from` + D·Lu + s·F(u), with the time step and the stage's weight inside `mobility` and `rate`.
/// `from` is u in an Euler step.
#[inline(always)]
pub fn stepped<const N: usize, K: Kinetics<N>, V: Number>(
    kinetics: &K,
    [u, from]: [[V; N]; 2],
    spread: [V; N],
    mobility: [V; MOBILITIES],
    rate: V,
) -> [V; N] {
    let f = kinetics.react(u);
    let mut next = from;
    for i in 0..N {
        let moved = match K::SPREAD[i] {
            Spreading::Tensor { mobility: m, .. } | Spreading::Isotropic { mobility: m } => {
                from[i] + mobility[m] * spread[i]
            }
            Spreading::Still => from[i],
        };
        next[i] = moved + rate * f[i];
    }
    K::bounded(next)
}
