//! Joins the ends of short edges.

use super::half_edges::{Freedom, HalfEdges};
use super::{LONG, SHORT};
use crate::surface::adjacency::{NONE, next, previous};
use crate::surface::mesh::area_vector;
use crate::surface::vector::{Vector, distance, dot, length, middle};

/// Features and corners are given up at edges shorter than this, in wanted lengths: they are too small for the wanted triangles.
const TINY: f64 = 0.25;
/// Ends of edges shorter than this are not moved to the middle, so that many of them do not leave the surface.
const FINE: f64 = 0.4;
/// Largest rotation of a face by a collapse, as cosine.
const TURNED: f64 = 0.2;
/// Factor by which edges may be lengthened if they are too long already.
const LONGER: f64 = 1.05;
/// Most passes: a large mesh becomes a small one in several passes.
const PASSES: usize = 24;

/// Collapses edges that are too short, as long as some can be collapsed.
pub fn collapse_short(mesh: &mut HalfEdges, wanted: &impl Fn(Vector) -> f64) {
    for _ in 0..PASSES {
        let mut is_done = true;
        for half in 0..mesh.twins.len() as u32 {
            if mesh.is_edge(half) {
                let length = mesh.relative_length(half);
                is_done &= !(length < SHORT && collapse(mesh, half, length, wanted));
            }
        }
        if is_done {
            return;
        }
    }
}

/// Collapses an edge of this relative length, if the surface is preserved. Returns whether it did.
fn collapse(mesh: &mut HalfEdges, half: u32, length: f64, wanted: &impl Fn(Vector) -> f64) -> bool {
    let (from, to) = (mesh.origin(half), mesh.target(half));
    let [first, second] = [from, to].map(|vertex| mesh.freedom(vertex));
    let may = length < TINY
        || first.min(second) == Freedom::Free
        || mesh.features[half as usize] && first.min(second) == Freedom::Along;
    if !may || !is_linked_simply(mesh, half) {
        return false;
    }
    let at = match first.cmp(&second) {
        std::cmp::Ordering::Greater => mesh.place(from),
        std::cmp::Ordering::Less => mesh.place(to),
        std::cmp::Ordering::Equal if length < FINE || first == Freedom::Fixed => mesh.place(to),
        std::cmp::Ordering::Equal => middle(mesh.place(from), mesh.place(to)),
    };
    let wanted_there = wanted(at);
    if ![[from, to], [to, from]].iter().all(|ends| keeps_shape(mesh, *ends, at, wanted_there)) {
        return false;
    }
    mesh.positions[to as usize] = at;
    mesh.wanted[to as usize] = wanted_there;
    mesh.fixed[to as usize] |= mesh.fixed[from as usize];
    merge(mesh, half);
    true
}

/// The link condition: the ends have no common neighbours except the corners opposite to the edge, and none of these would be left
/// without an inside.
fn is_linked_simply(mesh: &HalfEdges, half: u32) -> bool {
    let (from, to, twin) = (mesh.origin(half), mesh.target(half), mesh.twins[half as usize]);
    if twin != NONE && mesh.is_on_border(from) && mesh.is_on_border(to) {
        return false;
    }
    let sides = [half, twin];
    let sides = sides.iter().filter(|side| **side != NONE);
    let is_apex_kept = |side: &u32| {
        let apex = mesh.origin(previous(*side));
        let outside = [next(*side), previous(*side)].map(|half| mesh.twins[half as usize]);
        outside != [NONE; 2] && (mesh.is_on_border(apex) || mesh.valence(apex) > 3)
    };
    let count = sides.clone().count();
    let is_beside = |vertex: u32| mesh.ring(to).any(|other| other == vertex);
    mesh.ring(from).filter(|vertex| is_beside(*vertex)).count() == count && sides.clone().all(is_apex_kept)
}

/// Whether the faces at the first of two vertices, except those with both, are neither rotated nor stretched too far if it is moved
/// to the place `at`.
fn keeps_shape(mesh: &HalfEdges, [vertex, other]: [u32; 2], at: Vector, wanted: f64) -> bool {
    let here = mesh.place(vertex);
    // The normals of slivers are arbitrary: rotated a little by each of several collapses, they would finally lie upside down.
    let outside = mesh.normal(vertex);
    let is_free = mesh.freedom(vertex) == Freedom::Free;
    mesh.fan(vertex).all(|half| {
        let [_, a, b] = [half, next(half), previous(half)].map(|half| mesh.origin(half));
        let too_long = |end: u32| {
            let (new, old) = (distance(at, mesh.place(end)), distance(here, mesh.place(end)));
            let long = LONG * 0.5 * (wanted + mesh.wanted[end as usize]);
            end != other && new > long.max(LONGER * old)
        };
        if too_long(a) || too_long(b) {
            return false;
        }
        if a == other || b == other {
            return true;
        }
        let [a, b] = [a, b].map(|vertex| mesh.place(vertex));
        let [old, new] = [here, at].map(|corner| area_vector([corner, a, b]));
        let sizes = length(old) * length(new);
        let keeps_side = !is_free || dot(new, outside) > 0.0;
        dot(old, new) >= TURNED * sizes && length(new) > 0.0 && keeps_side
    })
}

/// Removes an edge, its faces and one of its vertices.
fn merge(mesh: &mut HalfEdges, half: u32) {
    let (from, to, twin) = (mesh.origin(half), mesh.target(half), mesh.twins[half as usize]);
    let fan: Vec<u32> = mesh.fan(from).collect();
    for half in fan {
        mesh.faces[half as usize / 3][half as usize % 3] = to;
    }
    mesh.first[from as usize] = NONE;
    let mut starts = Vec::with_capacity(4);
    for side in [half, twin].into_iter().filter(|side| *side != NONE) {
        let inside = [next(side), previous(side)];
        let outside = inside.map(|half| mesh.twins[half as usize]);
        let is_feature = inside.iter().any(|half| mesh.features[*half as usize]);
        mesh.join(outside[0], outside[1]);
        for outside in outside.into_iter().filter(|outside| *outside != NONE) {
            mesh.features[outside as usize] |= is_feature;
            // One of these leaves the remaining vertex, the other the corner opposite to the edge.
            starts.extend([outside, next(outside)]);
        }
        mesh.faces[side as usize / 3] = [NONE; 3];
    }
    for start in starts {
        mesh.settle(start);
    }
}
