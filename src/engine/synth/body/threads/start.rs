//! What threads on a surface begin from: lines along the crests of phases, or noise beside the paths that are drawn on the model.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::attributes::{Attributes, Stripes};
use crate::document::{BodyMark, Document};
use crate::grid::Domain;
use crate::rd::{ParameterField, initial_waves};
use crate::surface::{Surface, SurfacePoint, distances};
use crate::synth::body::begin::keeps;
use crate::synth::body::given_directions::pieces;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::thread_form::ThreadForm;
use crate::synth::error::LayerError;
use crate::synth::pairs::grow::{BESIDE, seed_line};

/// What is wanted of the threads of each direction at a vertex.
#[must_use]
pub fn directions_at(plan: &BodyPlan, form: &ThreadForm, vertex: usize) -> Vec<Stripes> {
    match &plan.wanted[vertex] {
        Attributes::Stripes(first) => form.directions(first),
        Attributes::Spots(_) => Vec::new(),
    }
}

/// The reaction at each vertex, 0..1, that the threads of a plan begin from: 1 on a line. Lines are `periods` times as far apart as is wanted,
/// by direction.
///
/// # Errors
/// Nothing finds room.
pub fn start(
    document: &Document,
    placed: &Placed,
    plan: &BodyPlan,
    form: &ThreadForm,
    periods: &[f64],
) -> Result<Vec<f32>, LayerError> {
    let mut reaction = match form.second {
        Some(_) => lines(document, plan, form, periods).ok_or(LayerError::NoRoom)?,
        None => noise(document, placed, plan),
    };
    for (vertex, value) in reaction.iter_mut().enumerate() {
        if plan.maps.is_obstacle(vertex) {
            *value = 0.0;
        }
    }
    Ok(reaction)
}

/// Lines of both directions along the crests of phases. Unlike on a canvas the threshold is not raised between them: where directions turn,
/// lines end, and the tips of threads must find to each other.
fn lines(document: &Document, plan: &BodyPlan, form: &ThreadForm, periods: &[f64]) -> Option<Vec<f32>> {
    let surface = plan.surface();
    let cells = surface.cells();
    let mut reaction = vec![0.0f32; cells];
    let wanted: Vec<Vec<Stripes>> = (0..cells).map(|vertex| directions_at(plan, form, vertex)).collect();
    for (direction, factor) in periods.iter().enumerate() {
        let mut maps = of_direction(plan, form, direction);
        maps.parameters.iter_mut().for_each(|p| p.pitch *= *factor as f32);
        let seed = document.layer_seed(plan.layer).wrapping_add(direction as u64);
        let phases = initial_waves(plan.choice.system, &maps, seed, &[])?;
        for (vertex, phase) in phases.iter().enumerate() {
            let Some(own) = wanted[vertex].get(direction) else { continue };
            let from_middle =
                f64::from(phase.abs()) / std::f64::consts::TAU * own.wavelength.unwrap_or(own.width);
            let [covered, _] = seed_line(own.width, from_middle, surface.unit());
            reaction[vertex] = reaction[vertex].max(covered);
        }
    }
    Some(reaction)
}

/// The parameters by which the lines of one direction are laid.
fn of_direction(plan: &BodyPlan, form: &ThreadForm, direction: usize) -> ParameterField<Surface> {
    let mut maps = plan.maps.clone();
    if let Some(second) = form.second.filter(|_| direction > 0) {
        for p in &mut maps.parameters {
            p.direction += second.turn as f32;
            p.pitch *= second.period as f32;
        }
    }
    maps
}

/// White noise; on the kept paths of the model 1, and beside them 0.
fn noise(document: &Document, placed: &Placed, plan: &BodyPlan) -> Vec<f32> {
    let surface = plan.surface();
    let mut random = Pcg64Mcg::seed_from_u64(document.layer_seed(plan.layer));
    let mut reaction: Vec<f32> = (0..surface.cells()).map(|_| random.random::<f32>()).collect();
    let paths = document.layers[plan.layer].on_model.iter().filter_map(|mark| match mark {
        BodyMark::Path { points, .. } => Some(points),
        BodyMark::Ellipse(_) => None,
    });
    let places: Vec<SurfacePoint> = paths
        .filter(|_| keeps(document, plan.layer))
        .flat_map(|points| pieces(points, surface, placed, surface.unit()))
        .map(|piece| piece.middle)
        .collect();
    if !places.is_empty() {
        for ((value, away), wanted) in reaction.iter_mut().zip(distances(surface, &places)).zip(&plan.wanted)
        {
            // The threshold is 0, so that lines grow half as wide as their period.
            let period = wanted.distance().unwrap_or(0.0);
            if away < BESIDE * period {
                *value = ((0.25 * period - away) / surface.unit() + 0.5).clamp(0.0, 1.0) as f32;
            }
        }
    }
    reaction
}
