//! The growth of what a picture drives: of a system with its grids, or of a pair of morphogens.

use crate::grid::Field;
use crate::rd::pairs::{PairGrowth, PairStart};
use crate::synth::grow::engine::Engine;
use crate::synth::grow::settle::UPDATES;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::pairs::FROM_NOISE;
use crate::synth::plan::tone::{ToneMaps, TonePlan, pair_model};
use crate::synth::watch::{Cancelled, Stage, Watch};

/// Time between two calls of the watch, of pairs, in 1/b.
const BETWEEN: f64 = 0.2;

/// A growth that a picture drives.
pub enum ToneGrowth {
    /// Of a system.
    Of(Box<Engine>),
    /// Of a pair.
    Pairs(Box<PairGrowth>),
}

impl ToneGrowth {
    /// Lays it out as planned.
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

    /// Advances a part. Returns whether it is still growing.
    fn advance(&mut self, every: Option<f64>) -> bool {
        match self {
            Self::Of(engine) => engine.advance(every.map_or(UPDATES, |time| engine.updates_in(time))),
            Self::Pairs(growth) => {
                let last = growth.steps_in(FROM_NOISE);
                let left = last.saturating_sub(growth.steps());
                let part = growth.steps_in(every.unwrap_or(BETWEEN)).min(left);
                during(Phase::Steps, || growth.advance(part));
                part < left
            }
        }
    }

    /// The share that is done, 0..1.
    fn progress(&self) -> f64 {
        match self {
            Self::Of(engine) => engine.progress(),
            Self::Pairs(growth) => growth.time() / FROM_NOISE,
        }
    }

    /// Grows until it has settled, or for its time; calls `seen` each `every` of it, or every few milliseconds. Returns whether it has
    /// settled.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn settle(
        &mut self,
        every: Option<f64>,
        watch: &Watch,
        seen: &mut dyn FnMut(&Self),
    ) -> Result<bool, Cancelled> {
        while self.advance(every) {
            watch.step(Stage::Grow, self.progress())?;
            seen(self);
        }
        Ok(match self {
            Self::Of(engine) => engine.settled(),
            Self::Pairs(_) => true,
        })
    }

    /// Cells along x and y of its grid.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        match self {
            Self::Of(engine) => engine.grid(),
            Self::Pairs(growth) => growth.grid(),
        }
    }

    /// What shows the marks: a concentration, or the difference of two.
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
