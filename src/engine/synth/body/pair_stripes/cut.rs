//! The pattern of stripes with tips on a surface, from the difference of their pair.

use crate::attributes::Attributes;
use crate::synth::body::plan::BodyPlan;
use crate::synth::pairs::grown::middle_of_threads;
use crate::synth::pairs::plan::GROUND;
use crate::synth::pattern::share;

/// The pattern by vertex, 0..1, ½ at the edges of stripes. The reaction has the threshold 0, so that half of the surface is above it: at each
/// vertex the edge is where the share of the surface lies above that stripes shall cover there. Nothing is shown on obstacles.
#[must_use]
pub fn cut_by_duty(plan: &BodyPlan, difference: &[f32]) -> Vec<f32> {
    let exceeded_by = quantiles(plan, difference);
    let ground = exceeded_by(1.0 - GROUND);
    let above: Vec<f32> = difference.iter().map(|value| value - ground).collect();
    let level = |vertex: usize| exceeded_by(duty(&plan.wanted[vertex])) - ground;
    let peak = middle_of_threads(&above, level(0));
    let value = |(vertex, value): (usize, &f32)| {
        if plan.maps.is_obstacle(vertex) { 0.0 } else { share(value / peak, level(vertex) / peak) }
    };
    above.iter().enumerate().map(value).collect()
}

fn duty(wanted: &Attributes) -> f64 {
    if let Attributes::Stripes(stripes) = wanted { stripes.duty() } else { 0.5 }
}

/// The value that is exceeded on a share, 0..1, of the free surface.
fn quantiles(plan: &BodyPlan, values: &[f32]) -> impl Fn(f64) -> f32 {
    let mut free: Vec<(f32, usize)> =
        values.iter().copied().zip(0..).filter(|(_, vertex)| !plan.maps.is_obstacle(*vertex)).collect();
    free.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut sum = 0.0;
    let covered: Vec<(f64, f32)> = free
        .into_iter()
        .map(|(value, vertex)| {
            sum += plan.surface().cell_area(vertex);
            (sum, value)
        })
        .collect();
    move |share| {
        let index = covered.partition_point(|(covered, _)| *covered < share * sum);
        covered.get(index.min(covered.len().saturating_sub(1))).map_or(0.0, |(_, value)| *value)
    }
}
