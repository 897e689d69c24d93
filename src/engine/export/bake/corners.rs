//! Triangles of a model with what each of their corners has.

use std::collections::BTreeMap;

use crate::export::body::vector::{Vector, cross, dot, minus, plus, unit};
use crate::surface::{Mesh, Model};

/// The cosine between two neighbouring triangles below which the edge between them is sharp: 50°.
const SHARP: f64 = 0.64;

/// Some triangles of a model, in its order.
#[derive(Clone, Debug, Default)]
pub struct Corners {
    /// Positions, in the coordinates of the file, and triangles that share them.
    pub mesh: Mesh,
    /// By triangle: the normals of its corners, of length 1.
    pub normals: Vec<[Vector; 3]>,
    /// By triangle: the texture coordinates of its corners, from the lower left corner; empty if one has none.
    pub uvs: Vec<[[f64; 2]; 3]>,
}

impl Corners {
    /// The triangles of the parts for which `is_grown` holds. Normals are those of the file, where all corners have them; otherwise
    /// the means of the triangles around, up to sharp edges.
    pub fn new(model: &Model, is_grown: &dyn Fn(usize) -> bool) -> Self {
        let faces: Vec<_> = model.faces.iter().filter(|face| is_grown(face.part as usize)).collect();
        let indices = faces.iter().map(|face| face.corners.map(|corner| corner.position)).collect();
        let mesh = Mesh { positions: model.positions.clone(), faces: indices };
        let uvs = faces.iter().map(|face| {
            let [a, b, c] = face.corners.map(|corner| Some(model.uvs[corner.uv? as usize]));
            Some([a?, b?, c?])
        });
        let uvs = uvs.collect::<Option<Vec<_>>>().unwrap_or_default();
        let given = faces.iter().map(|face| {
            let [a, b, c] = face.corners.map(|corner| {
                let normal = model.normals[corner.normal? as usize];
                let is_one = normal.iter().all(|part| part.is_finite()) && dot(normal, normal) > 0.0;
                is_one.then(|| unit(normal))
            });
            Some([a?, b?, c?])
        });
        let given: Option<Vec<_>> = given.collect();
        let normals = given.unwrap_or_else(|| computed(&mesh));
        Self { mesh, normals, uvs }
    }
}

/// Normals of corners: the mean of the triangles around a vertex whose normals are near to its own, weighted by their areas.
fn computed(mesh: &Mesh) -> Vec<[Vector; 3]> {
    // Vertices at the same place are one: files split them where texture coordinates differ.
    let mut known: BTreeMap<[u64; 3], usize> = BTreeMap::new();
    let mut around: Vec<Vec<Vector>> = Vec::new();
    let own = mesh.positions.iter().map(|at| {
        *known.entry(at.map(|part| (part + 0.0).to_bits())).or_insert_with(|| {
            around.push(Vec::new());
            around.len() - 1
        })
    });
    let own: Vec<usize> = own.collect();
    let flat: Vec<Vector> = mesh
        .faces
        .iter()
        .map(|face| {
            let [a, b, c] = face.map(|vertex| mesh.positions[vertex as usize]);
            cross(minus(b, a), minus(c, a))
        })
        .collect();
    for (face, normal) in mesh.faces.iter().zip(&flat) {
        face.iter().for_each(|vertex| around[own[*vertex as usize]].push(*normal));
    }
    let of_corner = |vertex: u32, normal: &Vector| {
        let here = unit(*normal);
        let near = around[own[vertex as usize]].iter().filter(|other| dot(unit(**other), here) >= SHARP);
        unit(near.fold([0.0; 3], |sum, other| plus(sum, 1.0, *other)))
    };
    mesh.faces.iter().zip(&flat).map(|(face, normal)| face.map(|vertex| of_corner(vertex, normal))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::built_in;

    #[test]
    fn a_cube_keeps_its_edges_and_a_sphere_is_smooth() {
        let cube = Corners::new(&built_in("cube").expect("a body"), &|_| true);
        for (normals, face) in cube.normals.iter().zip(0..) {
            let flat = unit(cube.mesh.area_vector(face));
            assert!(normals.iter().all(|normal| dot(*normal, flat) > 1.0 - 1e-12));
        }
        let sphere = Corners::new(&built_in("sphere").expect("a body"), &|_| true);
        for (normals, face) in sphere.normals.iter().zip(&sphere.mesh.faces) {
            for (normal, vertex) in normals.iter().zip(face) {
                assert!(dot(*normal, unit(sphere.mesh.positions[*vertex as usize])) > 0.999);
            }
        }
    }
}
