//! Moves vertices along the surface to the centre of their faces.

use rayon::prelude::*;

use super::features::Original;
use super::half_edges::{Freedom, HalfEdges};
use crate::surface::adjacency::{NONE, next, previous};
use crate::surface::mesh::area_vector;
use crate::surface::vector::{Vector, distance, dot, length, middle, minus, plus, times, unit};

/// Number of vertices below which no other thread is used. Not tuned.
const FEW: usize = 256;

/// Moves all vertices at once.
pub fn relax(mesh: &mut HalfEdges, original: &Original, wanted: &(impl Fn(Vector) -> f64 + Sync)) {
    let shared: &HalfEdges = mesh;
    let moved: Vec<(Vector, f64)> = (0..mesh.positions.len() as u32)
        .into_par_iter()
        .with_min_len(FEW)
        .map(|vertex| {
            let here = shared.place(vertex);
            let to =
                if shared.first[vertex as usize] == NONE { None } else { moved(shared, vertex, original) };
            // Anything farther than the next vertex belongs to another part of the surface.
            let is_near = |to: &Vector| distance(here, *to) <= shared.wanted[vertex as usize];
            match to.filter(is_near).filter(|to| keeps_sides(shared, vertex, *to)) {
                Some(to) => (to, wanted(to)),
                None => (here, shared.wanted[vertex as usize]),
            }
        })
        .collect();
    (mesh.positions, mesh.wanted) = moved.into_iter().unzip();
}

/// The new place of a vertex; `None` if it stays.
fn moved(mesh: &HalfEdges, vertex: u32, original: &Original) -> Option<Vector> {
    let here = mesh.place(vertex);
    match mesh.freedom(vertex) {
        Freedom::Fixed => None,
        Freedom::Along => {
            let mut ends = mesh.features_at(vertex).map(|end| mesh.place(end));
            let (a, b) = (ends.next()?, ends.next()?);
            // Along the feature only, so that curved features do not shrink.
            let along = unit(minus(b, a))?;
            let to = plus(here, times(along, dot(minus(middle(a, b), here), along)));
            Some(original.on_features(to))
        }
        Freedom::Free => {
            let (mut sum, mut total, mut normal) = ([0.0; 3], 0.0, [0.0; 3]);
            for half in mesh.fan(vertex) {
                let [_, a, b] = [half, next(half), previous(half)].map(|half| mesh.origin(half));
                let (length_here, [of_a, of_b]) =
                    (mesh.wanted[vertex as usize], [a, b].map(|vertex| mesh.wanted[vertex as usize]));
                let corners = [here, mesh.place(a), mesh.place(b)];
                let area = area_vector(corners);
                normal = plus(normal, area);
                // The weight is proportional to the area relative to the wanted one.
                let length_of = length_here + of_a + of_b;
                let weight = length(area) / (length_of * length_of);
                sum = plus(sum, times(plus(plus(corners[0], corners[1]), corners[2]), weight / 3.0));
                total += weight;
            }
            let normal = unit(normal)?;
            let shift = minus(times(sum, 1.0 / total), here);
            let to = plus(here, minus(shift, times(normal, dot(shift, normal))));
            to.iter().all(|part| part.is_finite()).then(|| original.on_surface(to, normal))
        }
    }
}

/// Whether moving a vertex reverses none of its faces.
fn keeps_sides(mesh: &HalfEdges, vertex: u32, to: Vector) -> bool {
    let here = mesh.place(vertex);
    mesh.fan(vertex).all(|half| {
        let [a, b] = [next(half), previous(half)].map(|half| mesh.place(mesh.origin(half)));
        let [old, new] = [here, to].map(|corner| area_vector([corner, a, b]));
        dot(old, new) > 0.0 || length(old) == 0.0
    })
}
