//! Values at points of a surface → values at its vertices, by the weights of [`crate::points::interpolation`], equations 1 to 3, in the
//! tangent plane of each point.

use rayon::prelude::*;

use super::graph::SurfaceGraph;
use crate::grid::Domain;
use crate::points::graph::PointGraph;
use crate::points::interpolation::shifted;

/// The support of a point reaches no farther than this many of its longest edges for axes of length 1: to the corners of its cell, twice.
/// A corner of a triangle without obtuse angles is at most 1 ÷ √3 of its longest side from its circumcentre.
const SUPPORT: f64 = 1.2;

/// How the values of points become those of vertices.
#[derive(Clone, Copy, Debug, Default)]
pub struct Weighing<'a> {
    /// L, the length of the axes, edges.
    pub length: f64,
    /// ε of equation 4 and the unit vectors, one a point in its frame, by which weights are shifted; `None` = not at all.
    pub shift: Option<(f64, &'a [[f64; 2]])>,
    /// Whether each vertex takes the value of the point with the highest weight.
    pub nearest: bool,
}

impl Weighing<'_> {
    /// Means of the values, with axes of this length.
    #[must_use]
    pub fn smooth(length: f64) -> Self {
        Self { length, ..Self::default() }
    }
}

/// The values between those of the points of `graph`, by vertex.
#[must_use]
pub fn interpolate(graph: &SurfaceGraph, values: &[f32], weighing: &Weighing) -> Vec<f32> {
    let vertices = graph.surface().cells();
    let all: Vec<Vec<(u32, f32)>> =
        (0..graph.count()).into_par_iter().map(|point| weights(graph, point, weighing)).collect();
    // In the order of the points, so that sums do not depend on the number of threads.
    let (mut sums, mut totals) = (vec![0.0f32; vertices], vec![0.0f32; vertices]);
    for (near, value) in all.iter().zip(values) {
        for (vertex, weight) in near {
            let (sum, total) = (&mut sums[*vertex as usize], &mut totals[*vertex as usize]);
            if !weighing.nearest {
                *sum += weight * value;
                *total += weight;
            } else if weight > total {
                (*sum, *total) = (weight * value, *weight);
            }
        }
    }
    sums.into_iter().zip(totals).map(|(sum, total)| if total > 0.0 { sum / total } else { 0.0 }).collect()
}

/// The weights of a point at the vertices in its support.
fn weights(graph: &SurfaceGraph, point: usize, Weighing { length, shift, .. }: &Weighing) -> Vec<(u32, f32)> {
    let surface = graph.surface();
    let axes = graph.axes(point);
    let slopes: Vec<[f64; 2]> = axes.iter().map(|axis| slope(axis.displacement, *length)).collect();
    let longest = axes.iter().map(|axis| norm(axis.displacement)).fold(0.0, f64::max);
    let reach = SUPPORT * length * longest / surface.unit();
    let near = surface.near(graph.places[point], reach, 0..surface.cells());
    near.filter_map(|(vertex, away)| {
        let away = away.map(|part| part * surface.unit());
        let own = weight(&slopes, away) as f32;
        let turned = shift.map_or(own, |(strength, directions)| {
            shifted(own, strength, directions.get(point).copied().unwrap_or_default(), away)
        });
        (turned > 0.0).then_some((vertex as u32, turned))
    })
    .collect()
}

fn norm([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// α ÷ (L·|α|²) of an axis α.
fn slope(axis: [f64; 2], length: f64) -> [f64; 2] {
    let square = axis[0] * axis[0] + axis[1] * axis[1];
    axis.map(|part| part / (length * square))
}

/// W of equation 2 at a displacement from the point.
fn weight(slopes: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    slopes.iter().fold(1.0, |product, slope| {
        let p = (slope[0] * x + slope[1] * y).clamp(0.0, 1.0);
        let rest = 1.0 - p;
        product * rest * rest * (1.0 + 2.0 * p)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Surface;
    use crate::surface::test_meshes::sphere;
    use crate::synth::body::areas::discs::poisson_discs;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn it_has_the_values_of_the_points_and_reaches_all_vertices() {
        let surface = Surface::new(sphere(44, 40.0), [1.0, 0.0, 0.0]);
        let places = poisson_discs(&surface, &|_| 6.0, &[], &mut Pcg64Mcg::seed_from_u64(2));
        let graph = SurfaceGraph::new(&surface, places, &|_| 12.0);
        let heights: Vec<f32> = graph.places.iter().map(|place| surface.position(*place)[1] as f32).collect();
        let field = interpolate(&graph, &heights, &Weighing::smooth(1.0));
        for (place, height) in graph.places.iter().zip(&heights) {
            assert!((field[surface.vertex_of(*place)] - height).abs() < 0.3);
        }
        let off =
            |(vertex, value): (usize, &f32)| (f64::from(*value) - surface.mesh.positions[vertex][1]).abs();
        let largest = field.iter().enumerate().map(off).fold(0.0, f64::max);
        assert!(largest < 5.0, "{largest}");
        let ones = interpolate(&graph, &vec![1.0; heights.len()], &Weighing::smooth(1.2));
        assert!(ones.iter().all(|value| (value - 1.0).abs() < 1e-5));
    }
}
