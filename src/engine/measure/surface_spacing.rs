//! Spacing on a triangle surface: the weighted mean length of the edges between neighbours, defined as in the plane
//! ([`crate::attributes::spacing`]).
//!
//! Each point has its neighbours in its tangent plane, with the Delaunay edges there. The weight of an edge is the mean over its
//! two ends. On a flat surface these are the edges of the plane.

use rayon::prelude::*;

use crate::attributes::spacing::{Edge, edges, median, nearest};
use crate::surface::{LocalMap, Surface, SurfacePoint};

/// An edge between two neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceEdge {
    /// Indices of the points that it joins, the lower first.
    pub ends: [usize; 2],
    /// Its length along the surface.
    pub length: f64,
    /// The place halfway.
    pub midpoint: SurfacePoint,
    /// Cosine of the larger of the angles opposite to it: the mean over the tangent planes of both ends, 0 for an end without the
    /// edge.
    pub cos_opposite: f64,
}

impl SurfaceEdge {
    /// Its weight, 0..1, if the usual distance of points to their nearest is `nearest`; see [`Edge::weight`].
    #[must_use]
    pub fn weight(&self, nearest: f64) -> f64 {
        self.in_plane().weight(nearest)
    }

    /// The corresponding edge in the plane, without a place.
    fn in_plane(&self) -> Edge {
        let Self { ends, length, cos_opposite, .. } = *self;
        Edge { ends, length, midpoint: [0.0; 2], hull: false, cos_opposite }
    }
}

/// Range of the search for neighbours, in distances of a hexagonal lattice with as many points: an edge with a weight above 0 is up
/// to 3.5 distances to the nearest long, and its empty circle up to 1.02 times as wide.
const REACH: f64 = 4.3;

/// The edges between neighbours among these places, each once, in the order of their ends.
#[must_use]
pub fn surface_edges(surface: &Surface, places: &[SurfacePoint]) -> Vec<SurfaceEdge> {
    let mut by_cell: Vec<(usize, usize)> =
        places.iter().enumerate().map(|(index, place)| (surface.vertex_of(*place), index)).collect();
    by_cell.sort_unstable();
    let lattice = (2.0 / 3.0f64.sqrt() * surface.mesh.area() / places.len().max(1) as f64).sqrt();
    let seen: Vec<Vec<SurfaceEdge>> = (0..places.len())
        .into_par_iter()
        .map(|own| edges_at(surface, places, &by_cell, own, REACH * lattice))
        .collect();
    let mut all: Vec<SurfaceEdge> = seen.into_iter().flatten().collect();
    all.sort_by_key(|edge| edge.ends);
    let one = |pair: &[SurfaceEdge]| {
        let share = 1.0 / pair.len() as f64;
        let length = share * pair.iter().map(|edge| edge.length).sum::<f64>();
        let cos_opposite = 0.5 * pair.iter().map(|edge| edge.cos_opposite).sum::<f64>();
        SurfaceEdge { length, cos_opposite, ..pair[0] }
    };
    all.chunk_by(|a, b| a.ends == b.ends).map(one).collect()
}

/// The edges of one of the points in its tangent plane.
fn edges_at(
    surface: &Surface,
    places: &[SurfacePoint],
    by_cell: &[(usize, usize)],
    own: usize,
    reach: f64,
) -> Vec<SurfaceEdge> {
    let map = LocalMap::new(surface, places[own], reach, |_| false);
    let (mut indices, mut at) = (vec![own], vec![[0.0; 2]]);
    for (vertex, _) in map.vertices() {
        let first = by_cell.partition_point(|(cell, _)| *cell < vertex);
        let here = by_cell[first..].iter().take_while(|(cell, _)| *cell == vertex);
        for (_, other) in here.filter(|(_, other)| *other != own) {
            if let Some(displacement) = map.displacement(surface, places[*other]) {
                indices.push(*other);
                at.push(displacement);
            }
        }
    }
    let joined = |edge: &Edge| {
        let [first, other] = edge.ends;
        (first == 0).then(|| {
            let (index, displacement) = (indices[other], at[other]);
            SurfaceEdge {
                ends: [own.min(index), own.max(index)],
                length: edge.length,
                midpoint: surface.walk(places[own], displacement.map(|part| 0.5 * part)),
                cos_opposite: edge.cos_opposite,
            }
        })
    };
    edges(&at, None).iter().filter_map(joined).collect()
}

/// The edges whose weighted mean is the spacing of places, with their weights: s is the median of the distances to the nearest.
#[must_use]
pub fn surface_neighbours(surface: &Surface, places: &[SurfacePoint]) -> Vec<(SurfaceEdge, f64)> {
    let all = surface_edges(surface, places);
    let plane: Vec<Edge> = all.iter().map(SurfaceEdge::in_plane).collect();
    let Some(distance) = median(nearest(&plane, places.len())) else { return Vec::new() };
    let weighted = all.into_iter().map(|edge| (edge, edge.weight(distance)));
    weighted.filter(|(_, weight)| *weight > 0.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::spacing::{WeightedEdge, mean_length, mean_spacing, neighbours};
    use crate::surface::test_meshes::{cylinder, even_plate, sphere};
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Mean distance between neighbours; `None` for fewer than two.
    fn surface_spacing(surface: &Surface, places: &[SurfacePoint]) -> Option<f64> {
        let weighted = surface_neighbours(surface, places).into_iter();
        let edges: Vec<WeightedEdge> = weighted
            .map(|(SurfaceEdge { ends, length, .. }, weight)| WeightedEdge {
                ends,
                length,
                midpoint: [0.0; 2],
                weight,
            })
            .collect();
        mean_length(&edges)
    }

    /// A jittered hexagonal lattice.
    fn lattice(size: [f64; 2], step: f64, rng: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
        let (rows, columns) = ((size[1] / (0.866 * step)) as usize, (size[0] / step) as usize);
        let mut points = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let off = if row % 2 == 1 { 0.75 } else { 0.25 };
                let jitter = [0; 2].map(|_| 0.5 * (rng.random::<f64>() - 0.5));
                let at = [column as f64 + off + jitter[0], 0.866 * (row as f64 + 0.5 + jitter[1])];
                points.push(at.map(|at| (at * step).clamp(0.0, f64::MAX)));
            }
        }
        points
    }

    #[test]
    fn on_a_flat_surface_edges_weights_and_spacing_are_those_of_the_plane() {
        let surface = Surface::new(even_plate([60.0, 50.0], 1.0), [1.0, 0.0, 0.0]);
        for seed in 0..3 {
            let points = lattice([60.0, 50.0], 6.0, &mut Pcg64Mcg::seed_from_u64(seed));
            let places: Vec<SurfacePoint> =
                points.iter().map(|[x, y]| surface.closest([*x, *y, 0.0])).collect();
            let (flat, found) = (neighbours(&points, None), surface_neighbours(&surface, &places));
            assert_eq!(flat.len(), found.len());
            for (flat, (edge, weight)) in flat.iter().zip(&found) {
                assert_eq!(flat.ends, edge.ends);
                assert!((flat.length - edge.length).abs() < 1e-9 && (flat.weight - weight).abs() < 1e-9);
                let [x, y, _] = surface.position(edge.midpoint);
                assert!((flat.midpoint[0] - x).abs() < 1e-6 && (flat.midpoint[1] - y).abs() < 1e-6);
            }
            let [flat, found] = [mean_spacing(&points), surface_spacing(&surface, &places)];
            assert!((flat.expect("some") - found.expect("some")).abs() < 1e-9);
        }
    }

    #[test]
    fn few_marks_have_the_spacing_that_they_have_in_the_plane() {
        let surface = Surface::new(even_plate([60.0, 50.0], 1.0), [1.0, 0.0, 0.0]);
        let spacing = |points: &[[f64; 2]]| {
            let places: Vec<_> = points.iter().map(|[x, y]| surface.closest([*x, *y, 0.0])).collect();
            surface_spacing(&surface, &places)
        };
        assert_eq!((spacing(&[]), spacing(&[[5.0, 5.0]])), (None, None));
        let row = [[5.0, 20.0], [15.0, 20.0], [26.0, 20.0], [35.0, 20.0]];
        assert!((spacing(&row[..2]).expect("two") - 10.0).abs() < 1e-9);
        assert!((spacing(&row).expect("a row") - 10.0).abs() < 1e-6);
    }

    #[test]
    fn spacing_is_read_along_the_surface() {
        // Columns and rows of a tube, every second row shifted by half a step.
        let surface = Surface::new(cylinder([80, 60], 8.0, 40.0), [0.0, 0.0, 1.0]);
        let cells = (0..6).flat_map(|row| (0..8).map(move |k| (5 + 9 * row) * 80 + 10 * k + 5 * (row % 2)));
        let places: Vec<SurfacePoint> = cells.map(|cell| surface.place_of(cell)).collect();
        let across = 16.0 * 80.0 / 8.0 * libm::sin(std::f64::consts::PI / 80.0);
        let up = 9.0 * 40.0 / 60.0;
        let slanted = (0.25 * across * across + up * up).sqrt();
        let found = surface_neighbours(&surface, &places);
        assert!(found.iter().all(|(edge, weight)| {
            let is_known = (edge.length - across).abs() < 1e-6 || (edge.length - slanted).abs() < 1e-6;
            is_known && *weight > 0.99
        }));
        assert_eq!(found.len(), 6 * 8 + 5 * 16);
        // The corners of an icosahedron.
        let surface = Surface::new(sphere(20, 10.0), [1.0, 0.0, 0.0]);
        let places: Vec<SurfacePoint> = (0..12).map(|k| surface.closest(icosahedron(k))).collect();
        let far = 10.0 * 63.434_948_8f64.to_radians();
        let spacing = surface_spacing(&surface, &places).expect("twelve");
        assert!((spacing / far - 1.0).abs() < 0.01, "{spacing} {far}");
        assert_eq!(surface_neighbours(&surface, &places).len(), 30);
    }

    fn icosahedron(k: usize) -> [f64; 3] {
        sphere(1, 10.0).positions[k]
    }
}
