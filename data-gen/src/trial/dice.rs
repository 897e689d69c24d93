//! Random numbers for sketches.

use dapple::document::Edges;
use dapple_engine::attributes::regions::RegionGrid;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A generator of random numbers.
pub struct Dice(Pcg64Mcg);

impl Dice {
    /// Starts the sequence of `seed`.
    pub fn from_seed(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
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

    /// A whole number, both ends included.
    pub fn whole(&mut self, [low, high]: [usize; 2]) -> usize {
        self.0.random_range(low..=high)
    }

    /// Whether something happens that happens with a probability of `share`.
    pub fn chance(&mut self, share: f64) -> bool {
        self.0.random::<f64>() < share
    }

    /// One number for each region; those of neighbours differ by at most `most`. They are independent of each other or, half
    /// of the time and not on a seamless tile, rise steadily across the canvas.
    pub fn by_region(&mut self, layout: &RegionGrid, most: f64) -> Vec<f64> {
        let steady = layout.edges == Edges::Closed && self.chance(0.5);
        let slope = [0, 1].map(|_| if steady { self.off(0.75 * most) } else { 0.0 });
        let loose = if steady { 0.1 * most } else { 0.5 * most };
        let middle = layout.grid.map(|n| 0.5 * (n as f64 - 1.0));
        let at = |index: usize| {
            let place = layout.place(index);
            (0..2).map(|axis| slope[axis] * (place[axis] as f64 - middle[axis])).sum::<f64>()
                + self.off(loose)
        };
        (0..layout.len()).map(at).collect()
    }
}
