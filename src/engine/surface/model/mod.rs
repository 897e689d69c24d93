//! A model in the form of its file: the parts to grow on, and the parts that are passed through unchanged.

mod error;
mod foreign;
mod gltf;
mod obj;
mod ply;
mod polygon;
mod reading;
mod stl;

use std::collections::BTreeMap;

pub use error::{ModelError, Place};
pub use reading::read_model;

use super::mesh::Mesh;

/// A corner of a triangle: indices of a position and, if the file has them, of a texture coordinate and a normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Corner {
    /// Index in [`Model::positions`].
    pub position: u32,
    /// Index in [`Model::uvs`].
    pub uv: Option<u32>,
    /// Index in [`Model::normals`].
    pub normal: Option<u32>,
}

impl From<u32> for Corner {
    fn from(position: u32) -> Self {
        Self { position, uv: None, normal: None }
    }
}

/// A triangle of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Its corners, counter-clockwise seen from outside.
    pub corners: [Corner; 3],
    /// Index in [`Model::parts`].
    pub part: u32,
}

/// Faces with equal names: of one object, of equal groups, with one material.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Part {
    /// The object that it belongs to (`o`).
    pub object: Option<String>,
    /// The groups that it belongs to (`g`).
    pub groups: Vec<String>,
    /// The name of its material (`usemtl`).
    pub material: Option<String>,
}

impl Part {
    /// Its names: the object, the groups, the material.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.object.iter().chain(&self.groups).chain(&self.material).map(String::as_str)
    }

    /// Whether one of its names is among these.
    #[must_use]
    pub fn is_of(&self, names: &[String]) -> bool {
        self.names().any(|own| names.iter().any(|name| name == own))
    }
}

/// A model of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Its origin, for messages: the name of a file or of a built-in body.
    pub name: String,
    /// Positions, in the file's own unit and axes.
    pub positions: Vec<[f64; 3]>,
    /// Texture coordinates, from the lower left corner.
    pub uvs: Vec<[f64; 2]>,
    /// Normals in the form of the file: not always of length 1.
    pub normals: Vec<[f64; 3]>,
    /// Triangles, in the order of the file.
    pub faces: Vec<Face>,
    /// The parts that the triangles belong to.
    pub parts: Vec<Part>,
    /// Notes on data that were left out or interpreted, a sentence each.
    pub notes: Vec<String>,
}

/// Triangles whose vertices have one texture coordinate and one normal each, the form of files of models and of graphics cards.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Split {
    /// The triangles. A vertex is repeated for each combination of texture coordinate and normal that it has.
    pub mesh: Mesh,
    /// Texture coordinates by vertex; empty where a corner has none.
    pub uvs: Vec<[f64; 2]>,
    /// Normals by vertex; empty where a corner has none.
    pub normals: Vec<[f64; 3]>,
}

impl Model {
    /// The triangles to grow on: those of the groups, objects and materials in `only`, or all if it is empty. Vertices that only
    /// other triangles use are left out.
    ///
    /// # Errors
    /// A name that no part of the model has.
    pub fn mesh(&self, only: &[String]) -> Result<Mesh, ModelError> {
        let unknown =
            only.iter().find(|name| !self.parts.iter().any(|part| part.names().any(|own| own == *name)));
        if let Some(name) = unknown {
            let names: std::collections::BTreeSet<&str> = self.parts.iter().flat_map(Part::names).collect();
            return Err(ModelError::no_part(&self.name, name, &names));
        }
        let chosen = self.faces.iter().filter(|face| only.is_empty() || self.part(face).is_of(only));
        let mut mesh = Mesh::default();
        let mut vertices = vec![u32::MAX; self.positions.len()];
        for face in chosen {
            mesh.faces.push(face.corners.map(|corner| {
                let vertex = &mut vertices[corner.position as usize];
                if *vertex == u32::MAX {
                    *vertex = mesh.positions.len() as u32;
                    mesh.positions.push(self.positions[corner.position as usize]);
                }
                *vertex
            }));
        }
        Ok(mesh)
    }

    /// The parts that are passed through unchanged if the pattern grows on `only`: those that [`Self::mesh`] leaves out.
    #[must_use]
    pub fn others(&self, only: &[String]) -> Vec<usize> {
        (0..self.parts.len()).filter(|part| !only.is_empty() && !self.parts[*part].is_of(only)).collect()
    }

    /// A part with its texture coordinates and normals.
    #[must_use]
    pub fn split(&self, part: usize) -> Split {
        let faces = self.faces.iter().filter(|face| face.part as usize == part);
        let mut vertices: BTreeMap<Corner, u32> = BTreeMap::new();
        let mut order = Vec::new();
        let mut split = Split::default();
        for face in faces {
            split.mesh.faces.push(face.corners.map(|corner| {
                *vertices.entry(corner).or_insert_with(|| {
                    order.push(corner);
                    (order.len() - 1) as u32
                })
            }));
        }
        split.mesh.positions = order.iter().map(|corner| self.positions[corner.position as usize]).collect();
        let uvs = order.iter().map(|corner| Some(self.uvs[corner.uv? as usize]));
        split.uvs = uvs.collect::<Option<_>>().unwrap_or_default();
        let normals = order.iter().map(|corner| Some(self.normals[corner.normal? as usize]));
        split.normals = normals.collect::<Option<_>>().unwrap_or_default();
        split
    }

    /// The least and the greatest coordinates of the triangles' corners; positions that are not finite are ignored, and without any
    /// corner all are 0.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for corner in self.faces.iter().flat_map(|face| face.corners) {
            let position = self.positions[corner.position as usize];
            if position.iter().all(|value| value.is_finite()) {
                for axis in 0..3 {
                    bounds[0][axis] = bounds[0][axis].min(position[axis]);
                    bounds[1][axis] = bounds[1][axis].max(position[axis]);
                }
            }
        }
        if bounds[0][0] > bounds[1][0] { [[0.0; 3]; 2] } else { bounds }
    }

    fn part(&self, face: &Face) -> &Part {
        &self.parts[face.part as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 9 9 9\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 2\n\
        o cat\ng head left\nusemtl fur\nf 1/1/1 2/2/1 3/3/1\ng tail\nusemtl claw\nf 2/2/1 3/3/1 4/1/1\nf 2/1/1 4/2/1 3/3/1\n";

    fn two() -> Model {
        read_model(TWO.as_bytes(), "two.obj").unwrap()
    }

    #[test]
    fn only_the_named_groups_objects_and_materials_are_grown_on() {
        let faces = |only: &[&str]| {
            let only: Vec<String> = only.iter().map(|&name| name.to_owned()).collect();
            two().mesh(&only).map(|mesh| (mesh.positions.len(), mesh.faces.len()))
        };
        assert_eq!(faces(&[]).unwrap(), (4, 3));
        assert_eq!(faces(&["cat"]).unwrap(), (4, 3));
        assert_eq!(faces(&["left"]).unwrap(), (3, 1));
        assert_eq!(faces(&["claw"]).unwrap(), (3, 2));
        assert_eq!(faces(&["fur", "tail"]).unwrap(), (4, 3));
        let message = faces(&["fur", "paw"]).unwrap_err().to_string();
        for word in ["two.obj", "'paw'", "'cat'", "'claw'", "'fur'", "'head'", "'left'", "'tail'"] {
            assert!(message.contains(word), "{message}");
        }
        assert_eq!(two().others(&["head".to_owned()]), [1]);
        assert_eq!(two().others(&[]), [0; 0]);
    }

    #[test]
    fn a_vertex_is_split_where_its_texture_coordinates_differ() {
        let part = two().split(1);
        // Corners 2/2, 3/3, 4/1, 2/1, 4/2.
        assert_eq!(part.mesh.faces, [[0, 1, 2], [3, 4, 1]]);
        assert_eq!(part.mesh.positions[0], part.mesh.positions[3]);
        assert_eq!(part.uvs, [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(part.normals, [[0.0, 0.0, 2.0]; 5]);
    }

    #[test]
    fn the_bounds_are_those_of_the_triangles() {
        assert_eq!(two().bounds(), [[0.0; 3], [5.0; 3]]);
        assert_eq!(Model::default().bounds(), [[0.0; 3]; 2]);
        let broken = read_model(b"v nan 0 0\nv 1 2 3\nv 1 2 4\nf 1 2 3", "x").unwrap();
        assert_eq!(broken.bounds(), [[1.0, 2.0, 3.0], [1.0, 2.0, 4.0]]);
    }
}
