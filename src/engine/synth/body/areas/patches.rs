//! Patches on a surface: the same claims of scattered points as on a canvas ([`crate::points::patches`]).

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::discs::poisson_discs;
use super::graph::SurfaceGraph;
use super::interpolation::interpolate;
use crate::attributes::{Attributes, Spread};
use crate::grid::Domain;
use crate::points::discs::POINTS_A_SQUARE;
use crate::points::patches::{Patches, Wanted, axis_length, claimed, fringe, room, varied};
use crate::surface::SurfacePoint;
use crate::synth::body::plan::BodyPlan;

/// The distance from a vertex to the nearest point, at most, in radii of discs: no vertex lies outside of all discs.
const FARTHEST: f64 = 1.5;
/// Patches that vary less than this are equal.
const LEAST: f64 = 1e-3;

/// How ragged patches are, and of how many points they are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchForm {
    /// σ of the noise by which points are claimed, 0 to 1, or the raggedness that is wanted.
    pub ragged: Ragged,
    /// Points a patch.
    pub detail: f64,
}

/// What says how ragged patches are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ragged {
    /// σ.
    Given(f64),
    /// Contour² ÷ contour² of the ellipse of the same moments.
    Drawn(f64),
}

impl PatchForm {
    /// The patch that is wanted where spots of these attributes are.
    #[must_use]
    pub fn wanted(&self, wanted: &Attributes, spread: Spread) -> Option<Wanted> {
        let Attributes::Spots(spots) = wanted else { return None };
        let spacing = spots.spacing?;
        let patch = Wanted {
            area: spots.area,
            spacing,
            aspect: spots.aspect,
            angle: spots.angle,
            raggedness: 1.0,
            spread,
        };
        let raggedness = match self.ragged {
            Ragged::Given(sigma) => patch.raggedness_of(sigma, self.detail),
            Ragged::Drawn(raggedness) => raggedness,
        };
        Some(Wanted { raggedness, ..patch })
    }

    /// The radius of the discs around the points of a patch, px.
    #[must_use]
    pub fn radius(&self, wanted: &Wanted) -> f64 {
        disc(wanted, wanted.points(self.detail))
    }
}

/// The radius of the discs of patches of so many points, px.
fn disc(wanted: &Wanted, points: f64) -> f64 {
    (POINTS_A_SQUARE * wanted.area / points.clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL)).sqrt()
}

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
    let mut values = interpolate(&graph, &labelled.values, axis_length(most_ragged));
    values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
    values
}
