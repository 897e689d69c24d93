//! What is swept: systems, ranges, and why. Lengths are cells of the simulation grid.

use dapple::learn::Parameters;
use dapple::rd::System;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The sweep of one system.
pub struct Set {
    /// The system.
    pub system: System,
    /// How many simulations.
    pub runs: u64,
    /// Area of a spot, or width of a stripe, that parameters are drawn for: from the coarsest grid that resolves
    /// it to where its size in cells no longer matters.
    size: [f64; 2],
    /// R = D_b/Dₐ.
    ratio: [f64; 2],
    /// Level read at the lowest ratio: below it spots of that ratio would touch.
    dense_level: f64,
    /// The level that is read otherwise.
    level: f64,
    /// Minor ÷ major axis of the tensor.
    stretch: [f64; 2],
}

/// All sets.
pub fn sets() -> [Set; 3] {
    [
        Set {
            system: System::TuringSpots,
            runs: 700,
            size: [18.0, 150.0],
            ratio: [3.8, 3.8],
            dense_level: 0.35,
            level: 0.35,
            stretch: [0.26, 1.0],
        },
        Set {
            system: System::MeinhardtSpots,
            runs: 1_000,
            size: [18.0, 150.0],
            // Below 12 spots become unround; 60 packs 0.024 of the plane.
            ratio: [12.0, 60.0],
            // Reads 0.23 of the plane, what Turing's spots cover.
            dense_level: 0.27,
            level: 0.5,
            stretch: [0.26, 1.0],
        },
        Set {
            system: System::MeinhardtStripes,
            runs: 300,
            size: [3.0, 17.0],
            ratio: [1.0, 1.0],
            dense_level: 0.5,
            level: 0.5,
            // Anisotropy 4 of the activators is the least that makes stripes follow (`facts.md` E).
            stretch: [0.5, 0.5],
        },
    ]
}

impl Set {
    /// The seed of run `index`: of where its spots begin, and of its own draw.
    pub fn seed(&self, index: u64) -> u64 {
        1_000_000 * (self.system as u64 + 1) + index
    }

    /// The parameters of run `index`, the same whatever other runs there are.
    pub fn draw(&self, index: u64) -> Parameters {
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed(index));
        let mut uniform = |[low, high]: [f64; 2]| low + (high - low) * rng.random::<f64>();
        let size = libm::exp(uniform(self.size.map(libm::log)));
        // Three tenths of the runs go into the dense end, where the level and not the ratio varies.
        let dense = self.dense_level < self.level && uniform([0.0, 1.0]) < 0.3;
        let (ratio, level) = if dense {
            (self.ratio[0], uniform([self.dense_level, self.level]))
        } else {
            (libm::exp(uniform(self.ratio.map(libm::log))), self.level)
        };
        let stretch = uniform(self.stretch);
        let direction = uniform([0.0, 180.0]);
        match self.system {
            System::MeinhardtStripes => {
                // facts C: width 40.5/√rate.
                let rate = 40.5 * 40.5 / (size * size);
                Parameters { rate, ratio: None, stretch, direction, level: None }
            }
            system => {
                // Scale laws (facts A, B), good to some ten per cent: where to draw, not what is learnt.
                let law = match system {
                    System::TuringSpots => 5.2,
                    _ => 163.0 * (12.0 / ratio) * libm::exp(2.85 * (0.5 - level)),
                };
                Parameters { rate: law / size, ratio: Some(ratio), stretch, direction, level: Some(level) }
            }
        }
    }
}
