//! The pattern of each direction of threads on a surface, from the differences of the pairs.

use crate::attributes::Attributes;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::thread_form::ThreadForm;
use crate::synth::pairs::grown::middle_of_threads;
use crate::synth::pairs::plan::{GROUND, PairForm};
use crate::synth::pattern::share;

/// The pattern of each direction by vertex, 0..1, ½ at the edges of its threads.
#[must_use]
pub fn shown(plan: &BodyPlan, form: &ThreadForm, differences: &[Vec<f32>]) -> Vec<Vec<f32>> {
    match &form.form {
        PairForm::Weave(weave) => {
            let levels = weave.levels();
            differences.iter().zip(&levels).map(|(of, level)| of_level(of, &|_| *level, *level)).collect()
        }
        _ => vec![cut_by_duty(plan, &differences[0])],
    }
}

/// The pattern whose edges are at these levels, of which `usual` is one.
fn of_level(difference: &[f32], level: &dyn Fn(usize) -> f32, usual: f32) -> Vec<f32> {
    let peak = middle_of_threads(difference, usual);
    let value = |(vertex, value): (usize, &f32)| share(value / peak, level(vertex) / peak);
    difference.iter().enumerate().map(value).collect()
}

/// The pattern of stripes, whose reaction has the threshold 0: half of the surface is above it. At each vertex the edge is where the share of
/// the surface that threads shall cover there lies above.
fn cut_by_duty(plan: &BodyPlan, difference: &[f32]) -> Vec<f32> {
    let surface = plan.surface();
    let mut order: Vec<usize> =
        (0..difference.len()).filter(|vertex| !plan.maps.is_obstacle(*vertex)).collect();
    order.sort_unstable_by(|a, b| difference[*b].total_cmp(&difference[*a]).then(a.cmp(b)));
    let mut covered = Vec::with_capacity(order.len());
    let mut sum = 0.0;
    for vertex in &order {
        sum += surface.cell_area(*vertex);
        covered.push(sum);
    }
    let exceeded_by = |share: f64| {
        let index =
            covered.partition_point(|covered| *covered < share * sum).min(order.len().saturating_sub(1));
        order.get(index).map_or(0.0, |vertex| difference[*vertex])
    };
    let ground = exceeded_by(1.0 - GROUND);
    let above: Vec<f32> = difference.iter().map(|value| value - ground).collect();
    let duty = |wanted: &Attributes| if let Attributes::Stripes(own) = wanted { own.duty() } else { 0.5 };
    let level = |vertex: usize| exceeded_by(duty(&plan.wanted[vertex])) - ground;
    of_level(&above, &level, level(0))
}
