//! Systems of pairs of morphogens: weaves, mazes, cells, pair stripes and stucco.
//!
//! ∂C₊/∂t = ∇·(A₊∇C₊) − b C₊ + R        A₊ = [θ, e·s, s]
//! ∂C₋/∂t = ∇·(A₋∇C₋) − b C₋ + R        A₋ = [θ, e·s, d·s]
//!
//! [θ, p, q] is the tensor with the rate p² along the direction θ and q² across it. The pair i has a direction θᵢ and a size
//! sᵢ at each cell; all pairs share one R. Dᵢ = C₊ − C₋ of pair i is a difference of two blurs of R: it is positive in a band of R
//! along θᵢ, and negative beside it. R is a soft step of one number X, made of all Dᵢ ([`Combination`]).
//!
//! A. Witkin & M. Kass, "Reaction-diffusion textures", SIGGRAPH 1991, equations 3 to 8, with `facts.md` H and T. Here b = 1: time is
//! counted in 1/b. The gain k scales C alone. K₀ = (d − 1)/(d + 1) is the largest gain from R to D at k = 1; thresholds and
//! softness are given in K₀ · k.

mod growth;
mod kind;
mod kinetics;
mod maze;
mod own_grids;
mod pair_stripes;
pub mod polygons;
mod shared_description;
mod shared_grid;
mod start;
mod stucco;
mod thread_law;
mod weave;
pub mod work;

#[cfg(test)]
mod tests;

pub use growth::PairGrowth;
pub use kind::PairKind;
pub(in crate::rd) use kinetics::{held_pair_by_rows, reacting_pair_by_rows};
pub(in crate::rd) use shared_grid::{STEP_LIMIT, SUPER_STEP_LIMIT};
pub use start::{HELD, PairStart};
pub use stucco::Stucco;
pub use thread_law::Threads;

use crate::grid::Grid;

/// The way in which the differences Dᵢ of all pairs, each times its [weight](PairModel::weights), are combined to the number X
/// whose soft step is the reaction R.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// X = max Dᵢ: lines of all directions cross (called "maximum of differences" in the paper). One pair gives stripes, or cells.
    Maximum,
    /// X = |max Dᵢ| − |min Dᵢ|: lines of different directions exclude each other (called "difference of absolute values" in the
    /// paper).
    DifferenceOfAbsolutes,
}

/// A number that changes with time, counted in 1/b from the beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// A constant value.
    Constant(f32),
    /// Zero until `first`, then ¼, ½ and ¾ of the last value for `each` of time, then the last value.
    Ramp {
        /// The last value.
        to: f32,
        /// Duration of the value 0.
        first: f32,
        /// Duration of each of the values ¼, ½ and ¾ of the last one.
        each: f32,
    },
    /// `from` · e^(−rate · t) until the time `until`, then constant.
    Decay {
        /// The first value.
        from: f32,
        /// Rate of the decrease; negative for an increase.
        rate: f32,
        /// Time at which the change ends.
        until: f32,
    },
}

impl Course {
    /// The value at a time.
    #[must_use]
    pub fn at(self, time: f64) -> f32 {
        match self {
            Self::Constant(value) => value,
            Self::Ramp { to, first, each } => {
                let [first, each] = [first, each].map(f64::from);
                let quarters = if time < first { 0.0 } else { 1.0 + ((time - first) / each).floor() };
                to * quarters.min(4.0) as f32 / 4.0
            }
            Self::Decay { from, rate, until } => {
                from * libm::exp(-f64::from(rate) * time.min(f64::from(until))) as f32
            }
        }
    }
}

/// The reaction and the shape of the kernels, the same at every cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairModel {
    /// The combination of the differences to the reaction.
    pub combination: Combination,
    /// d: ratio of the widths of the blurs of C₋ and C₊ across the direction, above 1. 1.5 gives clean stripes.
    pub ratio: f32,
    /// θ/K₀k: the difference at which the reaction is one half. It determines the share of the canvas that is covered: 0 gives
    /// half.
    pub threshold: Course,
    /// w/K₀k: half the width of the soft step.
    pub softness: f32,
    /// Factor of the difference of each pair. The threshold ÷ this factor is the threshold for the pair's own difference.
    pub weights: [f32; MOST_PAIRS],
    /// k: the largest reaction.
    pub gain: Course,
}

impl PairModel {
    /// K₀ = (d − 1)/(d + 1): the largest gain from R to a difference, at k = 1.
    #[must_use]
    pub fn peak_gain(&self) -> f32 {
        (self.ratio - 1.0) / (self.ratio + 1.0)
    }

    /// Λ/s = 2π√d: the wavelength with that gain, for pairs of size 1.
    #[must_use]
    pub fn wavelength(&self) -> f64 {
        std::f64::consts::TAU * f64::from(self.ratio).sqrt()
    }

    /// The softness w/K₀ for pairs whose smallest size is `s` cells, and the threshold θ/K₀. 1/(3s) makes the edge of the reaction
    /// one cell wide, since harder edges do not move over the grid. But if the softness exceeds the threshold, lines appear on the
    /// ground.
    #[must_use]
    pub fn softness_for(s: f32, threshold: f32) -> f32 {
        (1.0 / (3.0 * s)).min(STABLE_GROUND * threshold)
    }
}

/// w ÷ θ at which the ground stays empty (`facts.md` T).
const STABLE_GROUND: f32 = 0.7;

/// The form of the two blurs of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blurs {
    /// A₊ = [θ, e·s, s], A₋ = [θ, e·s, d·s]: lines along θ. e, 1..8, is the length of the blurs ÷ their width. With several pairs,
    /// blurs that are too short let thin lines begin only along the edges of wide lines that they cross.
    Along(f32),
    /// A₊ = s, A₋ = d·s in all directions: cells and blotches.
    Round,
}

impl Blurs {
    /// Lengths ÷ s of the blur of C₊ and of C₋, each along and across the direction, of a pair with the ratio `d`.
    #[must_use]
    pub fn lengths(self, d: f64) -> [[f64; 2]; 2] {
        match self {
            Self::Along(e) => [[f64::from(e), 1.0], [f64::from(e), d]],
            Self::Round => [[1.0; 2], [d; 2]],
        }
    }
}

/// Direction and size of one pair, and the form of its blurs.
#[derive(Clone, Debug)]
pub struct PairField {
    /// θ: direction of its lines, degrees from +x towards +y, by cell.
    pub direction: Vec<f32>,
    /// s: size, cells (√(x · y) of cells that are not square), by cell. 1.5 and more keep edges free of the grid.
    pub size: Vec<f32>,
    /// The form of its blurs.
    pub blurs: Blurs,
}

impl PairField {
    /// One direction and size at each of `cells` cells.
    #[must_use]
    pub fn uniform(cells: usize, direction: f32, size: f32, blurs: Blurs) -> Self {
        Self { direction: vec![direction; cells], size: vec![size; cells], blurs }
    }
}

/// One to five pairs on a grid.
#[derive(Clone, Debug)]
pub struct PairParameterField {
    /// The cells.
    pub grid: Grid,
    /// The pairs, at least one.
    pub pairs: Vec<PairField>,
    /// Cells covered by the marks of other layers, by number; empty = none. These cells do not change.
    pub obstacles: Vec<bool>,
    /// The increase of the threshold θ at each cell, in K₀; empty = 0 everywhere. Where it is high nothing grows, and lines beside
    /// such cells stay where they are.
    pub raised: Vec<f32>,
}

impl PairParameterField {
    /// The smallest size s of all pairs, cells.
    #[must_use]
    pub fn least_size(&self) -> f32 {
        self.pairs.iter().flat_map(|pair| &pair.size).copied().fold(f32::INFINITY, f32::min)
    }
}

/// Most pairs of a system: five directions 36° apart make coral and twisty mazes.
pub const MOST_PAIRS: usize = 5;
