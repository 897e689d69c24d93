//! Cuts each triangle into four.

use super::half_edges::HalfEdges;
use crate::surface::adjacency::{Adjacency, NONE, previous};
use crate::surface::vector::{Vector, middle};

/// The mesh with a vertex in the middle of each edge, and edges half as long.
#[must_use]
pub fn subdivided(mesh: &HalfEdges, wanted: &impl Fn(Vector) -> f64) -> HalfEdges {
    let mut positions = mesh.positions.clone();
    let mut middles = vec![NONE; mesh.twins.len()];
    for half in mesh.edges() {
        let twin = mesh.twins[half as usize];
        for side in [half, twin].into_iter().filter(|side| *side != NONE) {
            middles[side as usize] = positions.len() as u32;
        }
        positions.push(middle(mesh.place(mesh.origin(half)), mesh.place(mesh.target(half))));
    }
    let (mut faces, mut features) = (Vec::new(), Vec::new());
    for face in (0..mesh.faces.len()).filter(|face| mesh.faces[*face][0] != NONE) {
        let halves = [0, 1, 2].map(|k| (3 * face + k) as u32);
        for half in halves {
            let before = previous(half);
            faces.push([mesh.origin(half), middles[half as usize], middles[before as usize]]);
            features.extend([mesh.features[half as usize], false, mesh.features[before as usize]]);
        }
        faces.push(halves.map(|half| middles[half as usize]));
        features.extend([false; 3]);
    }
    let Adjacency { twins, first } = Adjacency::new(positions.len(), &faces);
    let mut fixed = mesh.fixed.clone();
    fixed.resize(positions.len(), false);
    HalfEdges {
        wanted: positions.iter().map(|at| wanted(*at)).collect(),
        fixed,
        positions,
        faces,
        twins,
        features,
        first,
    }
}
