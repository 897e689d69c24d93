//! Targets from the sketch: the strokes of a layer → its marks → the region map of wanted attributes.

use crate::attributes::AttributeMap;
use crate::document::layer_rules::{Beneath, Combination, mixed_marks};
use crate::document::{
    After, Document, DocumentError, Kind, LayerOptions, MapKey, Problem, SpreadChoice, Stroke, tile,
};
use crate::grid::{Bounds, Edges};
use crate::marks::Mark;

/// The marks of layer `index`, with freehand strokes fitted. On a tile, marks whose centre is beyond the border are moved to the
/// other side.
///
/// # Errors
/// A stroke that is neither ellipse nor line, ellipses and lines in one layer of other than cells, or a seamless canvas that is too
/// narrow: file (`source`), place, value.
pub fn marks(document: &Document, index: usize, source: &str) -> Result<Vec<Mark>, DocumentError> {
    let layer = &document.layers[index];
    let mut marks = Vec::with_capacity(layer.strokes.len());
    let mut first: Option<Kind> = None;
    let canvas = Bounds { size: document.size.map(f64::from), edges: document.edges };
    tile::check(canvas.size, canvas.edges).map_err(|problem| problem.in_file(source))?;
    for (i, stroke) in layer.strokes.iter().enumerate() {
        let place = format!("layers[{index}].strokes[{i}]");
        let mark = stroke.mark().ok_or_else(|| {
            let points = if let Stroke::Freehand { points, .. } = stroke { points.len() } else { 0 };
            let found = format!("{points} points that make neither an ellipse nor a line");
            Problem::new(&place, found, "a closed stroke round a spot, or an open one along a stripe")
                .in_file(source)
        })?;
        let kind = Kind::from(&mark);
        if let Some(problem) = mixed_marks(layer.system, kind, *first.get_or_insert(kind), &place) {
            return Err(problem.in_file(source));
        }
        marks.push(mark.on_tile(&canvas));
    }
    // Freehand strokes have a kind only after they have been fitted.
    let kind = Kind::of_layer(marks.iter().map(Kind::from));
    let combination = Combination::new(layer, kind, Beneath::Unknown);
    match combination.problem_on_reading(&format!("layers[{index}]")) {
        Some(problem) => Err(problem.in_file(source)),
        None => Ok(marks),
    }
}

/// The region map of layer `index` on the document's own canvas, with the spread and the duty of its options. Lines beside ellipses
/// are ignored.
///
/// # Errors
/// Those of [`marks`].
pub fn region_map(document: &Document, index: usize, source: &str) -> Result<AttributeMap, DocumentError> {
    let mut marks = marks(document, index, source)?;
    let kind = Kind::of_layer(marks.iter().map(Kind::from));
    marks.retain(|mark| Some(Kind::from(mark)) == kind);
    let size = document.size.map(f64::from);
    let regions = document.regions.map(|regions| regions.map(|n| n as usize));
    let far_before = document.layers[index].far_spacing;
    let map = AttributeMap::after_change(&marks, size, regions, document.edges, far_before);
    let map = map.map_err(|error| {
        let place = format!("layers[{index}].strokes");
        Problem::new(place, error.to_string(), "at least one ellipse, or at least one line").in_file(source)
    })?;
    let layer = &document.layers[index];
    let map = match layer.options.spread {
        SpreadChoice::Drawn => map,
        SpreadChoice::Given(spread) => map.with_spread(spread),
    };
    let any_wavelength = layer.system.is_known(|system| system.is_striped() && system.free_spacing);
    let natural_wavelength = layer.system.is_known(|system| system.is_striped() && !system.free_spacing);
    // For lines along curves only the width is used.
    let along_curves = matches!(layer.after, After::Around | After::Net) && !map.is_free();
    let given = layer.options.duty.given().or(along_curves.then_some(LayerOptions::DUTY));
    // If a map varies the duty of stripes, they have a period, whatever is drawn.
    let varied = layer.maps.get(MapKey::Duty).is_some();
    let map = if let Some(duty) = given { map.with_duty(duty) } else { map };
    let usual = match given {
        // With regions, a given duty is used exactly.
        Some(duty) if !map.is_free() => duty == LayerOptions::DUTY,
        _ => map.has_usual_duty(),
    };
    let natural = natural_wavelength || !any_wavelength && !varied && usual;
    Ok(if natural { map.with_free_wavelength() } else { map })
}

/// The marks of layer `index` on a canvas of `size` px: their places stretch with the canvas, their sizes do not. A centre beyond
/// the border keeps its distance from it, so that the part of the mark on the canvas remains.
///
/// # Errors
/// Those of [`marks`].
pub fn marks_on(
    document: &Document,
    index: usize,
    source: &str,
    size: [f64; 2],
) -> Result<Vec<Mark>, DocumentError> {
    let [x, y] = [0, 1].map(|axis| size[axis] / f64::from(document.size[axis]));
    // On a tile the marks have been moved inside already, and its far border is not the near one on this canvas.
    let own = Bounds { size: document.size.map(f64::from), edges: Edges::Closed };
    let moved = |mark: Mark| {
        let [from_x, from_y] = own.inside(mark.center());
        mark.shifted([(x - 1.0) * from_x, (y - 1.0) * from_y])
    };
    Ok(marks(document, index, source)?.into_iter().map(moved).collect())
}

#[cfg(test)]
mod tests;
