//! The growth of layers that a picture or Turing's growth drives, from their plan.

use crate::grid::resample::Spline;
use crate::grid::{Domain, Field};
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Seen, Setting};
use crate::synth::pattern::EDGE;
use crate::synth::profile::{Section, during};
use crate::synth::tone::advice::advice;
use crate::synth::tone::grown::{GrownTone, Levels, TonePattern, gains, levels, measure, relief};
use crate::synth::tone::growth::ToneGrowth;
use crate::synth::tone::plan::TonePlan;
use crate::synth::watch::Stage;

/// Standard deviation, in wavelengths, of the surroundings in which the share of ink equals the tone: for stripes, and for spots,
/// whose gaps are wider.
const AROUND: [f64; 2] = [0.5, 0.6];

/// The growth of a layer that a picture or Turing's growth drives.
pub struct DrivenGrowth {
    /// Whether the concentrations of all chemicals are kept.
    concentrations: bool,
    plan: TonePlan,
    growth: ToneGrowth,
    state: State,
}

/// The state of the work.
enum State {
    /// The pattern grows.
    Grow,
    /// Its relief has been computed.
    Relief(Field),
    /// The pattern has been cut at its thresholds.
    Levelled(Field, Levelled),
    /// The layer has grown.
    Grown(Box<GrownTone>),
}

impl DrivenGrowth {
    /// Begins to grow `plan`.
    ///
    /// # Errors
    /// There is no room.
    pub fn begin(plan: TonePlan, setting: &Setting) -> Result<Self, LayerError> {
        let Setting { seed, concentrations, .. } = *setting;
        let growth = during(Section::LayOut, || ToneGrowth::new(&plan, seed));
        if !growth.can_start() {
            return Err(LayerError::NoRoom);
        }
        Ok(Self { concentrations, plan, growth, state: State::Grow })
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Nothing grew, or nothing but marks.
    pub fn advance(&mut self, budget: u64) -> Result<Advanced, LayerError> {
        let (cells, px) = (self.plan.grid.cells(), self.plan.fine[0] * self.plan.fine[1]);
        match std::mem::replace(&mut self.state, State::Grow) {
            State::Grow => {
                let before = self.growth.updates();
                let grows = self.growth.advance(budget);
                let updates = self.growth.updates() - before;
                if grows {
                    return Ok(Advanced::seen(updates));
                }
                let marks = self.growth.marks();
                if !marks.values.iter().all(|value| value.is_finite()) {
                    return Err(LayerError::NoPattern);
                }
                let Self { plan, .. } = &*self;
                let relief = during(Section::Measure, || relief(&marks, plan.system, plan.wavelength));
                self.state = State::Relief(relief);
                Ok(Advanced::by(updates as usize + cells))
            }
            State::Relief(relief) => {
                let levelled = during(Section::Measure, || levelled(&self.plan, &relief));
                let ink = &levelled.ink;
                let what = match (ink.contains(&1.0), ink.contains(&0.0)) {
                    (false, _) => Some("no marks"),
                    (_, false) => Some("marks without any ground between them"),
                    _ => None,
                };
                if let Some(what) = what {
                    return Err(LayerError::Blank { what, advice: advice(&self.plan, ink.contains(&1.0)) });
                }
                self.state = State::Levelled(relief, levelled);
                Ok(Advanced::by(px))
            }
            State::Levelled(relief, levelled) => {
                self.state = State::Grown(Box::new(self.grown(relief, levelled)));
                Ok(Advanced::done(px))
            }
            State::Grown(grown) => {
                self.state = State::Grown(grown);
                Ok(Advanced::done(0))
            }
        }
    }

    /// The grown pattern with its measurements.
    fn grown(&self, relief: Field, levelled: Levelled) -> GrownTone {
        let Levelled { levels, gains, ink } = levelled;
        let measured = during(Section::Measure, || measure(&self.plan, &ink, &relief));
        let concentrations = if self.concentrations { self.growth.concentrations() } else { Vec::new() };
        let (plan, steps, settled) = (self.plan.clone(), self.growth.steps(), self.growth.settled());
        let ink = f64::from(ink.iter().sum::<f32>()) / ink.len().max(1) as f64;
        GrownTone { plan, steps, settled, relief, levels, gains, ink, measured, concentrations }
    }

    /// The current stage, and the finished share of it.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Grow => (Stage::Grow, self.growth.progress()),
            State::Relief(_) => (Stage::Refine, 0.0),
            State::Levelled(..) => (Stage::Refine, 0.5),
            State::Grown(_) => (Stage::Refine, 1.0),
        }
    }

    /// Cell updates of `time` on the current grid.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        self.growth.updates_in(time)
    }

    /// The current state of the layer; `None` while it does not grow.
    #[must_use]
    pub fn seen(&self) -> Option<Seen<'_>> {
        let grows = matches!(self.state, State::Grow) && self.growth.steps() > 0;
        grows.then(|| seen(&self.plan, &self.growth))
    }

    /// The grown pattern; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownTone> {
        if let State::Grown(grown) = self.state { Some(*grown) } else { None }
    }
}

/// The growing pattern; its thresholds are found at the end.
pub(super) fn seen<'s>(plan: &'s TonePlan, growth: &'s ToneGrowth) -> Seen<'s> {
    let pattern = || {
        let relief = relief(&growth.marks(), plan.system, plan.wavelength);
        TonePattern::new(&relief, Levels::Even(EDGE))
    };
    Seen {
        steps: growth.steps(),
        grid: growth.grid(),
        canvas: plan.grid.bounds_px().size,
        pattern: Box::new(move || Box::new(pattern())),
    }
}

/// The thresholds and the cut of a relief, at the px of the tone.
struct Levelled {
    levels: Field,
    /// Factors by which its heights are stretched.
    gains: Field,
    /// 1 in ink, 0 elsewhere.
    ink: Vec<f32>,
}

fn levelled(plan: &TonePlan, relief: &Field) -> Levelled {
    let [width, height] = plan.fine;
    let heights = Spline::new(relief).rows(0..height, width, height);
    let values = if plan.drives.level {
        let sigma = AROUND[usize::from(!plan.system.is_striped())] * plan.px_a_wavelength();
        levels(&heights, plan.fine, &plan.tone, sigma, plan.grid.edges)
    } else if plan.growth.is_empty() {
        vec![even_level(plan, &heights); heights.len()]
    } else {
        vec![EDGE; heights.len()]
    };
    let ink =
        heights.iter().zip(&values).map(|(height, level)| f32::from(u8::from(height >= level))).collect();
    let gains = gains(&heights, &values, plan.fine, plan.px_a_wavelength(), relief.edges);
    let extent = relief.extent();
    let cell = [extent[0] / width as f64, extent[1] / height as f64];
    let field = |values| Field { width, height, cell, edges: relief.edges, values };
    Levelled { levels: field(values), gains: field(gains), ink }
}

/// The single threshold at which the whole canvas has as much ink as its tone.
fn even_level(plan: &TonePlan, heights: &[f32]) -> f32 {
    let mean = plan.tone.iter().map(|tone| f64::from(*tone)).sum::<f64>() / plan.tone.len().max(1) as f64;
    let mut sorted = heights.to_vec();
    sorted.sort_unstable_by(f32::total_cmp);
    let lower = ((1.0 - mean).clamp(0.0, 1.0) * sorted.len() as f64) as usize;
    sorted.get(lower.min(sorted.len().saturating_sub(1))).copied().unwrap_or(0.5)
}
