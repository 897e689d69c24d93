//! The level at which spots have the area that is asked for.

use rayon::prelude::*;

use crate::measure::{SurfaceSpot, surface_spots};
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::refusals::system;
use crate::synth::pattern::{EDGE, share};

/// Rounds of measuring and correcting: after four, mean areas are right to 1e-7 (five bodies, five seeds).
const ROUNDS: usize = 4;
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
    /// Corrects the levels in a few rounds of measuring; in none unless it `corrects`.
    #[must_use]
    pub fn new(plan: &BodyPlan, marks: &[f32], corrects: bool) -> Self {
        let slope = system().definition().level_slope;
        let mut factors = vec![1.0; plan.anchors.len()];
        let mut pattern = levelled(plan, marks, &factors);
        let mut measured = Measured::new(plan, &pattern);
        let before = measured.sums.clone();
        for _ in 0..if corrects { ROUNDS } else { 0 } {
            for (factor, sums) in factors.iter_mut().zip(&measured.sums).filter(|(_, sums)| sums.count > 0) {
                *factor *= libm::pow(sums.wanted / sums.area, 1.0 / slope);
            }
            pattern = levelled(plan, marks, &factors);
            measured = Measured::new(plan, &pattern);
        }
        Self { pattern, before, measured }
    }
}
