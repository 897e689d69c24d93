//! Puts vertices and faces of a mesh during remeshing in the order of a space-filling curve: each pass then finds neighbours in the
//! cache.

use super::half_edges::HalfEdges;
use crate::surface::adjacency::NONE;
use crate::surface::mesh::bounds;
use crate::surface::morton::codes;

/// A copy of a mesh in another order, without removed parts.
#[must_use]
pub fn ordered(mesh: &HalfEdges) -> HalfEdges {
    let codes = codes(&mesh.positions, bounds(&mesh.positions));
    let mut vertices: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    vertices.retain(|vertex| mesh.first[*vertex as usize] != NONE);
    vertices.sort_by_key(|vertex| (codes[*vertex as usize], *vertex));
    let place_of = places(&vertices, mesh.positions.len());
    let mut faces: Vec<u32> = (0..mesh.faces.len() as u32).collect();
    faces.retain(|face| mesh.faces[*face as usize][0] != NONE);
    let corners_of = |face: u32| mesh.faces[face as usize].map(|vertex| place_of[vertex as usize]);
    faces.sort_by_key(|face| {
        let places = corners_of(*face);
        (places.iter().copied().min(), places, *face)
    });
    let face_of = places(&faces, mesh.faces.len());
    let half_of = |half: u32| if half == NONE { NONE } else { 3 * face_of[half as usize / 3] + half % 3 };
    let halves = || faces.iter().flat_map(|face| [0, 1, 2].map(|corner| (3 * face + corner) as usize));
    let of_vertices = || vertices.iter().map(|vertex| *vertex as usize);
    HalfEdges {
        positions: of_vertices().map(|vertex| mesh.positions[vertex]).collect(),
        faces: faces.iter().map(|face| corners_of(*face)).collect(),
        twins: halves().map(|half| half_of(mesh.twins[half])).collect(),
        features: halves().map(|half| mesh.features[half]).collect(),
        first: of_vertices().map(|vertex| half_of(mesh.first[vertex])).collect(),
        wanted: of_vertices().map(|vertex| mesh.wanted[vertex]).collect(),
        fixed: of_vertices().map(|vertex| mesh.fixed[vertex]).collect(),
    }
}

/// The position of each of `count` numbers in an order; [`NONE`] for numbers that are not in it.
fn places(order: &[u32], count: usize) -> Vec<u32> {
    let mut places = vec![NONE; count];
    order.iter().enumerate().for_each(|(place, number)| places[*number as usize] = place as u32);
    places
}
