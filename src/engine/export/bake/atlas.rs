//! A model laid out in a texture.

use std::collections::BTreeMap;

use super::corners::Corners;
use super::islands::Islands;
use super::tangents::tangents;
use crate::export::body::vector::Vector;
use crate::surface::Mesh;

/// Triangles with texture coordinates, normals and tangents. The triangles are those of the model, in its order; a vertex is there
/// once for each set of these that its corners have.
#[derive(Clone, Debug)]
pub struct Atlas {
    /// The triangles, in the coordinates of the model's file.
    pub mesh: Mesh,
    /// Texture coordinates by vertex, 0..1 from the lower left corner.
    pub uvs: Vec<[f64; 2]>,
    /// Normals by vertex, of length 1.
    pub normals: Vec<Vector>,
    /// Tangents by vertex, along u, with the sign of the bitangent: sign · (normal × tangent) runs along v, upwards in the picture.
    pub tangents: Vec<[f32; 4]>,
    /// How many pieces of the texture the triangles form.
    pub charts: usize,
    /// By triangle and side, whether the texture ends there. Side k follows corner k.
    pub(super) is_rim: Vec<[bool; 3]>,
}

/// What tells vertices apart: the position, and the bits of coordinates, normal and tangent.
type Key = (u32, [u64; 2], [u32; 3], [u32; 4]);

impl Atlas {
    /// The atlas of triangles with the texture coordinates `uvs` of their corners.
    pub(super) fn new(corners: &Corners, uvs: &[[[f64; 2]; 3]]) -> Self {
        let faces = &corners.mesh.faces;
        let places: Vec<[Vector; 3]> = (0..faces.len()).map(|face| corners.mesh.corners(face)).collect();
        let tangents = tangents(&places, &corners.normals, uvs);
        let Islands { charts, is_rim, .. } = Islands::new(faces, uvs);
        let mesh = Mesh { positions: Vec::new(), faces: Vec::with_capacity(faces.len()) };
        let mut atlas =
            Self { mesh, uvs: Vec::new(), normals: Vec::new(), tangents: Vec::new(), charts, is_rim };
        let mut known: BTreeMap<Key, u32> = BTreeMap::new();
        for (face, positions) in faces.iter().enumerate() {
            let vertices = [0, 1, 2].map(|corner| {
                let (uv, tangent) = (uvs[face][corner], tangents[face][corner]);
                let normal = corners.normals[face][corner];
                let key = (
                    positions[corner],
                    uv.map(f64::to_bits),
                    normal.map(|part| (part as f32).to_bits()),
                    tangent.map(f32::to_bits),
                );
                *known.entry(key).or_insert_with(|| {
                    atlas.mesh.positions.push(places[face][corner]);
                    atlas.uvs.push(uv);
                    atlas.normals.push(normal);
                    atlas.tangents.push(tangent);
                    atlas.uvs.len() as u32 - 1
                })
            });
            atlas.mesh.faces.push(vertices);
        }
        atlas
    }

    /// Where the corners of a triangle are in a picture of this size, texels from the upper left corner.
    pub(super) fn in_picture(&self, face: usize, [width, height]: [usize; 2]) -> [[f64; 2]; 3] {
        self.mesh.faces[face].map(|vertex| {
            let [u, v] = self.uvs[vertex as usize];
            [u * width as f64, (1.0 - v) * height as f64]
        })
    }
}
