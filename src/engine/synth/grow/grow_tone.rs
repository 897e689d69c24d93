//! Plans of layers that a picture drives, or a growth → what has grown.

use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::synth::grow::layer::GrowError;
use crate::synth::grow::pattern::EDGE;
use crate::synth::grow::tone::{GrownTone, gains, levels, measure, relief};
use crate::synth::grow::tone_growth::ToneGrowth;
use crate::synth::options::Options;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::tone::TonePlan;
use crate::synth::watch::Stage;

/// Standard deviation of the surroundings in which the share of ink is the tone, wavelengths: of stripes, and of spots, whose gaps are
/// wider.
const AROUND: [f64; 2] = [0.5, 0.6];

/// Grows layer number `layer` (1 = the lowest) as planned; `every` is the normalised time between two snapshots.
pub(super) fn grow_tone(
    plan: TonePlan,
    layer: usize,
    seed: u64,
    options: &Options,
    every: Option<f64>,
    seen: &mut dyn FnMut(&TonePlan, &ToneGrowth),
) -> Result<GrownTone, GrowError> {
    let watch = options.watch;
    watch.step(Stage::Plan, 0.5)?;
    let mut growth = during(Phase::LayOut, || ToneGrowth::new(&plan, seed));
    if !growth.can_start() {
        return Err(GrowError::NoRoom { layer });
    }
    watch.step(Stage::Plan, 1.0)?;
    let settled = growth.settle(every, &watch, &mut |growth| seen(&plan, growth))?;
    let marks = growth.marks();
    if !marks.values.iter().all(|value| value.is_finite()) {
        return Err(GrowError::NoPattern { layer });
    }
    watch.step(Stage::Refine, 0.0)?;
    let relief = during(Phase::Measure, || relief(&marks, plan.system, plan.wavelength));
    let Levelled { levels, gains, ink } = during(Phase::Measure, || levelled(&plan, &relief));
    watch.step(Stage::Refine, 0.5)?;
    let what = match (ink.contains(&1.0), ink.contains(&0.0)) {
        (false, _) => Some("no marks"),
        (_, false) => Some("marks without any ground between them"),
        _ => None,
    };
    if let Some(what) = what {
        return Err(GrowError::Blank { layer, what });
    }
    let measured = during(Phase::Measure, || measure(&plan, &ink, &relief));
    watch.step(Stage::Refine, 1.0)?;
    let concentrations = if options.concentrations { growth.concentrations() } else { Vec::new() };
    let steps = growth.steps();
    let ink = f64::from(ink.iter().sum::<f32>()) / ink.len().max(1) as f64;
    Ok(GrownTone { plan, steps, settled, relief, levels, gains, ink, measured, concentrations })
}

/// How a relief is cut, at the px of the tone.
struct Levelled {
    levels: Field,
    /// How many times its heights are stretched.
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

/// The one level with which the whole canvas has as much ink as its tone.
fn even_level(plan: &TonePlan, heights: &[f32]) -> f32 {
    let mean = plan.tone.iter().map(|tone| f64::from(*tone)).sum::<f64>() / plan.tone.len().max(1) as f64;
    let mut sorted = heights.to_vec();
    sorted.sort_unstable_by(f32::total_cmp);
    let lower = ((1.0 - mean).clamp(0.0, 1.0) * sorted.len() as f64) as usize;
    sorted.get(lower.min(sorted.len().saturating_sub(1))).copied().unwrap_or(0.5)
}
