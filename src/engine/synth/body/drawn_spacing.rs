//! The spacing of marks that are drawn on a model: the mean distance to their neighbours along its surface.

use crate::document::{Body, Document};
use crate::measure::surface_neighbours;
use crate::surface::SurfacePoint;
use crate::synth::body::anchors::{ellipses, place_of};
use crate::synth::body::needs;
use crate::synth::body::placed::Placed;
use crate::synth::body::remeshed::Remeshed;
use crate::synth::error::LayerError;
use crate::synth::options::Options;

/// The spacing of each mark of a layer on the model, px; `None` where no neighbour says it. Where marks are drawn on the canvas too, they say how far
/// apart spots are, and there is nothing here.
///
/// # Errors
/// The marks are too small for the model: memory or time.
pub fn drawn_spacing(
    document: &Document,
    layer: usize,
    body: &Body,
    placed: &Placed,
    options: &Options,
) -> Result<Vec<Option<f64>>, LayerError> {
    let layer = &document.layers[layer];
    let marks: Vec<_> = ellipses(&layer.on_model).map(|(_, mark)| mark).collect();
    if !layer.strokes.is_empty() || marks.len() < 2 {
        return Ok(Vec::new());
    }
    // Distances need no finer cells than the smallest mark.
    let smallest = marks.iter().map(|mark| mark.radii[0] * mark.radii[1]).fold(f64::INFINITY, f64::min);
    let cell = smallest.sqrt();
    needs::check(placed.mesh.area(), &[cell], None, options)?;
    let mut remeshed = Remeshed::begin(placed, cell);
    while remeshed.advance() {}
    let [_, surface] = remeshed.surfaces(body);
    let places: Vec<SurfacePoint> =
        marks.iter().map(|mark| place_of(mark, &surface, &placed.scale)).collect();
    let neighbours = surface_neighbours(&surface, &places);
    let mean = |is_counted: &dyn Fn(&[usize; 2]) -> bool| {
        let counted = neighbours.iter().filter(|(edge, _)| is_counted(&edge.ends));
        let [sum, weights] = counted
            .fold([0.0; 2], |[sum, weights], (edge, weight)| [sum + weight * edge.length, weights + weight]);
        (weights > 0.0).then(|| sum / weights)
    };
    let usual = mean(&|_| true);
    Ok((0..marks.len()).map(|own| mean(&|ends| ends.contains(&own)).or(usual)).collect())
}
