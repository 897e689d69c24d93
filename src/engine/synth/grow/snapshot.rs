//! A growth at one moment.

use crate::grid::Field;
use crate::rd::pairs::PairGrowth;
use crate::synth::grow::areas::AreaPattern;
use crate::synth::grow::engine::Engine;
use crate::synth::grow::layer::GrownLayer;
use crate::synth::grow::layer_pattern::LayerPattern;
use crate::synth::grow::pairs::PairPattern;
use crate::synth::grow::pattern::Pattern;
use crate::synth::grow::tone::{Levels, TonePattern, relief};
use crate::synth::grow::tone_growth::ToneGrowth;
use crate::synth::plan::Plan;
use crate::synth::plan::areas::AreaPlan;
use crate::synth::plan::pairs::PairPlan;
use crate::synth::plan::point_fields::FieldPlan;
use crate::synth::plan::point_lines::LinePlan;
use crate::synth::plan::tone::TonePlan;

/// The height at which a relief is cut while it grows.
const MIDDLE: f32 = 0.5;

/// Moments of a film in which the points of a layer appear: more than half of the frames of a usual film show one each.
pub(super) const FILM_STAGES: usize = 48;

/// A document at one moment of its growth.
pub struct Snapshot<'a> {
    /// The layers that have grown.
    pub beneath: &'a [GrownLayer],
    /// The layer that grows on top of them.
    pub growing: Growing<'a>,
    /// Steps that it has taken. Fewer than before: it has begun again.
    pub steps: u64,
}

/// A layer that grows, with its plan.
#[derive(Clone, Copy)]
pub enum Growing<'a> {
    /// Spots or stripes.
    Marks(&'a Plan, &'a Engine),
    /// A system of pairs.
    Pairs(&'a PairPlan, &'a PairGrowth),
    /// Patches, which are there at once, or cells: their pattern.
    Areas(&'a AreaPlan, &'a Field),
    /// Streaks or cracks: their pattern as it was corrected so far.
    Lines(&'a LinePlan, &'a Field),
    /// A field of points: those that have appeared.
    Points(&'a FieldPlan, &'a Field),
    /// What a picture drives, whose levels are found at the end.
    Tone(&'a TonePlan, &'a ToneGrowth),
}

impl<'a> Snapshot<'a> {
    /// Spots or stripes that grow.
    #[must_use]
    pub fn of_marks(beneath: &'a [GrownLayer], plan: &'a Plan, engine: &'a Engine) -> Self {
        Self { beneath, growing: Growing::Marks(plan, engine), steps: engine.steps() }
    }
}

impl<'a> Growing<'a> {
    /// Cells along x and y of the current grid.
    #[must_use]
    pub fn grid(self) -> [usize; 2] {
        match self {
            Self::Marks(_, engine) => engine.grid(),
            Self::Pairs(plan, _) => plan.grid.size,
            Self::Areas(plan, _) => plan.grid.size,
            Self::Lines(plan, _) => plan.grid.size,
            Self::Points(plan, _) => plan.grid.size,
            Self::Tone(_, growth) => growth.grid(),
        }
    }

    /// Width and height of the canvas, px.
    #[must_use]
    pub fn canvas(self) -> [f64; 2] {
        let grid = match self {
            Self::Marks(plan, _) => &plan.lookup.grid,
            Self::Pairs(plan, _) => &plan.grid,
            Self::Areas(plan, _) => &plan.grid,
            Self::Lines(plan, _) => &plan.grid,
            Self::Points(plan, _) => &plan.grid,
            Self::Tone(plan, _) => &plan.grid,
        };
        grid.bounds_px().size
    }

    /// The pattern of the layer as it is now.
    #[must_use]
    pub fn pattern(self) -> LayerPattern<'a> {
        match self {
            Self::Marks(plan, engine) => {
                LayerPattern::Marks(Pattern::new(&plan.lookup, &plan.levelled(engine.marks())))
            }
            Self::Pairs(plan, growth) => {
                LayerPattern::Pairs(PairPattern::new(&plan.shown(growth.differences()), &plan.levels()))
            }
            Self::Areas(_, field) | Self::Lines(_, field) | Self::Points(_, field) => {
                LayerPattern::Areas(AreaPattern::new(field))
            }
            Self::Tone(plan, growth) => {
                let relief = relief(&growth.marks(), plan.system, plan.wavelength);
                LayerPattern::Tone(TonePattern::new(&relief, Levels::Even(MIDDLE)))
            }
        }
    }
}
