//! Normals of vertices.

use super::vector::{Vector, cross, minus, plus, unit};
use crate::surface::Mesh;

/// The mean normal of the faces around each vertex, weighted by their areas.
#[must_use]
pub fn normals(mesh: &Mesh) -> Vec<Vector> {
    let mut sums = vec![[0.0; 3]; mesh.positions.len()];
    for face in &mesh.faces {
        let [a, b, c] = face.map(|vertex| mesh.positions[vertex as usize]);
        let normal = cross(minus(b, a), minus(c, a));
        if normal.iter().all(|value| value.is_finite()) {
            for vertex in face {
                sums[*vertex as usize] = plus(sums[*vertex as usize], 1.0, normal);
            }
        }
    }
    sums.into_iter().map(unit).collect()
}
