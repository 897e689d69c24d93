//! Chemicals that are stored side by side: two that spread by one operator are read together.

use crate::rd::kinetics::{Kinetics, Spreading};

/// The place of `N` chemicals in pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout<const N: usize> {
    /// The chemicals of each pair; the second is `N` where there is none.
    pub pairs: [[usize; 2]; N],
    /// The operator by which each pair spreads: the number of a tensor, or the number of tensors for the isotropic one.
    pub operators: [Option<usize>; N],
    /// Number of pairs.
    pub count: usize,
}

/// The operator of a chemical.
const fn operator(spreading: Spreading, tensors: usize) -> Option<usize> {
    match spreading {
        Spreading::Tensor { tensor, .. } => Some(tensor),
        Spreading::Isotropic { .. } => Some(tensors),
        Spreading::Still => None,
    }
}

const fn same(a: Option<usize>, b: Option<usize>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a == b,
        (None, None) => true,
        _ => false,
    }
}

/// The layout of the chemicals of a system.
#[must_use]
pub const fn layout<const N: usize, K: Kinetics<N>>() -> Layout<N> {
    let mut layout = Layout { pairs: [[N; 2]; N], operators: [None; N], count: 0 };
    let mut placed = [false; N];
    let mut first = 0;
    while first < N {
        if !placed[first] {
            let own = operator(K::SPREAD[first], K::TENSORS);
            let mut second = first + 1;
            while second < N && (placed[second] || !same(own, operator(K::SPREAD[second], K::TENSORS))) {
                second += 1;
            }
            if second < N {
                placed[second] = true;
            }
            layout.pairs[layout.count] = [first, second];
            layout.operators[layout.count] = own;
            layout.count += 1;
        }
        first += 1;
    }
    layout
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rd::systems::meinhardt_spots::MeinhardtSpots;
    use crate::rd::systems::meinhardt_stripes::MeinhardtStripes;

    #[test]
    fn chemicals_that_spread_alike_are_kept_side_by_side() {
        let spots = layout::<2, MeinhardtSpots>();
        assert_eq!((spots.count, spots.pairs[0], spots.operators[0]), (1, [0, 1], Some(0)));
        let stripes = layout::<5, MeinhardtStripes>();
        assert_eq!(stripes.pairs[..3], [[0, 1], [2, 5], [3, 4]]);
        assert_eq!(stripes.operators[..3], [Some(0), None, Some(<MeinhardtStripes as Kinetics<5>>::TENSORS)]);
    }
}
