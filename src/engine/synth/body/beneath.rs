//! What the layers beneath leave free on a surface.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::document::Document;
use crate::export::body::Smooth;
use crate::grid::Domain;
use crate::surface::Surface;
use crate::synth::body::choice::Choice;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::plan::BodyPlan;
use crate::synth::drawn::is_replaced;
use crate::synth::marks::plan::obstacle_mask::with_rim;
use crate::synth::pattern::EDGE;

/// The layers beneath that cover something: those that another one replaces do not.
pub fn covering<'a>(document: &'a Document, layers: &'a [BodyLayer]) -> impl Iterator<Item = &'a BodyLayer> {
    layers.iter().filter(|layer| !is_replaced(document, layer.plan.layer))
}

/// The pattern of a layer at each vertex of another surface of the same model.
#[must_use]
pub fn carried(layer: &BodyLayer, surface: &Surface) -> Vec<f32> {
    let (own, pattern) = (layer.plan.surface(), &layer.levelled.pattern);
    let smooth = Smooth::new(&own.mesh, pattern);
    let at = |vertex: usize| {
        let place = own.closest_facing(surface.mesh.positions[vertex], surface.normal(vertex));
        smooth.at(place.face as usize, place.shares())
    };
    (0..surface.mesh.positions.len()).into_par_iter().map(at).collect()
}

/// The vertices whose cells the marks of the `layers` reach into; empty where there are no layers. Stripes keep clear of the cells
/// beside them as well.
#[must_use]
pub fn obstacles<'a>(
    layers: impl Iterator<Item = &'a BodyLayer>,
    surface: &Surface,
    choice: &Choice,
) -> Vec<bool> {
    let mut taken = Vec::new();
    for layer in layers {
        let pattern = carried(layer, surface);
        taken.resize(pattern.len(), false);
        taken.par_iter_mut().enumerate().for_each(|(vertex, taken)| {
            // At the borders of its cell, halfway to the vertices beside it.
            let reaches = |other: usize| 0.5 * (pattern[vertex] + pattern[other]) >= EDGE;
            *taken = *taken || pattern[vertex] >= EDGE || surface.ring(vertex).any(reaches);
        });
    }
    let keeps_clear = choice.system.is_striped() && choice.curves.is_none();
    if keeps_clear && !taken.is_empty() { with_rim(&taken, surface) } else { taken }
}

/// Raises the lines beside obstacles, where stripes are the gaps between lines: the ground round the marks beneath belongs to them. The
/// height of such a line is ½ as far from these as lines are wide.
pub fn raise_beside_obstacles(plan: &BodyPlan, marks: &mut [f32]) {
    let surface = plan.surface();
    if !plan.is_inverted() || plan.maps.obstacles.is_empty() {
        return;
    }
    let Some(away) = surface.distances(&plan.maps.obstacles) else { return };
    for ((mark, away), wanted) in marks.iter_mut().zip(away).zip(&plan.wanted) {
        if let Attributes::Stripes(lines) = plan.choice.polarity.lines(wanted) {
            let off = away * surface.unit() / lines.width;
            *mark = mark.max(libm::exp2(-off * off) as f32);
        }
    }
}
