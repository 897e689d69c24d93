//! The level at which spots have the area that is asked for.

use rayon::prelude::*;

use crate::measure::{SurfaceSpot, surface_spots};
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::refusals::system;
use crate::synth::passes::{Levelling, Thresholds};
use crate::synth::pattern::{EDGE, share};

/// The lowest and the highest level that is used. Not tuned.
const RANGE: [f64; 2] = [0.08, 0.92];

/// The whole spots about each anchor.
pub struct Measured {
    /// All spots.
    pub spots: Vec<SurfaceSpot>,
    /// The anchor that each is nearest to.
    pub anchor: Vec<usize>,
    /// Sums over the whole spots of each anchor.
    pub sums: Vec<Sums>,
}

/// Sums over whole spots.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// How many.
    pub count: usize,
    /// Of their areas, px².
    pub area: f64,
    /// Of the areas wanted at their places, px².
    pub wanted: f64,
}

impl Measured {
    /// Measures the spots of a pattern.
    #[must_use]
    pub fn new(plan: &BodyPlan, pattern: &[f32]) -> Self {
        let spots = surface_spots(plan.surface(), pattern, &vec![EDGE; pattern.len()]);
        let at: Vec<usize> = spots.iter().map(|spot| plan.surface().vertex_of(spot.place)).collect();
        let anchor: Vec<usize> = at.iter().map(|vertex| plan.influence.nearest(*vertex)).collect();
        let mut sums = vec![Sums::default(); plan.anchors.len()];
        for ((spot, vertex), anchor) in spots.iter().zip(&at).zip(&anchor).filter(|((spot, _), _)| spot.whole)
        {
            sums[*anchor].count += 1;
            sums[*anchor].area += spot.area;
            sums[*anchor].wanted += plan.wanted[*vertex].area;
        }
        Self { spots, anchor, sums }
    }

    /// got ÷ wanted − 1 of the area about each anchor; `None` where no spot is whole.
    fn errors(&self) -> Vec<Option<f64>> {
        self.sums.iter().map(|sums| (sums.count > 0).then(|| sums.area / sums.wanted - 1.0)).collect()
    }
}

/// The pattern of concentrations with the looked-up levels times a factor for each anchor.
#[must_use]
pub fn levelled(plan: &BodyPlan, marks: &[f32], factors: &[f64]) -> Vec<f32> {
    let logarithms: Vec<f64> = factors.iter().map(|factor| libm::log(*factor)).collect();
    let at = |vertex: usize| {
        let factor = libm::exp(plan.influence.mean(vertex, &logarithms));
        let level = (f64::from(plan.levels[vertex]) * factor).clamp(RANGE[0], RANGE[1]);
        share(marks[vertex], level as f32)
    };
    (0..marks.len()).into_par_iter().map(at).collect()
}

/// A pattern whose spots have the area that is wanted about each anchor, on average.
pub struct Levelled {
    /// By vertex: 0 the ground, ½ an edge, 1 the middle of a spot.
    pub pattern: Vec<f32>,
    /// What is measured with the looked-up levels.
    pub before: Vec<Sums>,
    /// What is measured in the pattern.
    pub measured: Measured,
}

impl Levelled {
    /// Corrects the levels by the pass that canvases share; not at all unless it `corrects`.
    #[must_use]
    pub fn new(plan: &BodyPlan, marks: &[f32], corrects: bool) -> Self {
        let mut shown = Shown::new(plan, marks);
        let before = shown.measured.sums.clone();
        if corrects {
            let mut levelling = Levelling::new(&shown);
            while levelling.advance(&mut shown).is_some() {}
        }
        Self { pattern: shown.pattern, before, measured: shown.measured }
    }
}

/// Concentrations at thresholds that can be moved about each anchor.
struct Shown<'a> {
    plan: &'a BodyPlan,
    marks: &'a [f32],
    factors: Vec<f64>,
    pattern: Vec<f32>,
    measured: Measured,
    errors: Vec<Option<f64>>,
}

impl<'a> Shown<'a> {
    /// The pattern with the looked-up levels.
    fn new(plan: &'a BodyPlan, marks: &'a [f32]) -> Self {
        let factors = vec![1.0; plan.anchors.len()];
        let pattern = levelled(plan, marks, &factors);
        let measured = Measured::new(plan, &pattern);
        let errors = measured.errors();
        Self { plan, marks, factors, pattern, measured, errors }
    }
}

impl Thresholds for Shown<'_> {
    fn thresholds(&self) -> &[f64] {
        &self.factors
    }

    /// Levels themselves stay within a range, at each vertex.
    fn range(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn slopes(&self) -> Vec<f64> {
        vec![system().definition().level_slope; self.factors.len()]
    }

    fn size_errors(&self) -> &[Option<f64>] {
        &self.errors
    }

    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
        let steps: Vec<f64> = wanted.iter().map(|step| step.unwrap_or(0.0)).collect();
        self.factors.iter_mut().zip(&steps).for_each(|(factor, step)| *factor *= libm::exp(*step));
        self.pattern = levelled(self.plan, self.marks, &self.factors);
        self.measured = Measured::new(self.plan, &self.pattern);
        self.errors = self.measured.errors();
        steps
    }
}
