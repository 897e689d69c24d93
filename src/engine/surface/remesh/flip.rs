//! Flips edges: they then join the other two corners of their faces.

use super::half_edges::{Freedom, HalfEdges};
use crate::surface::adjacency::{NONE, next, previous};
use crate::surface::mesh::area_vector;
use crate::surface::vector::{Vector, cross, dot, length, minus, plus};

/// Largest angle between faces after a flip, as cosine: 53°.
const FLAT: f64 = 0.6;
/// Least amount by which the sum of the cotangents opposite to an edge is below 0 for a flip, so that no edge is flipped back and
/// forth.
const CLEARLY: f64 = 1e-9;
/// Least angle after a flip towards an even valence, as cotangent: 20°.
const SLIM: f64 = 2.747_477_419_454_622;
/// Most passes until a mesh is Delaunay.
const PASSES: usize = 10;

/// Flips edges if the valences of the four corners come nearer to six, or to four on a border.
pub fn towards_even_valence(mesh: &mut HalfEdges) {
    for half in 0..mesh.twins.len() as u32 {
        if let Some(corners) = corners(mesh, half)
            && gain(mesh, corners) > 0
            && is_fit(mesh, corners, Some(SLIM))
        {
            flip(mesh, half);
        }
    }
}

/// Flips edges whose opposite angles add up to more than 180°: the least angle increases.
pub fn towards_larger_angles(mesh: &mut HalfEdges) {
    // The quadrilateral of an edge changes only if an edge beside it is flipped.
    let mut has_changed = vec![true; mesh.twins.len()];
    for _ in 0..PASSES {
        let mut is_done = true;
        for half in 0..mesh.twins.len() as u32 {
            if std::mem::replace(&mut has_changed[half as usize], false)
                && let Some(corners) = corners(mesh, half)
                && is_wide(mesh, corners)
                && is_fit(mesh, corners, None)
            {
                is_done = false;
                for beside in flip(mesh, half) {
                    for half in [beside, mesh.twins[beside as usize]].into_iter().filter(|half| *half != NONE)
                    {
                        has_changed[half as usize] = true;
                    }
                }
            }
        }
        if is_done {
            return;
        }
    }
}

/// Start and end of an edge that may be flipped, and the corners to the left and to the right of it.
fn corners(mesh: &HalfEdges, half: u32) -> Option<[u32; 4]> {
    let twin = mesh.twins[half as usize];
    let may = mesh.is_edge(half) && twin != NONE && !mesh.features[half as usize];
    may.then(|| [half, twin, previous(half), previous(twin)].map(|half| mesh.origin(half)))
}

/// Decrease of the squared differences between the valences and the wanted ones.
fn gain(mesh: &HalfEdges, corners: [u32; 4]) -> i64 {
    let of = |vertex: u32, more: i64| {
        let wanted = if mesh.is_on_border(vertex) { 4 } else { 6 };
        let missing = mesh.valence(vertex) as i64 - wanted;
        missing * missing - (missing + more) * (missing + more)
    };
    let [a, b, c, d] = corners;
    of(a, -1) + of(b, -1) + of(c, 1) + of(d, 1)
}

fn cotangent(apex: Vector, a: Vector, b: Vector) -> f64 {
    let (a, b) = (minus(a, apex), minus(b, apex));
    dot(a, b) / length(cross(a, b)).max(f64::MIN_POSITIVE)
}

fn is_wide(mesh: &HalfEdges, corners: [u32; 4]) -> bool {
    let [a, b, c, d] = corners.map(|vertex| mesh.place(vertex));
    cotangent(c, a, b) + cotangent(d, a, b) < -CLEARLY
}

/// Whether a flip makes two faces that lie about where the old ones did, without angles below that of the cotangent `least`, if it
/// is given.
fn is_fit(mesh: &HalfEdges, corners: [u32; 4], least: Option<f64>) -> bool {
    let [a, b, c, d] = corners;
    let keeps = |vertex: u32| {
        let least = if mesh.is_on_border(vertex) { 2 } else { 3 };
        mesh.valence(vertex) > least
    };
    if c == d || !keeps(a) || !keeps(b) || mesh.ring(c).any(|other| other == d) {
        return false;
    }
    // An edge between two ends of features that are not connected would look like a feature.
    let is_held = |vertex: u32| mesh.freedom(vertex) != Freedom::Free;
    if least.is_some() && is_held(c) && is_held(d) {
        return false;
    }
    let [a, b, c, d] = corners.map(|vertex| mesh.place(vertex));
    let old = plus(area_vector([a, b, c]), area_vector([b, a, d]));
    let new = [area_vector([a, d, c]), area_vector([d, b, c])];
    let [first, second] = new.map(length);
    let is_flat = dot(new[0], new[1]) > FLAT * first * second && new.iter().all(|new| dot(*new, old) > 0.0);
    let is_slim = least.is_some_and(|least| {
        [[a, d, c], [d, c, a], [c, a, d], [d, b, c], [b, c, d], [c, d, b]]
            .iter()
            .any(|[apex, a, b]| cotangent(*apex, *a, *b) > least)
    });
    is_flat && !is_slim
}

/// The faces a → b → c and b → a → d become d → c → a and c → d → b. Returns the half-edges of the sides around them.
fn flip(mesh: &mut HalfEdges, half: u32) -> [u32; 4] {
    let twin = mesh.twins[half as usize];
    let [a, b, c, d] = [half, twin, previous(half), previous(twin)].map(|half| mesh.origin(half));
    let around = [previous(half), next(twin), previous(twin), next(half)];
    let outside = around.map(|half| mesh.twins[half as usize]);
    let features = around.map(|half| mesh.features[half as usize]);
    let (left, right) = (half / 3 * 3, twin / 3 * 3);
    mesh.faces[left as usize / 3] = [d, c, a];
    mesh.faces[right as usize / 3] = [c, d, b];
    mesh.join(left, right);
    let inside = [left + 1, left + 2, right + 1, right + 2];
    mesh.features[left as usize] = false;
    mesh.features[right as usize] = false;
    for ((inside, outside), feature) in inside.into_iter().zip(outside).zip(features) {
        mesh.join(inside, outside);
        mesh.features[inside as usize] = feature;
    }
    for half in inside {
        mesh.settle(half);
    }
    inside
}
