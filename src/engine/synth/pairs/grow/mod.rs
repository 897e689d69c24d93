//! The growth of pairs from their plan.

mod growing;
mod maze_pieces;
mod nearest_line;
mod noise;
mod seed_lines;

use crate::attributes::{Attributes, Stripes};
use crate::grid::Field;
use crate::measure::{Regions, StripeErrors, Target, blotch_width, stripe_errors};
use crate::rd::pairs::{HELD, PairGrowth, PairKind, PairStart};
use crate::synth::pairs::plan::thread_map::ThreadMap;
use crate::synth::pairs::plan::{FROM_NOISE, PairPlan};
use crate::synth::profile::{Section, during};

pub use growing::PairsGrowth;
pub(in crate::synth::pairs) use growing::seen;
pub(in crate::synth) use noise::BESIDE;

/// Time from the start, and after a correction, in 1/b. After 8 and 6, the errors of the widths of 40 random weaves did not change;
/// after 20 and 10 the widths of five differed by less than a hundredth.
const TIMES: [f64; 2] = [7.0, 4.0];
/// Total time of a growth that is corrected, including the start, in 1/b.
#[must_use]
pub fn whole_time(kind: PairKind) -> f64 {
    let [first, second] = times(kind);
    let start = if kind == PairKind::Stripes { 2.0 * HELD } else { HELD };
    start + first + if most_corrections(kind) > 0 { second } else { 0.0 }
}

/// Largest number of corrections by growing again. For mazes and stucco only the threshold is corrected. Stripes with tips begin
/// from noise each time.
#[must_use]
pub(in crate::synth) fn most_corrections(kind: PairKind) -> usize {
    match kind {
        PairKind::Weave => SAME_WIDTH.len(),
        PairKind::Stripes => 1,
        PairKind::Maze | PairKind::Stucco => 0,
    }
}

/// Times of the first round and of those after it, in 1/b.
#[must_use]
pub(in crate::synth) fn times(kind: PairKind) -> [f64; 2] {
    match kind {
        PairKind::Weave | PairKind::Maze => TIMES,
        PairKind::Stripes | PairKind::Stucco => [FROM_NOISE; 2],
    }
}

/// Range of the correction factor of the width: a pair with a larger error has merged or vanishes, which no change of the width
/// repairs.
const CORRECTED: [f64; 2] = [0.8, 1.25];
/// Range of the threshold of a maze, relative to that at which X is 0: beyond it lines break or merge.
const LEVELS: [f32; 2] = [0.3, 1.7];
/// Most steps of the search for this threshold.
const LEVEL_ROUNDS: usize = 8;
/// Relative difference of mean widths below which no other threshold is tried.
const SAME_LEVEL: f32 = 0.002;
/// Relative errors of the width below which it is not corrected, for the first and the second time.
const SAME_WIDTH: [f64; 2] = [0.015, 0.04];
/// Relative error of the period of pair stripes below which it is not corrected: a correction starts again from noise.
const SAME_PERIOD: f64 = 0.015;

/// A planned growth, with sizes by these `factors`, see [`PairPlan::maps`].
pub fn begin(plan: &PairPlan, factors: &[f64], start: &PairStart) -> PairGrowth {
    let maps = during(Section::Parameters, || plan.maps(factors));
    let model = plan.model(&maps);
    during(Section::Coefficients, || PairGrowth::new(&maps, &model, start)).expect("maps of one grid")
}

/// Measures the threads of each direction, whose edges are at these thresholds (`levels`).
fn measure(plan: &PairPlan, differences: &[Field], levels: &[f32]) -> Vec<StripeErrors> {
    if plan.kind() != PairKind::Weave {
        return measure_pieces(plan, &differences[0], levels[0]);
    }
    let of = |((threads, difference), level): ((&ThreadMap, &Field), &f32)| {
        let target = Target {
            bounds: plan.canvas(),
            regions: Regions::ONE,
            covered: &|point| plan.is_taken(point),
            wanted: &|point| Attributes::Stripes(threads.at(point)),
            surface: None,
        };
        stripe_errors(difference, *level, &target).remove(0)
    };
    plan.threads.iter().zip(differences).zip(levels).map(of).collect()
}

/// Measures one shown field; for a maze the pieces of each direction.
fn measure_pieces(plan: &PairPlan, shown: &Field, level: f32) -> Vec<StripeErrors> {
    if plan.kind() == PairKind::Stucco {
        return vec![measure_blotches(plan, shown, level)];
    }
    let piece = |point: [f64; 2]| plan.piece_at(point);
    let target = Target {
        bounds: plan.canvas(),
        regions: Regions::Any(plan.threads.len(), &piece),
        covered: &|point| plan.is_taken(point),
        wanted: &|point| Attributes::Stripes(plan.threads[piece(point)].at(point)),
        surface: None,
    };
    stripe_errors(shown, level, &target)
}

/// Measures blotches, which have a width alone.
fn measure_blotches(plan: &PairPlan, shown: &Field, level: f32) -> StripeErrors {
    let width = plan.threads[0].mean_width(&plan.canvas());
    let wanted = Stripes { width, angle: 0.0, wavelength: None };
    let width = blotch_width(shown, level);
    StripeErrors {
        got: width.map(|width| Stripes { width, angle: 0.0, wavelength: None }),
        wanted: Some(wanted),
        width: width.map(|width| width / wanted.width - 1.0),
        ..StripeErrors::default()
    }
}

/// The threshold at which lines and blotches of one shown field have the wanted width, by the rule of false position.
fn level_of_width(plan: &PairPlan, shown: &Field) -> f32 {
    let off = |level: f32| {
        let errors = measure_pieces(plan, shown, level).into_iter().filter_map(|of| of.width);
        let all: Vec<f64> = errors.collect();
        // If nothing is left, everything is too thin.
        if all.is_empty() { -1.0 } else { (all.iter().sum::<f64>() / all.len() as f64) as f32 }
    };
    let own = plan.levels()[0];
    // The higher the threshold, the narrower they are.
    let [mut low, mut high] = LEVELS.map(|level| level * own);
    let (mut level, mut error) = (own, off(own));
    let mut before: Option<[f32; 2]> = None;
    for _ in 0..LEVEL_ROUNDS {
        if error.abs() < SAME_LEVEL {
            break;
        }
        *(if error > 0.0 { &mut low } else { &mut high }) = level;
        let slope = before.map_or(-1.0 / own, |[at, of]| (error - of) / (level - at));
        let next = level - error / slope;
        let next = if low < next && next < high { next } else { 0.5 * (low + high) };
        before = Some([level, error]);
        (level, error) = (next, off(next));
    }
    level
}

/// Corrects the `factors` of widths (for pair stripes of periods) by the measured errors, after `before` earlier corrections.
/// Returns whether any error is large enough.
fn correct(plan: &PairPlan, measured: &[StripeErrors], factors: &mut [f64], before: usize) -> bool {
    let stripes = plan.kind() == PairKind::Stripes;
    let error = |threads: &StripeErrors| if stripes { threads.wavelength } else { threads.width };
    let errors: Vec<Option<f64>> = measured.iter().map(error).collect();
    corrected(plan.kind(), &errors, factors, before)
}

/// Corrects the `factors` by these errors of widths, or of the periods of stripes, after `before` earlier corrections. Returns whether any
/// error is large enough.
pub(in crate::synth) fn corrected(
    kind: PairKind,
    errors: &[Option<f64>],
    factors: &mut [f64],
    before: usize,
) -> bool {
    let same = if kind == PairKind::Stripes { SAME_PERIOD } else { SAME_WIDTH[before] };
    let mut differs = false;
    for (error, factor) in errors.iter().zip(factors) {
        let correction = (1.0 / (1.0 + error.unwrap_or(0.0))).clamp(CORRECTED[0], CORRECTED[1]);
        differs |= (correction - 1.0).abs() > same;
        *factor *= correction;
    }
    differs
}
