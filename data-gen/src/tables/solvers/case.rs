//! The patterns that are solved.

use dapple_engine::grid::{Edges, Grid};
use dapple_engine::rd::pairs::{
    Blurs, Combination, Course, MOST_PAIRS, PairField, PairGrowth, PairModel, PairParameterField, PairStart,
};

use super::SIDE;

/// d.
const RATIO: f32 = 1.5;

/// A pattern of Witkin and Kass with uniform tensors.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// The direction of each pair, degrees.
    pub angles: &'static [f64],
    /// e.
    pub elongation: f64,
    /// θ/K₀, reached after T = 10.
    pub threshold: f32,
    /// s, cells.
    pub size: f64,
    /// Time to grow, in 1/b.
    pub time: f64,
}

const ZEBRA: Case =
    Case { name: "zebra", angles: &[75.0], elongation: 2.0, threshold: 0.0, size: 2.0, time: 40.0 };
const WEAVE: Case =
    Case { name: "weave", angles: &[0.0, 90.0], elongation: 3.0, threshold: 0.15, size: 2.0, time: 40.0 };

/// Their zebra and weave, each on a grid as fine as it must be, and on one twice as fine.
pub const ALL: [Case; 4] = [ZEBRA, Case { size: 4.0, ..ZEBRA }, WEAVE, Case { size: 4.0, ..WEAVE }];

impl Case {
    /// The reaction, on a grid with `factor` times fewer cells each way.
    pub fn model(&self, factor: usize) -> PairModel {
        let size = (self.size / factor as f64) as f32;
        let softness = if self.threshold > 0.0 {
            PairModel::softness_for(size, self.threshold)
        } else {
            1.0 / (3.0 * size)
        };
        let threshold = Course::Ramp { to: self.threshold, first: 4.0, each: 2.0 };
        PairModel {
            combination: Combination::Maximum,
            ratio: RATIO,
            threshold,
            softness,
            weights: [1.0; MOST_PAIRS],
            gain: Course::Constant(1.0),
        }
    }

    /// The pairs, on such a grid.
    pub fn maps(&self, factor: usize) -> PairParameterField {
        let side = SIDE / factor;
        let pair = |angle: &f64| {
            let blurs = Blurs::Along(self.elongation as f32);
            PairField::uniform(side * side, *angle as f32, (self.size / factor as f64) as f32, blurs)
        };
        PairParameterField {
            grid: Grid::unit([side; 2], Edges::Wrap),
            pairs: self.angles.iter().map(pair).collect(),
            obstacles: Vec::new(),
            raised: Vec::new(),
        }
    }

    /// Noise between −1 and 1 of each morphogen: what all methods on the whole grid begin from.
    pub fn noise(&self, seed: u64) -> Result<Vec<Vec<f32>>, String> {
        Ok(growth(&self.maps(1), &self.model(1), &PairStart::Noise(seed))?.concentrations())
    }

    /// The level of the edges of D at the end.
    pub fn level(&self) -> f32 {
        self.threshold * self.model(1).peak_gain()
    }

    /// e·s along and s or d·s across the direction, of C₊ and of C₋.
    pub fn lengths(&self) -> [[f64; 2]; 2] {
        [1.0, f64::from(RATIO)].map(|across| [self.elongation * self.size, across * self.size])
    }
}

/// A growth.
pub fn growth(maps: &PairParameterField, model: &PairModel, start: &PairStart) -> Result<PairGrowth, String> {
    PairGrowth::new(maps, model, start).ok_or_else(|| "maps of one grid are expected".to_owned())
}
