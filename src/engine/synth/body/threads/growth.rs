//! The growth of threads on a surface: rounds of the reaction, each with sizes that the one before has corrected.

use rayon::prelude::*;

use crate::attributes::{Attributes, Stripes};
use crate::document::Document;
use crate::rd::pairs::{PairField, PairKind};
use crate::rd::{SurfacePairField, SurfacePairs};
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::thread_form::ThreadForm;
use crate::synth::body::threads::measured::measured;
use crate::synth::body::threads::shown::shown;
use crate::synth::body::threads::start::{directions_at, start};
use crate::synth::error::LayerError;
use crate::synth::pairs::grow::{corrected, most_corrections, times};
use crate::synth::report::ThreadReport;

/// The relative error of the distance of threads of a weave below which they do not begin anew, and how often they do at most: threads near to places
/// round which directions turn are lost.
const SAME_PERIOD: f64 = 0.03;
const MOST_PERIODS: usize = 2;
/// The least and the greatest factor of the distances of the lines that they begin from.
const PERIODS: [f64; 2] = [0.6, 1.4];

/// Threads that grow on a surface.
pub struct ThreadGrowth {
    plan: BodyPlan,
    form: ThreadForm,
    /// What this round grows, and the reaction that it began from.
    pairs: SurfacePairs,
    begun: Vec<f32>,
    /// Factors of the sizes after the corrections so far, by direction.
    factors: Vec<f64>,
    /// Corrections so far, and the most that there may be.
    corrections: [usize; 2],
    /// Factors of the distances of the lines that the threads of a weave begin from, by direction, and how often these were changed.
    periods: (Vec<f64>, usize),
    /// The step at which this round ends, and the steps of the rounds before.
    steps: [u64; 2],
    grown: Option<Grown>,
}

/// Patterns that have grown.
struct Grown {
    patterns: Vec<Vec<f32>>,
    reports: Vec<ThreadReport>,
}

/// Threads that have grown on a surface.
pub struct GrownThreads {
    /// What they grew from.
    pub plan: BodyPlan,
    /// How much of a thread each vertex shows: 0 on the ground, ½ at an edge.
    pub marks: Vec<f32>,
    /// What was asked and what has grown, by direction.
    pub reports: Vec<ThreadReport>,
    /// Steps taken.
    pub steps: u64,
}

impl ThreadGrowth {
    /// Begins to grow the threads of a plan, which `corrects` their sizes or does not.
    ///
    /// # Errors
    /// Nothing finds room.
    pub fn begin(
        document: &Document,
        placed: &Placed,
        plan: BodyPlan,
        form: ThreadForm,
        corrects: bool,
    ) -> Result<Self, LayerError> {
        let factors = vec![1.0; form.lines.len()];
        let begun = start(document, placed, &plan, &form, &factors)?;
        let periods = (factors.clone(), 0);
        let pairs = grown_from(&plan, &form, &factors, &begun, None).ok_or(LayerError::NoRoom)?;
        let last = pairs.steps_in(times(form.kind())[0]);
        let most = if corrects { most_corrections(form.kind()) } else { 0 };
        let (corrections, steps) = ([0, most], [last, 0]);
        Ok(Self { plan, form, pairs, begun, factors, corrections, periods, steps, grown: None })
    }

    /// Takes steps of about `budget` vertex updates. Returns whether the threads have grown.
    ///
    /// # Errors
    /// The concentrations are not finite, or no thread is left.
    pub fn advance(&mut self, document: &Document, placed: &Placed, budget: u64) -> Result<bool, LayerError> {
        if self.grown.is_some() {
            return Ok(true);
        }
        let left = self.steps[0].saturating_sub(self.pairs.steps());
        if left > 0 {
            let cells = self.plan.maps.parameters.len().max(1) as u64;
            self.pairs.advance((budget / cells).clamp(1, left));
            return Ok(false);
        }
        self.end_round(document, placed)
    }

    /// Measures what has grown, and begins another round where that is useful.
    fn end_round(&mut self, document: &Document, placed: &Placed) -> Result<bool, LayerError> {
        let Self { plan, form, .. } = self;
        let differences = self.pairs.differences();
        if differences.iter().flatten().any(|value| !value.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        let patterns = shown(plan, form, &differences);
        let report = |(direction, own): (usize, &Vec<f32>)| measured(plan, form, direction, own);
        let reports: Vec<ThreadReport> = patterns.iter().enumerate().map(report).collect();
        if reports.iter().all(|threads| threads.got.is_none()) {
            return Err(LayerError::Blank { what: "no threads", advice: LayerError::MARKS });
        }
        let kind = form.kind();
        if self.corrections[1] > 0 && kind == PairKind::Weave && self.corrects_periods(&reports) {
            self.begun = start(document, placed, &self.plan, &self.form, &self.periods.0)?;
            return self.begin_round(None, 0);
        }
        let errors: Vec<Option<f64>> = reports
            .iter()
            .map(|threads| {
                let errors = threads.error?;
                Some(if kind == PairKind::Stripes { errors.wavelength } else { errors.width })
            })
            .collect();
        let [before, most] = self.corrections;
        if before >= most || !corrected(kind, &errors, &mut self.factors, before) {
            self.grown = Some(Grown { patterns, reports });
            return Ok(true);
        }
        // Lines from noise keep their distances: they begin anew.
        let concentrations = (kind != PairKind::Stripes).then(|| self.pairs.concentrations());
        self.corrections[0] += 1;
        self.begin_round(concentrations.as_deref(), 1)
    }

    /// Begins a round of this number (0 = the first), from `concentrations` or else from the lines.
    fn begin_round(&mut self, concentrations: Option<&[Vec<f32>]>, round: usize) -> Result<bool, LayerError> {
        let taken = self.pairs.steps();
        let pairs = grown_from(&self.plan, &self.form, &self.factors, &self.begun, concentrations);
        self.pairs = pairs.ok_or(LayerError::NoRoom)?;
        self.steps = [self.pairs.steps_in(times(self.form.kind())[round]), self.steps[1] + taken];
        Ok(false)
    }

    /// Changes the distances of the lines that threads begin from, by the errors of the distances of those that have grown. Returns whether
    /// an error is so large that they must begin anew.
    fn corrects_periods(&mut self, reports: &[ThreadReport]) -> bool {
        let (factors, rounds) = &mut self.periods;
        let errors = || reports.iter().filter_map(|threads| threads.error.map(|error| error.wavelength));
        if *rounds >= MOST_PERIODS || errors().all(|error| error.abs() < SAME_PERIOD) {
            return false;
        }
        *rounds += 1;
        for (factor, error) in factors.iter_mut().zip(errors()) {
            *factor = (*factor / (1.0 + error)).clamp(PERIODS[0], PERIODS[1]);
        }
        true
    }

    /// The share of the work that is done, 0..1.
    #[must_use]
    pub fn share(&self) -> f64 {
        let rounds = 1.0 + self.corrections[1].min(1) as f64;
        let own = self.pairs.steps() as f64 / self.steps[0].max(1) as f64;
        ((self.corrections[0] as f64 + own) / rounds).min(1.0)
    }

    /// What has grown; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownThreads> {
        let Grown { patterns, reports } = self.grown?;
        let steps = self.steps[1] + self.pairs.steps();
        let highest = |vertex: usize| {
            let shown = patterns.iter().filter(|_| !self.plan.maps.is_obstacle(vertex));
            shown.map(|own| own[vertex]).fold(0.0, f32::max)
        };
        let marks = (0..self.plan.maps.parameters.len()).map(highest).collect();
        Some(GrownThreads { plan: self.plan, marks, reports, steps })
    }
}

/// The pairs of these threads, whose sizes are changed by `factors`; from concentrations of an earlier round, or from the `begun` lines.
fn grown_from(
    plan: &BodyPlan,
    form: &ThreadForm,
    factors: &[f64],
    begun: &[f32],
    concentrations: Option<&[Vec<f32>]>,
) -> Option<SurfacePairs> {
    let pairs = pairs(plan, form, factors);
    let least = pairs.iter().flat_map(|pair| &pair.size).copied().fold(f32::INFINITY, f32::min);
    let model = form.form.model(least);
    let maps = SurfacePairField { surface: plan.surface(), pairs: &pairs, obstacles: &plan.maps.obstacles };
    match concentrations {
        Some(concentrations) => SurfacePairs::resumed(&maps, &model, concentrations),
        None => SurfacePairs::from_reaction(&maps, &model, begun),
    }
}

/// Whether threads are equally wide and far apart everywhere.
fn is_even(wanted: &[Attributes]) -> bool {
    let sizes = |wanted: &Attributes| match wanted {
        Attributes::Stripes(stripes) => [Some(stripes.width), stripes.wavelength],
        Attributes::Spots(_) => [None; 2],
    };
    wanted.iter().all(|other| sizes(other) == sizes(&wanted[0]))
}

/// Direction and size of the pair of each direction, by vertex.
fn pairs(plan: &BodyPlan, form: &ThreadForm, factors: &[f64]) -> Vec<PairField> {
    let unit = plan.surface().unit();
    let sizes = |wanted: &Attributes| match wanted {
        Attributes::Stripes(first) => form.sizes(first, factors),
        Attributes::Spots(_) => Vec::new(),
    };
    let sizes: Vec<Vec<f64>> = if is_even(&plan.wanted) {
        vec![sizes(&plan.wanted[0]); plan.wanted.len()]
    } else {
        plan.wanted.par_iter().map(sizes).collect()
    };
    let largest = |pair: usize| sizes.iter().filter_map(|own| own.get(pair)).copied().fold(0.0, f64::max);
    let count = form.lines.len();
    let of_all = (0..count).map(largest).fold(0.0, f64::max);
    let angle = |vertex: usize, pair: usize| {
        directions_at(plan, form, vertex).get(pair).map_or(0.0, |own: &Stripes| own.angle)
    };
    let pair = |pair: usize| PairField {
        direction: (0..sizes.len()).map(|vertex| angle(vertex, pair) as f32).collect(),
        size: sizes.iter().map(|own| (own.get(pair).copied().unwrap_or(unit) / unit) as f32).collect(),
        blurs: form.form.blurs(count, largest(pair), of_all),
    };
    (0..count).map(pair).collect()
}
