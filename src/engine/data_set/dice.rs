//! The random numbers of an item.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A generator of random numbers.
pub struct Dice(Pcg64Mcg);

impl Dice {
    /// The sequence of item `index` of a data set with this seed, at this attempt.
    pub fn of_item(seed: u64, index: u64, attempt: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(mixed(mixed(mixed(seed) ^ index) ^ attempt)))
    }

    /// Uniform between these two.
    pub fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }

    /// Uniform in the logarithm.
    pub fn log_between(&mut self, range: [f64; 2]) -> f64 {
        libm::exp(self.between(range.map(libm::log)))
    }

    /// Uniform between −`most` and `most`.
    pub fn off(&mut self, most: f64) -> f64 {
        self.between([-most, most])
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.0.random_range(0..count.max(1))
    }

    /// A seed of 32 bits, which any reader of JSON keeps.
    pub fn seed(&mut self) -> u64 {
        u64::from(self.0.random::<u32>())
    }
}

/// The output function of SplitMix64: neighbouring numbers get unlike ones.
fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
