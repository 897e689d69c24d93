//! Attributes wanted on a parametric surface → attributes on the flat canvas.

use std::f64::consts::TAU;

use crate::attributes::AttributeMap;
use crate::attributes::metric_field::{Metric, MetricField};
use crate::attributes::regions::RegionGrid;
use crate::document::{Document, DocumentError, ParametricSurface, Problem, Relief};
use crate::grid::Edges;
use crate::synth::drawn::maps::nodes;

/// Nodes along the longer side: finer relief is averaged.
const NODES: usize = 128;

/// The `map` of a canvas of `size` px, changed so that the marks on the parametric surface of the document get the attributes;
/// unchanged for a document without such a surface.
///
/// # Errors
/// The surface is not known, or the canvas does not fit it.
pub fn on_surface(
    document: &Document,
    source: &str,
    size: [f64; 2],
    map: AttributeMap,
) -> Result<AttributeMap, DocumentError> {
    match &document.parametric {
        Some(surface) => {
            let metric = metric(surface, nodes(document.edges, size, NODES));
            metric.map(|metric| map.on_surface(metric)).map_err(|problem| problem.in_file(source))
        }
        None => Ok(map),
    }
}

/// The metric of a surface at these nodes, or fewer where its heights have fewer px.
///
/// # Errors
/// The heights are not known, or a canvas that is no torus.
pub fn metric(surface: &ParametricSurface, nodes: RegionGrid) -> Result<MetricField, Problem> {
    match surface {
        ParametricSurface::Heights(relief) => of_heights(relief, nodes),
        ParametricSurface::Torus => of_torus(nodes),
    }
}

fn of_heights(relief: &Relief, nodes: RegionGrid) -> Result<MetricField, Problem> {
    let heights = relief.heights()?.averaged(nodes.grid);
    let layout = RegionGrid { grid: heights.size(), ..nodes };
    let slope = |center: [f64; 2]| {
        let rise = heights.rise(layout.region_of(center), layout.edges);
        [0, 1].map(|axis| relief.scale * rise[axis] * layout.grid[axis] as f64 / layout.size[axis])
    };
    Ok(MetricField::new(layout, |center| Metric::of_slopes(slope(center))))
}

/// The ring has the circumference W, the tube H: the distance from the axis is W ÷ 2π + H ÷ 2π · cos v at the angle v = 2πy ÷ H.
fn of_torus(nodes: RegionGrid) -> Result<MetricField, Problem> {
    let [width, height] = nodes.size;
    if nodes.edges != Edges::Wrap || width <= height {
        let edges = if nodes.edges == Edges::Wrap { "" } else { ", whose edges are closed" };
        let found = format!("a torus on a canvas of {width} × {height} px{edges}");
        return Err(Problem::new(
            "model.surface",
            found,
            "a canvas that is wider than high, with \"edges\": \"wrap\"",
        ));
    }
    let at = |[_, y]: [f64; 2]| {
        let longer = 1.0 + height / width * libm::cos(TAU * y / height);
        Metric { xx: longer * longer, xy: 0.0, yy: 1.0 }
    };
    Ok(MetricField::new(nodes, at))
}

/// Refuses a layer that does not grow on a parametric surface.
///
/// # Errors
/// Its place, what it is, and what grows.
pub fn check(document: &Document, index: usize, grows_marks: bool) -> Result<(), Problem> {
    let Some(surface) = &document.parametric else { return Ok(()) };
    let on = surface.name();
    let layer = &document.layers[index];
    let refused = |key: &str, found: &str, allowed: &str| {
        Err(Problem::new(format!("layers[{index}].{key}"), format!("{found} on {on}"), allowed))
    };
    const MARKS: &str = "spots or stripes; others do not grow by a metric yet";
    if layer.tone.is_some() {
        refused("tone", "a tone", MARKS)
    } else if !grows_marks {
        refused("system", &format!("{:?}", layer.system.name()), MARKS)
    } else if index > 0 && !layer.after.keeps_away() {
        let allowed = "between: what follows the marks beneath is not corrected by the metric yet";
        refused("after", &format!("{:?}", layer.after.name()), allowed)
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::HeightField;
    use std::sync::Arc;

    const NODES: RegionGrid = RegionGrid { size: [400.0, 200.0], grid: [64, 32], edges: Edges::Wrap };

    #[test]
    fn slopes_are_px_of_height_a_px_of_the_canvas_whatever_the_size_of_the_picture() {
        for side in [16, 64, 200] {
            // From black to white along x: 0.5 px of height per px over 400 px.
            let value = |i: usize| (i % side) as f32 / (side - 1) as f32;
            let heights = HeightField::new([side, side], (0..side * side).map(value).collect());
            let heights = heights.map(Arc::new).ok_or_else(String::new);
            let relief = Relief { path: String::new(), scale: 200.0, heights };
            let nodes = RegionGrid { edges: Edges::Closed, ..NODES };
            let metric =
                metric(&ParametricSurface::Heights(relief), nodes).expect("heights").at([200.0, 100.0]);
            let slope = 0.5 * side as f64 / (side - 1) as f64;
            assert!(
                (metric.xx - 1.0 - slope * slope).abs() < 1e-4 && (metric.yy - 1.0).abs() < 1e-6,
                "{side}: {metric:?}"
            );
        }
    }

    #[test]
    fn a_torus_is_longer_outside_than_inside_and_as_long_as_the_canvas_between() {
        let metric = metric(&ParametricSurface::Torus, NODES).expect("it wraps");
        let longer = |y: f64| metric.at([10.0, y]).xx.sqrt();
        assert!((longer(0.0) - 1.5).abs() < 0.01 && (longer(100.0) - 0.5).abs() < 0.01);
        assert!((longer(50.0) - 1.0).abs() < 1e-2);
        assert!(
            super::metric(&ParametricSurface::Torus, RegionGrid { edges: Edges::Closed, ..NODES }).is_err()
        );
    }
}
