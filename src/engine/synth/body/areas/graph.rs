//! The Delaunay graph of points on a surface: points are neighbours where their Voronoi cells, made of vertices, meet.

use rayon::prelude::*;

use crate::grid::Domain;
use crate::points::delaunay::Axis;
use crate::points::graph::PointGraph;
use crate::surface::{Surface, SurfacePoint};

/// Points on a surface with their neighbours.
pub struct SurfaceGraph<'a> {
    surface: &'a Surface,
    /// The points.
    pub places: Vec<SurfacePoint>,
    /// The vertices of the points, in whose frames displacements are.
    vertices: Vec<usize>,
    /// By point, in order round it.
    axes: Vec<Vec<Axis>>,
    /// px² of the cell of each point.
    areas: Vec<f64>,
}

impl<'a> SurfaceGraph<'a> {
    /// The graph of points no farther from any vertex than `reach` px, one a point.
    #[must_use]
    pub fn new(surface: &'a Surface, places: Vec<SurfacePoint>, reach: &dyn Fn(usize) -> f64) -> Self {
        let reach: Vec<f64> = places.iter().map(|place| reach(surface.vertex_of(*place))).collect();
        let owner = owners(surface, &places, &reach);
        let mut areas = vec![0.0; places.len()];
        for (vertex, owner) in owner.iter().enumerate() {
            if let Some(area) = areas.get_mut(*owner as usize) {
                *area += surface.cell_area(vertex);
            }
        }
        let beside = meeting(surface, &owner, places.len());
        let unit = surface.unit();
        let of_point = |(point, beside): (usize, &Vec<u32>)| {
            let axis = |to: &u32| {
                let displacement = surface.displacement(places[point], places[*to as usize]);
                Axis { displacement: displacement.map(|part| part * unit), to: Some(*to), clearance: 0.0 }
            };
            let mut axes: Vec<Axis> = beside.iter().map(axis).collect();
            axes.retain(|axis| axis.displacement.iter().all(|part| part.is_finite()));
            axes.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
            with_clearances(axes)
        };
        let axes = beside.par_iter().enumerate().map(of_point).collect();
        let vertices = places.iter().map(|place| surface.vertex_of(*place)).collect();
        Self { surface, places, vertices, axes, areas }
    }

    /// The surface, px.
    #[must_use]
    pub fn surface(&self) -> &'a Surface {
        self.surface
    }

    /// The vertex of a point, in whose frame its displacements are.
    #[must_use]
    pub fn vertex(&self, point: usize) -> usize {
        self.vertices[point]
    }
}

/// No point is near.
const NOBODY: u32 = u32::MAX;

/// The point nearest to each vertex, the first of equally near ones.
fn owners(surface: &Surface, places: &[SurfacePoint], reach: &[f64]) -> Vec<u32> {
    let vertices = surface.cells();
    let near = |(place, reach): (&SurfacePoint, &f64)| -> Vec<(u32, f64)> {
        let near = surface.near(*place, reach / surface.unit(), 0..vertices);
        near.map(|(vertex, [x, y])| (vertex as u32, x * x + y * y)).collect()
    };
    let all: Vec<Vec<(u32, f64)>> = places.par_iter().zip(reach).map(near).collect();
    let (mut owner, mut least) = (vec![NOBODY; vertices], vec![f64::INFINITY; vertices]);
    for (point, near) in all.into_iter().enumerate() {
        for (vertex, square) in near {
            if square < least[vertex as usize] {
                (owner[vertex as usize], least[vertex as usize]) = (point as u32, square);
            }
        }
    }
    owner
}

/// For each point those whose cells share a side of the mesh with its cell, ascending.
fn meeting(surface: &Surface, owner: &[u32], points: usize) -> Vec<Vec<u32>> {
    let mut beside = vec![Vec::new(); points];
    for face in &surface.mesh.faces {
        for k in 0..3 {
            let [a, b] = [face[k], face[(k + 1) % 3]].map(|vertex| owner[vertex as usize]);
            if a != b && a != NOBODY && b != NOBODY {
                beside[a as usize].push(b);
                beside[b as usize].push(a);
            }
        }
    }
    for beside in &mut beside {
        beside.sort_unstable();
        beside.dedup();
    }
    beside
}

fn angle(axis: &Axis) -> f64 {
    libm::atan2(axis.displacement[1], axis.displacement[0])
}

/// The axes of one point, in order round it, with the smaller cotangent of the angles that the neighbours at both sides see.
fn with_clearances(mut axes: Vec<Axis>) -> Vec<Axis> {
    let count = axes.len();
    let seen_from = |corner: [f64; 2], end: [f64; 2]| {
        let [to_point, to_end] = [corner.map(|part| -part), [end[0] - corner[0], end[1] - corner[1]]];
        let dot = to_point[0] * to_end[0] + to_point[1] * to_end[1];
        let cross = to_point[0] * to_end[1] - to_point[1] * to_end[0];
        dot / cross.abs().max(f64::MIN_POSITIVE)
    };
    let clearance = |k: usize| {
        let beside = [axes[(k + 1) % count], axes[(k + count - 1) % count]];
        let seen = beside.map(|other| seen_from(other.displacement, axes[k].displacement));
        seen[0].min(seen[1])
    };
    let clearances: Vec<f64> = (0..count).map(clearance).collect();
    axes.iter_mut().zip(clearances).for_each(|(axis, clearance)| axis.clearance = clearance);
    axes
}

impl PointGraph for SurfaceGraph<'_> {
    fn count(&self) -> usize {
        self.places.len()
    }

    fn axes(&self, point: usize) -> &[Axis] {
        &self.axes[point]
    }

    fn area(&self, point: usize) -> f64 {
        self.areas[point]
    }

    fn opposite(&self, point: usize) -> impl Iterator<Item = (usize, f64)> {
        let axes = self.axes(point);
        (0..axes.len()).filter_map(move |k| {
            let (one, next) = (&axes[k], &axes[(k + 1) % axes.len()]);
            let ring = self.axes(one.to? as usize);
            let edge = ring.iter().position(|axis| axis.to == next.to)?;
            // In the order round the neighbour, this edge comes after the opposite point and before the point itself.
            let before = &ring[(edge + ring.len() - 1) % ring.len()];
            Some((before.to? as usize, ring[edge].clearance))
        })
    }

    fn onward(&self, from: usize, at: usize, [x, y]: [f64; 2], axis: &Axis) -> [f64; 2] {
        let turn = self.surface.transport_angle(self.vertices[at], self.vertices[from]);
        let (sin, cos) = libm::sincos(turn.to_radians());
        let [ahead, aside] = axis.displacement;
        [x + cos * ahead - sin * aside, y + sin * ahead + cos * aside]
    }

    fn way(&self, from: usize, to: usize) -> [f64; 2] {
        let unit = self.surface.unit();
        self.surface.displacement(self.places[from], self.places[to]).map(|part| part * unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::sphere;
    use crate::synth::body::areas::discs::poisson_discs;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn the_graph_of_points_on_a_sphere_is_a_triangulation_whose_cells_cover_it() {
        let surface = Surface::new(sphere(36, 30.0), [1.0, 0.0, 0.0]);
        let places = poisson_discs(&surface, &|_| 6.0, &[], &mut Pcg64Mcg::seed_from_u64(2));
        let graph = SurfaceGraph::new(&surface, places, &|_| 12.0);
        let edges: usize = (0..graph.count()).map(|point| graph.axes(point).len()).sum();
        // Euler: 2·(3n − 6) ends of edges; four points that lie nearly on one circle may lack one.
        let wanted = 2 * (3 * graph.count() - 6);
        assert!(edges.abs_diff(wanted) <= wanted / 20, "{edges} of {wanted}");
        let area: f64 = (0..graph.count()).map(|point| graph.area(point)).sum();
        assert!((area / surface.mesh.area() - 1.0).abs() < 1e-9, "{area}");
        for point in 0..graph.count() {
            let known = graph.opposite(point).filter(|(other, _)| *other != point).count();
            assert!(known + 1 >= graph.axes(point).len(), "{known} of {}", graph.axes(point).len());
        }
    }

    #[test]
    fn displacements_add_up_along_edges() {
        let surface = Surface::new(sphere(48, 60.0), [1.0, 0.0, 0.0]);
        let places = poisson_discs(&surface, &|_| 9.0, &[], &mut Pcg64Mcg::seed_from_u64(5));
        let graph = SurfaceGraph::new(&surface, places, &|_| 18.0);
        for from in (0..graph.count()).step_by(7) {
            for first in graph.axes(from) {
                let at = first.to.expect("no guards") as usize;
                for axis in graph.axes(at) {
                    let to = axis.to.expect("no guards") as usize;
                    let there = graph.onward(from, at, first.displacement, axis);
                    let straight = surface
                        .displacement(graph.places[from], graph.places[to])
                        .map(|part| part * surface.unit());
                    let off = libm::hypot(there[0] - straight[0], there[1] - straight[1]);
                    assert!(off < 1.0, "{from} {at} {to}: {there:?} {straight:?}");
                }
            }
        }
    }
}
