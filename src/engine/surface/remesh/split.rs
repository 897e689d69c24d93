//! Cuts long edges in two.

use super::LONG;
use super::half_edges::HalfEdges;
use crate::surface::adjacency::{NONE, next, previous};
use crate::surface::vector::{Vector, middle};

/// Splits each edge that is too long once, the longest first. Returns whether there were any.
pub fn split_long(mesh: &mut HalfEdges, wanted: &impl Fn(Vector) -> f64) -> bool {
    let mut long: Vec<(f64, u32)> = mesh
        .edges()
        .map(|half| (mesh.relative_length(half), half))
        .filter(|(length, _)| *length > LONG)
        .collect();
    long.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    for (_, half) in &long {
        split(mesh, *half, wanted);
    }
    !long.is_empty()
}

/// Puts a vertex in the middle of an edge.
fn split(mesh: &mut HalfEdges, half: u32, wanted: &impl Fn(Vector) -> f64) {
    let (from, to, apex) = (mesh.origin(half), mesh.target(half), mesh.origin(previous(half)));
    let at = middle(mesh.place(from), mesh.place(to));
    let vertex = mesh.positions.len() as u32;
    mesh.positions.push(at);
    mesh.wanted.push(wanted(at));
    mesh.fixed.push(false);
    mesh.first.push(NONE);
    let twin = mesh.twins[half as usize];
    let is_feature = mesh.features[half as usize];
    // from → to → apex becomes from → vertex → apex, and vertex → to → apex.
    let after = next(half);
    let beyond = mesh.twins[after as usize];
    let was_feature = std::mem::replace(&mut mesh.features[after as usize], false);
    set_origin(mesh, after, vertex);
    let added = mesh.add_face([vertex, to, apex]);
    mesh.features[added as usize] = is_feature;
    mesh.features[added as usize + 1] = was_feature;
    mesh.join(added + 1, beyond);
    mesh.join(added + 2, after);
    if twin != NONE {
        // to → from → below becomes vertex → from → below, and to → vertex → below.
        let (before, below) = (previous(twin), mesh.origin(previous(twin)));
        let beyond = mesh.twins[before as usize];
        let was_feature = std::mem::replace(&mut mesh.features[before as usize], false);
        set_origin(mesh, twin, vertex);
        let under = mesh.add_face([to, vertex, below]);
        mesh.features[under as usize] = is_feature;
        mesh.features[under as usize + 2] = was_feature;
        mesh.join(under, added);
        mesh.join(under + 1, before);
        mesh.join(under + 2, beyond);
        mesh.settle(under + 2);
    }
    mesh.settle(added);
    mesh.settle(added + 1);
}

fn set_origin(mesh: &mut HalfEdges, half: u32, vertex: u32) {
    mesh.faces[half as usize / 3][half as usize % 3] = vertex;
}
