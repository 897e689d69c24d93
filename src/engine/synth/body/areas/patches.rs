//! Patches on a surface: the same claims of scattered points as on a canvas ([`crate::points::patches`]).

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::discs::poisson_discs;
use super::graph::SurfaceGraph;
use super::interpolation::{Weighing, interpolate};
use crate::grid::Domain;
use crate::points::patches::{Wanted, axis_length, claimed, fringe, room, varied};
use crate::surface::SurfacePoint;
use crate::synth::body::area_form::{PatchForm, disc};
use crate::synth::body::plan::BodyPlan;

/// The distance from a vertex to the nearest point, at most, in radii of discs: no vertex lies outside of all discs.
const FARTHEST: f64 = 1.5;
/// Patches that vary less than this are equal.
const LEAST: f64 = 1e-3;

/// How much of a patch each vertex shows, 0..1, ½ about its edge; the patches begin at these `centers`.
#[must_use]
pub fn grown(plan: &BodyPlan, form: &PatchForm, centers: &[SurfacePoint], seed: u64) -> Vec<f32> {
    let surface = plan.surface();
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let spread = |vertex: usize| plan.anchors[plan.influence.nearest(vertex)].spread;
    let wanted = |vertex: usize| form.wanted(&plan.wanted[vertex], spread(vertex));
    let coarse = |vertex: usize| wanted(vertex).map_or(surface.unit(), |wanted| disc(&wanted, form.detail));
    let fine = |vertex: usize| wanted(vertex).map_or(surface.unit(), |wanted| form.radius(&wanted));
    let detailed = poisson_discs(surface, &coarse, centers, &mut rng);
    let places = poisson_discs(surface, &fine, &detailed, &mut rng);
    let graph = SurfaceGraph::new(surface, places, &|vertex| FARTHEST * fine(vertex));
    let noise = fringe(&graph, detailed.len(), &mut rng);
    let mut asked: Vec<Wanted> =
        centers.iter().filter_map(|center| wanted(surface.vertex_of(*center))).collect();
    if asked
        .iter()
        .any(|wanted| wanted.spread.area.max(wanted.spread.aspect).max(wanted.spread.angle) > LEAST)
    {
        asked = varied(&asked, &room(&graph, asked.len(), 0), form.detail, &mut rng);
    }
    let away = if plan.maps.obstacles.is_empty() { None } else { surface.distances(&plan.maps.obstacles) };
    let is_taken = |point: usize| {
        let vertex = graph.vertex(point);
        away.as_ref().is_some_and(|away| away[vertex] * surface.unit() < fine(vertex))
    };
    let taken: Vec<bool> = (0..graph.places.len()).map(is_taken).collect();
    let labelled = claimed(&graph, &asked, form.detail, noise, &taken);
    let most_ragged = asked.iter().map(|wanted| wanted.raggedness).fold(1.0, f64::max);
    let mut values = interpolate(&graph, &labelled.values, &Weighing::smooth(axis_length(most_ragged)));
    values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
    values
}
