//! The growth driven by a picture: of a system with its grids, or of a pair of morphogens.

use crate::grid::Field;
use crate::rd::pairs::{PairGrowth, PairStart};
use crate::synth::marks::grow::engine::Engine;
use crate::synth::pairs::plan::FROM_NOISE;
use crate::synth::profile::{Section, during};
use crate::synth::tone::plan::{ToneMaps, TonePlan, pair_model};

/// A growth driven by a picture.
pub enum ToneGrowth {
    /// The growth of a system.
    Of(Box<Engine>),
    /// The growth of a pair.
    Pairs(Box<PairGrowth>),
}

impl ToneGrowth {
    /// The growth of a plan, before its first step.
    #[must_use]
    pub fn new(plan: &TonePlan, seed: u64) -> Self {
        match plan.maps() {
            ToneMaps::Of(system, maps) => Self::Of(Box::new(Engine::from_maps(system, maps, seed))),
            ToneMaps::Pairs(maps) => {
                let growth = PairGrowth::new(&maps, &pair_model(&maps), &PairStart::Noise(seed));
                Self::Pairs(Box::new(growth.expect("maps of one grid")))
            }
        }
    }

    /// Whether there is room for it.
    #[must_use]
    pub fn can_start(&self) -> bool {
        match self {
            Self::Of(engine) => engine.can_start(),
            Self::Pairs(_) => true,
        }
    }

    /// Advances by about `updates` cell updates. Returns whether it is still growing.
    pub fn advance(&mut self, updates: u64) -> bool {
        match self {
            Self::Of(engine) => engine.advance(updates),
            Self::Pairs(growth) => {
                let last = growth.steps_in(FROM_NOISE);
                let left = last.saturating_sub(growth.steps());
                let part = (updates / cells(growth)).max(1).min(left);
                during(Section::Steps, || growth.advance(part));
                part < left
            }
        }
    }

    /// Cell updates of `time` on the current grid.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        match self {
            Self::Of(engine) => engine.updates_in(time),
            Self::Pairs(growth) => growth.steps_in(time) * cells(growth),
        }
    }

    /// Cell updates done.
    #[must_use]
    pub fn updates(&self) -> u64 {
        match self {
            Self::Of(engine) => engine.updates(),
            Self::Pairs(growth) => growth.steps() * cells(growth),
        }
    }

    /// The share that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match self {
            Self::Of(engine) => engine.progress(),
            Self::Pairs(growth) => growth.time() / FROM_NOISE,
        }
    }

    /// Whether it has settled; pairs have settled after a fixed time.
    #[must_use]
    pub fn settled(&self) -> bool {
        match self {
            Self::Of(engine) => engine.settled(),
            Self::Pairs(_) => true,
        }
    }

    /// Cells along x and y of its grid.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        match self {
            Self::Of(engine) => engine.grid(),
            Self::Pairs(growth) => growth.grid(),
        }
    }

    /// The field that shows the marks: a concentration, or the difference of two.
    #[must_use]
    pub fn marks(&self) -> Field {
        match self {
            Self::Of(engine) => engine.marks(),
            Self::Pairs(growth) => growth.differences().remove(0),
        }
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        match self {
            Self::Of(engine) => engine.steps(),
            Self::Pairs(growth) => growth.steps(),
        }
    }

    /// The concentrations of each chemical.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        match self {
            Self::Of(engine) => engine.concentrations(),
            Self::Pairs(growth) => growth.concentrations(),
        }
    }
}

/// Cells of the grid of a pair.
fn cells(growth: &PairGrowth) -> u64 {
    let [nx, ny] = growth.grid();
    (nx * ny) as u64
}
