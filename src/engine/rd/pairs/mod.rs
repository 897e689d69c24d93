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
pub use start::{HELD, PairStart};
pub use stucco::Stucco;
pub use thread_law::Threads;

use crate::grid::Grid;

/// How the differences Dᵢ of all pairs, each times its [weight](PairModel::weights), make up the number X whose soft step is the reaction R.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// X = max Dᵢ: lines of all directions cross (their "maximum of differences"); of one pair stripes, or cells.
    Maximum,
    /// X = |max Dᵢ| − |min Dᵢ|: lines of different directions exclude each other (their "difference of absolute values").
    DifferenceOfAbsolutes,
}

/// A number that changes with time, counted in 1/b from the beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Always this.
    Constant(f32),
    /// Zero until `first`, then ¼, ½ and ¾ of the last value for `each` of time, then the last value.
    Ramp {
        /// The last value.
        to: f32,
        /// How long it is zero.
        first: f32,
        /// How long it is ¼, ½ and ¾ of the last.
        each: f32,
    },
    /// `from` · e^(−rate · t) until the time `until`, then constant.
    Decay {
        /// The first value.
        from: f32,
        /// How fast it falls; where it rises, below 0.
        rate: f32,
        /// How long it falls.
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
    /// How the differences make up the reaction.
    pub combination: Combination,
    /// d: how much wider the blur of C₋ is than that of C₊ across the direction, above 1. 1.5 gives clean stripes.
    pub ratio: f32,
    /// θ/K₀k: the difference at which the reaction is half. It sets the share that is covered: 0 = half.
    pub threshold: Course,
    /// w/K₀k: half the width of the soft step.
    pub softness: f32,
    /// What the difference of each pair counts. Divided by it, the threshold is that of the pair's own difference.
    pub weights: [f32; MOST_PAIRS],
    /// k: the reaction at most.
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

    /// The softness w/K₀ for pairs whose smallest size is `s` cells, and the threshold θ/K₀: 1/(3s) makes the edge of the
    /// reaction one cell wide, since edges do not move over the grid where it is harder; but where it is softer than the
    /// threshold is high, the ground grows lines of its own.
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
    /// A₊ = [θ, e·s, s], A₋ = [θ, e·s, d·s]: lines along θ. e, 1..8, is how much longer than wide the blurs are. Where several pairs are
    /// together, thin lines that are seen by a short blur only begin to grow along the edges of wide ones that they cross.
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
    /// Cells covered by the marks of other layers, by number; empty = none. Nothing grows there.
    pub obstacles: Vec<bool>,
    /// By how much the threshold θ is raised at each cell, in K₀; empty = nowhere. Where it is high nothing grows, and lines that
    /// grow beside it stay where they are.
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
