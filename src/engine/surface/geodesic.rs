//! Distances along a surface.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::local_map::LocalMap;
use super::point::SurfacePoint;
use super::tangent::Spoke;
use super::triangle_surface::Surface;

/// Radius about a source within which distances are taken from its tangent plane, in units.
const NEAR: f64 = 2.0;

/// Distance of each vertex to the nearest of these places; infinite on parts without any.
#[must_use]
pub fn distances(surface: &Surface, from: &[SurfacePoint]) -> Vec<f64> {
    let near = |place: &SurfacePoint| {
        let map = LocalMap::new(surface, *place, NEAR * surface.unit(), |_| false);
        let found = map.vertices().map(|(vertex, [x, y])| (vertex, (x * x + y * y).sqrt()));
        found.collect::<Vec<_>>()
    };
    spread(surface, from.iter().flat_map(near))
}

/// Distance of each vertex to the nearest of some vertices with known distances.
pub(super) fn spread(surface: &Surface, known: impl IntoIterator<Item = (usize, f64)>) -> Vec<f64> {
    let mut distances = vec![f64::INFINITY; surface.mesh.positions.len()];
    let mut heap = BinaryHeap::new();
    for (vertex, distance) in known {
        if distance < distances[vertex] {
            distances[vertex] = distance;
            heap.push(Reverse((distance.to_bits(), vertex as u32)));
        }
    }
    let mut is_known = vec![false; distances.len()];
    while let Some(Reverse((bits, vertex))) = heap.pop() {
        let distance = distances[vertex as usize];
        if std::mem::replace(&mut is_known[vertex as usize], true) || distance.to_bits() != bits {
            continue;
        }
        for Spoke { ends, first, second } in surface.tangents.spokes(vertex) {
            let ends = ends.map(|end| end as usize);
            let known = ends.map(|end| is_known[end].then_some(distances[end]));
            let mut reach = |end: usize, distance: f64| {
                if distance < distances[end] {
                    distances[end] = distance;
                    heap.push(Reverse((distance.to_bits(), end as u32)));
                }
            };
            // Along the sides if nothing else is known, otherwise through the face.
            match known {
                [Some(other), None] => reach(ends[1], second.reached([distance, other]).distance),
                [None, Some(other)] => reach(ends[0], first.reached([other, distance]).distance),
                [None, None] => {
                    reach(ends[0], distance + second.side);
                    reach(ends[1], distance + first.side);
                }
                [Some(_), Some(_)] => {}
            }
        }
    }
    distances
}
