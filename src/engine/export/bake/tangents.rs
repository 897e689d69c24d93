//! Tangents of corners by MikkTSpace, the way in which modellers and engines compute them, so that all of them read a normal map
//! alike.
//!
//! M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008).

use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};

use crate::export::body::vector::Vector;

/// Square roots and arc cosines that are the same on every processor.
struct Exact;

impl Ops for Exact {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

struct Triangles<'a> {
    places: &'a [[Vector; 3]],
    normals: &'a [[Vector; 3]],
    uvs: &'a [[[f64; 2]; 3]],
    tangents: Vec<[[f32; 4]; 3]>,
}

impl Geometry<Exact> for Triangles<'_> {
    fn num_faces(&self) -> usize {
        self.places.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, vertex: usize) -> [f32; 3] {
        self.places[face][vertex].map(|part| part as f32)
    }

    fn normal(&self, face: usize, vertex: usize) -> [f32; 3] {
        self.normals[face][vertex].map(|part| part as f32)
    }

    fn tex_coord(&self, face: usize, vertex: usize) -> [f32; 2] {
        self.uvs[face][vertex].map(|part| part as f32)
    }

    fn set_tangent(&mut self, tangent: Option<TangentSpace>, face: usize, vertex: usize) {
        if let Some(tangent) = tangent {
            self.tangents[face][vertex] = tangent.tangent_encoded();
        }
    }
}

/// By triangle, the tangent of each corner, along u, with a sign: the bitangent, along v, is sign · (normal × tangent).
pub fn tangents(
    places: &[[Vector; 3]],
    normals: &[[Vector; 3]],
    uvs: &[[[f64; 2]; 3]],
) -> Vec<[[f32; 4]; 3]> {
    let beside = |normal: &Vector| {
        // Any direction will do where a triangle has no area: nothing is seen of it.
        let axis = crate::surface::vector::axis_beside(*normal);
        let [x, y, z] = crate::surface::vector::across(axis, *normal).map(|part| part as f32);
        let length = (x * x + y * y + z * z).sqrt().max(f32::MIN_POSITIVE);
        [x / length, y / length, z / length, 1.0]
    };
    let tangents = normals.iter().map(|normals| [0, 1, 2].map(|corner| beside(&normals[corner]))).collect();
    let mut triangles = Triangles { places, normals, uvs, tangents };
    generate_tangents::<_, Exact>(&mut triangles).expect("its error has no cases");
    triangles.tangents
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_run_along_u_and_a_mirrored_texture_has_the_other_sign() {
        let places = [[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]];
        let normals = [[[0.0, 0.0, 1.0]; 3]];
        let found = |uvs: [[f64; 2]; 3]| tangents(&places, &normals, &[uvs])[0][0];
        assert_eq!(found([[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]]), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(found([[1.0, 0.0], [0.5, 0.0], [1.0, 0.5]]), [-1.0, 0.0, 0.0, -1.0]);
        // A triangle without area in the texture has some tangent at a right angle to its normal.
        let [x, y, z, _] = found([[0.3, 0.3]; 3]);
        assert!(z == 0.0 && (x * x + y * y - 1.0).abs() < 1e-6);
    }
}
