//! What a layer begins from on a surface: spots at places that repulsion lays, stripes from waves along the field of directions.

use crate::attributes::Attributes;
use crate::document::{After, BodyMark, Document, Seeding};
use crate::measure::surface_stripes;
use crate::rd::{
    GuideSegment, Parameters, PinnedSpot, Places, from_places, from_wave_values, initial_waves, waves_from,
};
use crate::surface::{Surface, SurfacePoint, distances};
use crate::synth::body::anchors::{ellipses, place_of};
use crate::synth::body::areas::{self, GrownAreas};
use crate::synth::body::given_directions::{Piece, pieces};
use crate::synth::body::laid::lay;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::varied::vary;
use crate::synth::error::LayerError;
use crate::synth::report::PointsReport;

/// Initial concentrations.
pub struct Initial {
    /// One vector a chemical, by vertex. Of areas, which do not react, the one that shows them.
    pub concentrations: Vec<Vec<f32>>,
    /// How many spots were laid; 0 of stripes.
    pub laid: usize,
    /// The report of a field of points; `None` of other marks.
    pub points: Option<PointsReport>,
}

/// The initial concentrations of a planned layer. `coarse` is a mesh of the same model with longer edges, and `beneath` are the layers
/// that have grown before.
///
/// # Errors
/// Nothing finds room.
pub fn begin(
    document: &Document,
    placed: &Placed,
    plan: &mut BodyPlan,
    coarse: &Surface,
    beneath: &[BodyLayer],
) -> Result<Initial, LayerError> {
    if plan.choice.system.is_striped() {
        return Ok(Initial { concentrations: stripes(document, placed, plan)?, laid: 0, points: None });
    }
    let seed = document.layer_seed(plan.layer);
    let pinned = pinned(document, placed, plan);
    if let Some(form) = plan.choice.areas {
        let laid = || lay(&plan.maps, plan.choice.system, coarse, seed, &pinned).inside;
        let GrownAreas { marks, laid, points } = areas::grown(document, plan, &form, laid)?;
        return Ok(Initial { concentrations: vec![marks], laid, points });
    }
    let laid = match (document.layers[plan.layer].after, beneath.last()) {
        (After::Inside, Some(outer)) => {
            let inside = inside(plan, outer);
            Places { pinned: inside.len(), inside, beyond: Vec::new() }
        }
        _ => lay(&plan.maps, plan.choice.system, coarse, seed, &pinned),
    };
    let own: Vec<Parameters> = pinned.iter().map(|spot| spot.own).collect();
    let places = vary(plan, laid, &own, seed);
    let concentrations = from_places(plan.choice.system, &plan.maps, &places, &|_| false);
    if places.is_empty() {
        Err(LayerError::NoRoom)
    } else {
        Ok(Initial { concentrations, laid: places.len(), points: None })
    }
}

/// The places of the spots beneath.
fn inside(plan: &BodyPlan, outer: &BodyLayer) -> Vec<SurfacePoint> {
    let (from, to) = (outer.plan.surface(), plan.surface());
    let carried =
        |place: SurfacePoint| to.closest_facing(from.position(place), from.normal(from.vertex_of(place)));
    outer.levelled.measured.spots.iter().map(|spot| carried(spot.place)).collect()
}

/// The drawn spots that are kept, at their places, with parameters of their own.
fn pinned(document: &Document, placed: &Placed, plan: &BodyPlan) -> Vec<PinnedSpot<SurfacePoint>> {
    let layer = &document.layers[plan.layer];
    let Some(limits) = plan.choice.system.definition().spots.filter(|_| keeps(document, plan.layer)) else {
        return Vec::new();
    };
    let pin = |(index, mark)| {
        let at = place_of(mark, plan.surface(), &placed.scale);
        let own = plan.own_parameters(index).unwrap_or_else(|| plan.maps.at(at));
        PinnedSpot { at, own, near: limits.merging.least }
    };
    ellipses(&layer.on_model).map(pin).collect()
}

/// Whether the marks that are drawn on the model are among those that grow.
#[must_use]
pub fn keeps(document: &Document, layer: usize) -> bool {
    let layer = &document.layers[layer];
    !layer.on_model.is_empty() && layer.options.keep.unwrap_or(true)
}

/// The paths that are drawn on the model for a layer and are among the marks that grow: points in the coordinates of the file.
pub fn kept_paths(document: &Document, layer: usize) -> impl Iterator<Item = &Vec<[f64; 3]>> {
    let marks = document.layers[layer].on_model.iter().filter(move |_| keeps(document, layer));
    marks.filter_map(|mark| match mark {
        BodyMark::Path { points, .. } => Some(points),
        BodyMark::Ellipse(_) => None,
    })
}

fn stripes(document: &Document, placed: &Placed, plan: &mut BodyPlan) -> Result<Vec<Vec<f32>>, LayerError> {
    let layer = &document.layers[plan.layer];
    let system = plan.choice.system;
    let paths = kept_paths(document, plan.layer);
    let values = if let Some(curves) = &plan.curves {
        Some(curves.phases(system, &plan.maps))
    } else if layer.options.seeding == Seeding::Initiators {
        let surface = plan.surface();
        let places: Vec<SurfacePoint> = paths
            .flat_map(|points| pieces(points, surface, placed, surface.unit()))
            .map(|piece| piece.middle)
            .collect();
        let away: Vec<f64> =
            distances(surface, &places).into_iter().map(|distance| distance / surface.unit()).collect();
        Some(waves_from(&plan.maps, &|p| system.spacing(p), &away))
    } else {
        let guides = paths.flat_map(|points| guides(points, placed, plan)).collect::<Vec<_>>();
        let seed = document.layer_seed(plan.layer);
        let waves = |plan: &BodyPlan| initial_waves(system, &plan.maps, seed, &guides);
        let values = waves(plan);
        match values.as_ref().and_then(|values| longer(plan, values)) {
            Some(by) => {
                plan.maps.parameters.iter_mut().for_each(|p| p.pitch *= by as f32);
                waves(plan)
            }
            None => values,
        }
    };
    let concentrations = values.and_then(|values| from_wave_values(system, &plan.maps, &values));
    concentrations.ok_or(LayerError::NoRoom)
}

/// By how much the lines must begin farther apart so that the distance between them is the one that is wanted; `None` for stripes whose
/// distance follows from their width. Where waves meet more crests begin than their length says, by some per cent.
fn longer(plan: &BodyPlan, phases: &[f32]) -> Option<f64> {
    if !plan.choice.system.description().free_spacing {
        return None;
    }
    let cosines: Vec<f32> = phases.iter().map(|phase| libm::cosf(*phase)).collect();
    let surface = plan.surface();
    let found = surface_stripes(surface, &cosines, 0.0, 1, &|_| 0).first()?.wavelength()?;
    let crests = |(vertex, wanted): (usize, &Attributes)| {
        surface.cell_area(vertex) / wanted.distance().unwrap_or(found)
    };
    let expected: f64 = plan.wanted.iter().enumerate().map(crests).sum();
    Some((surface.mesh.area() / expected / found).clamp(0.8, 1.25))
}

/// Pieces of a path about half a wavelength long.
fn guides(points: &[[f64; 3]], placed: &Placed, plan: &BodyPlan) -> Vec<GuideSegment<SurfacePoint>> {
    let surface = plan.surface();
    let first = surface.vertex_of(surface.closest(placed.scale.to_px(points[0])));
    let wavelength = plan.choice.system.spacing(&plan.maps.parameters[first]) * surface.unit();
    let guide = |piece: Piece| GuideSegment {
        middle: piece.middle,
        degrees: piece.degrees,
        half: 0.5 * piece.length / surface.unit(),
    };
    pieces(points, surface, placed, 0.5 * wavelength).into_iter().map(guide).collect()
}
