//! The reaction that stripes with tips on a surface begin from: noise, and lines along the paths that are kept.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::document::Document;
use crate::grid::Domain;
use crate::surface::{SurfacePoint, distances};
use crate::synth::body::begin::kept_paths;
use crate::synth::body::given_directions::pieces;
use crate::synth::body::pair_form::period;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::pairs::grow::BESIDE;

/// White noise at each vertex, 0..1; on the kept paths of the model 1, and beside them 0. On obstacles it is 0.
#[must_use]
pub fn noise_around_paths(document: &Document, placed: &Placed, plan: &BodyPlan) -> Vec<f32> {
    let surface = plan.surface();
    let mut random = Pcg64Mcg::seed_from_u64(document.layer_seed(plan.layer));
    let mut reaction: Vec<f32> = (0..surface.cells()).map(|_| random.random::<f32>()).collect();
    let places: Vec<SurfacePoint> = kept_paths(document, plan.layer)
        .flat_map(|points| pieces(points, surface, placed, surface.unit()))
        .map(|piece| piece.middle)
        .collect();
    let away = if places.is_empty() { Vec::new() } else { distances(surface, &places) };
    for (vertex, value) in reaction.iter_mut().enumerate() {
        let period = period(&plan.wanted[vertex]);
        if plan.maps.is_obstacle(vertex) {
            *value = 0.0;
        } else if let Some(away) = away.get(vertex).filter(|away| **away < BESIDE * period) {
            // The threshold is 0, so that lines grow half as wide as their period.
            *value = ((0.25 * period - away) / surface.unit() + 0.5).clamp(0.0, 1.0) as f32;
        }
    }
    reaction
}
