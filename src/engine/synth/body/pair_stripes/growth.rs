//! The growth of stripes with tips on a surface: a round of the reaction, and another one where the period must be corrected.

use crate::document::Document;
use crate::measure::surface_stripes;
use crate::rd::pairs::{Blurs, PairField, PairKind};
use crate::rd::{SurfacePair, SurfacePairField};
use crate::synth::body::pair_form::{PairForm, period};
use crate::synth::body::pair_stripes::cut::cut_by_duty;
use crate::synth::body::pair_stripes::start::noise_around_paths;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::error::LayerError;
use crate::synth::pairs::grow::{corrected, most_corrections, times};
use crate::synth::pairs::plan::stripes::{elongation, model};
use crate::synth::pattern::EDGE;

const KIND: PairKind = PairKind::Stripes;

/// Stripes with tips that grow on a surface.
pub struct PairStripesGrowth {
    plan: BodyPlan,
    form: PairForm,
    /// The reaction that each round begins from.
    begun: Vec<f32>,
    pair: SurfacePair,
    /// The factor of the period after the corrections so far.
    factor: f64,
    /// Corrections so far, and the most that there may be.
    corrections: [usize; 2],
    /// The step at which this round ends, and the steps of the rounds before.
    steps: [u64; 2],
    pattern: Option<Vec<f32>>,
}

/// Stripes with tips that have grown on a surface.
pub struct GrownPairStripes {
    /// What they grew from.
    pub plan: BodyPlan,
    /// How much of a stripe each vertex shows: 0 on the ground, ½ at an edge.
    pub marks: Vec<f32>,
    /// Steps taken.
    pub steps: u64,
}

impl PairStripesGrowth {
    /// Begins to grow the stripes of a plan. `corrects`: whether their period is corrected.
    ///
    /// # Errors
    /// Nothing finds room.
    pub fn begin(
        document: &Document,
        placed: &Placed,
        plan: BodyPlan,
        form: PairForm,
        corrects: bool,
    ) -> Result<Self, LayerError> {
        let begun = noise_around_paths(document, placed, &plan);
        let pair = pair(&plan, &form, 1.0, &begun).ok_or(LayerError::NoRoom)?;
        let steps = [pair.steps_in(times(KIND)[0]), 0];
        let corrections = [0, if corrects { most_corrections(KIND) } else { 0 }];
        Ok(Self { plan, form, begun, pair, factor: 1.0, corrections, steps, pattern: None })
    }

    /// Takes steps of about `budget` vertex updates. Returns whether the stripes have grown.
    ///
    /// # Errors
    /// The concentrations are not finite, or no stripe is left.
    pub fn advance(&mut self, budget: u64) -> Result<bool, LayerError> {
        if self.pattern.is_some() {
            return Ok(true);
        }
        let left = self.steps[0].saturating_sub(self.pair.steps());
        if left > 0 {
            let vertices = self.plan.wanted.len().max(1) as u64;
            self.pair.advance((budget / vertices).clamp(1, left));
            return Ok(false);
        }
        self.end_round()
    }

    /// Measures what has grown, and begins another round where the period is clearly off.
    fn end_round(&mut self) -> Result<bool, LayerError> {
        let difference = self.pair.difference();
        if difference.iter().any(|value| !value.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        let pattern = cut_by_duty(&self.plan, &difference);
        let error = period_error(&self.plan, &pattern)
            .ok_or(LayerError::Blank { what: "no stripes", advice: LayerError::MARKS })?;
        let [before, most] = self.corrections;
        let mut factors = [self.factor];
        if before >= most || !corrected(KIND, &[Some(error)], &mut factors, before) {
            self.pattern = Some(pattern);
            return Ok(true);
        }
        let taken = self.pair.steps();
        [self.factor] = factors;
        self.corrections[0] += 1;
        self.pair = pair(&self.plan, &self.form, self.factor, &self.begun).ok_or(LayerError::NoRoom)?;
        self.steps = [self.pair.steps_in(times(KIND)[1]), self.steps[1] + taken];
        Ok(false)
    }

    /// The share of the work that is done, 0..1.
    #[must_use]
    pub fn share(&self) -> f64 {
        let [before, most] = self.corrections;
        let own = self.pair.steps() as f64 / self.steps[0].max(1) as f64;
        ((before as f64 + own) / (1 + most) as f64).min(1.0)
    }

    /// What has grown; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownPairStripes> {
        let steps = self.steps[1] + self.pair.steps();
        Some(GrownPairStripes { marks: self.pattern?, plan: self.plan, steps })
    }
}

/// The pair of the stripes with `factor` times the wanted periods, which begins from the `begun` reaction.
fn pair(plan: &BodyPlan, form: &PairForm, factor: f64, begun: &[f32]) -> Option<SurfacePair> {
    let surface = plan.surface();
    let pair = PairField {
        direction: plan.wanted.iter().map(|wanted| wanted.angle() as f32).collect(),
        size: plan.wanted.iter().map(|wanted| (form.size(wanted, factor) / surface.unit()) as f32).collect(),
        blurs: Blurs::Along(elongation()),
    };
    let least = pair.size.iter().copied().fold(f32::INFINITY, f32::min);
    let maps = SurfacePairField { surface, pair: &pair, obstacles: &plan.maps.obstacles };
    SurfacePair::new(&maps, &model(least), begun)
}

/// got ÷ wanted − 1 of the period of a pattern, outside obstacles; `None` without a contour.
fn period_error(plan: &BodyPlan, pattern: &[f32]) -> Option<f64> {
    let surface = plan.surface();
    let group = |vertex: usize| if plan.maps.is_obstacle(vertex) { usize::MAX } else { 0 };
    let found = surface_stripes(surface, pattern, EDGE, 1, &group)[0];
    let free = (0..pattern.len()).filter(|vertex| !plan.maps.is_obstacle(*vertex));
    let [area, lines] = free.fold([0.0; 2], |[area, lines], vertex| {
        let own = surface.cell_area(vertex);
        [area + own, lines + own / period(&plan.wanted[vertex])]
    });
    Some(found.wavelength()? * lines / area - 1.0)
}
