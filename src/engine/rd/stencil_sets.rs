//! The sets of offsets for which the solver has special code.

use crate::rd::selling::OFFSETS;

/// The sets of [`OFFSETS`] that Selling's reduction gives: the axes (isotropic diffusion and tensors along the axes), the axes with
/// a diagonal, or with a knight's move between; then the unions that groups use where one set changes to another. Shorter sets
/// repeat their last offset.
pub const SETS: [[usize; 4]; 12] = [
    [0, 1, 1, 1],
    [0, 1, 2, 2],
    [0, 1, 3, 3],
    [0, 2, 4, 4],
    [1, 2, 5, 5],
    [0, 3, 6, 6],
    [1, 3, 7, 7],
    [0, 1, 2, 3],
    [0, 1, 2, 4],
    [0, 1, 2, 5],
    [0, 1, 3, 6],
    [0, 1, 3, 7],
];

/// Any other set: its offsets are looked up during the step.
pub const MIXED: usize = SETS.len();

/// The axes, with weights that are all 1: the multiplications are omitted, which changes no bit.
pub const UNIT: usize = MIXED + 1;

/// The sets as bits.
pub const BITS: [u32; SETS.len()] = {
    let mut bits = [0; SETS.len()];
    let mut set = 0;
    while set < SETS.len() {
        let [a, b, c, d] = SETS[set];
        bits[set] = 1 << a | 1 << b | 1 << c | 1 << d;
        set += 1;
    }
    bits
};

/// The offsets of a set, and how many.
#[must_use]
pub const fn taps(set: usize) -> ([[isize; 2]; 4], u32) {
    let [a, b, c, d] = SETS[set];
    ([OFFSETS[a], OFFSETS[b], OFFSETS[c], OFFSETS[d]], BITS[set].count_ones())
}
