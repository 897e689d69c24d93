//! Cells on a surface: each place belongs to the nearest of the points that were laid, in the metric of the cell there, and lines of one
//! width part them.

use rayon::prelude::*;

use crate::grid::Domain;
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::area_form::SOFT;
use crate::synth::body::plan::BodyPlan;

/// How far a cell is looked at from its point, in distances of the points: the points beside it lie within.
const REACH: f64 = 1.6;
/// The radius of corners, in widths of the lines. Lines of the reaction on canvases have about these.
const ROUND: f64 = 0.35;

/// How much of a cell each vertex shows, 0..1, ½ at its edge. Lines of `gap` px part the cells around these `centers`.
#[must_use]
pub fn grown(plan: &BodyPlan, gap: f64, centers: &[SurfacePoint]) -> Vec<f32> {
    let surface = plan.surface();
    let near = near_points(plan, centers);
    let away = if plan.maps.obstacles.is_empty() { None } else { surface.distances(&plan.maps.obstacles) };
    let at = |vertex: usize| {
        if plan.maps.is_obstacle(vertex) || near[vertex].is_empty() {
            return 0.0;
        }
        let obstacle = away.iter().map(|away| away[vertex] * surface.unit() - 0.5 * gap);
        let depths = depths(surface, &near, vertex).into_iter().chain(obstacle);
        // The smooth minimum: corners become round.
        let round = ROUND * gap;
        let sum: f64 = depths.map(|depth| libm::exp(-depth / round)).sum();
        let depth = -round * libm::log(sum.max(f64::MIN_POSITIVE)) - 0.5 * gap;
        (1.0 / (1.0 + libm::exp(-depth / (SOFT * gap)))) as f32
    };
    (0..surface.cells()).into_par_iter().map(at).collect()
}

/// For each vertex the points near to it, each with the square of its distance in the metric of its cell, px²; in the order of the points.
fn near_points(plan: &BodyPlan, centers: &[SurfacePoint]) -> Vec<Vec<(u32, f64)>> {
    let surface = plan.surface();
    let unit = surface.unit();
    let near = |center: &SurfacePoint| -> Vec<(u32, f64)> {
        let p = plan.maps.at(*center);
        let (stretch, spacing) = (f64::from(p.stretch), plan.choice.system.spacing(&p));
        let (sin, cos) = libm::sincos(f64::from(p.direction).to_radians());
        let reach = REACH * spacing / stretch.sqrt();
        let found = surface.near(*center, reach, 0..surface.cells());
        let square = |[x, y]: [f64; 2]| {
            let (along, across) = (unit * (cos * x + sin * y), unit * (cos * y - sin * x));
            stretch * along * along + across * across / stretch
        };
        found.map(|(vertex, away)| (vertex as u32, square(away))).collect()
    };
    let all: Vec<Vec<(u32, f64)>> = centers.par_iter().map(near).collect();
    let mut by_vertex = vec![Vec::new(); surface.cells()];
    for (center, near) in all.into_iter().enumerate() {
        for (vertex, square) in near {
            by_vertex[vertex as usize].push((center as u32, square));
        }
    }
    by_vertex
}

/// The distances, px, from a vertex to the borders between the cell that it lies in and those of other points near to it: with f = (dⱼ² − dᵢ²)/2,
/// which is 0 on the border, f ÷ |∇f|.
fn depths(surface: &Surface, near: &[Vec<(u32, f64)>], vertex: usize) -> Vec<f64> {
    let own = &near[vertex];
    let Some(first) = own.iter().copied().reduce(|a, b| if b.1 < a.1 { b } else { a }) else {
        return Vec::new();
    };
    let square = |vertex: usize, point: u32| {
        near[vertex].iter().find(|(of, _)| *of == point).map(|(_, square)| *square)
    };
    let depth = |(point, there): &(u32, f64)| {
        let f = 0.5 * (there - first.1);
        // Least squares over the ring.
        let [mut xx, mut xy, mut yy, mut fx, mut fy] = [0.0; 5];
        for (other, [x, y]) in surface.tangent_ring(vertex) {
            let Some((a, b)) = square(other, first.0).zip(square(other, *point)) else { continue };
            let rise = 0.5 * (b - a) - f;
            xx += x * x;
            xy += x * y;
            yy += y * y;
            fx += x * rise;
            fy += y * rise;
        }
        let determinant = xx * yy - xy * xy;
        let gradient = [yy * fx - xy * fy, xx * fy - xy * fx].map(|part| part / determinant);
        let slope = (gradient[0] * gradient[0] + gradient[1] * gradient[1]).sqrt();
        (determinant > 0.0 && slope > 0.0).then(|| f / slope)
    };
    own.iter().filter(|(point, _)| *point != first.0).filter_map(depth).collect()
}
