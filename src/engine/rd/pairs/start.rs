//! Initial concentrations of a system of pairs.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Time in which the concentrations reach their equilibrium with a constant reaction within 1 %, in 1/b.
pub const HELD: f64 = 5.0;

/// The initial state of the concentrations.
#[derive(Clone, Debug)]
pub enum PairStart {
    /// White noise between −1 and 1, from this seed.
    Noise(u64),
    /// The equilibrium with a given reaction: R at each cell, 0..1.
    Drawn(Vec<f32>),
    /// An earlier result: the concentrations of each morphogen, C₊ and C₋ of the first pair, then of the second, and so on.
    Grown(Vec<Vec<f32>>),
}

/// White noise between −1 and 1 on this number of cells, of the morphogen number `index`.
pub(super) fn noise(cells: usize, index: usize, seed: u64) -> Vec<f32> {
    let mut random = Pcg64Mcg::seed_from_u64(seed.wrapping_add(index as u64));
    (0..cells).map(|_| 2.0 * random.random::<f32>() - 1.0).collect()
}
