//! glTF 2.0 (Khronos), as one binary file (GLB) or as JSON with embedded buffers: all meshes of the scene, at the places of its
//! nodes.
//!
//! A node becomes an object, named after the node or its mesh; skins and morph targets are read in their rest pose. Textures of
//! materials are not read: the pattern replaces them.

mod buffers;
mod transform;

use std::collections::BTreeMap;

use gltf::json::validation::{Error, Validate};
use gltf::mesh::{Mode, Primitive};
use gltf::{Gltf, Node};

use super::error::{ModelError, said};
use super::{Corner, Face, Model, Part};
use buffers::Buffers;
use transform::Transform;

/// Greatest depth of nested nodes.
const DEEPEST: usize = 1_000;
/// Most triangles of all nodes together: more than a GB of memory. Any number of nodes can show one mesh.
const MOST: usize = 20_000_000;

/// Reads a model from the bytes of a glTF or GLB file; `name` is the file's, for messages.
///
/// # Errors
/// A file that does not follow the format, compressed meshes, buffers in other files, a model without triangles.
pub fn read_gltf(bytes: &[u8], name: &str) -> Result<Model, ModelError> {
    let broken = |found: String, allowed: &str, remedy: &'static str| ModelError::Broken {
        file: name.to_owned(),
        found,
        allowed: allowed.to_owned(),
        remedy,
    };
    let read = understood(bytes).map_err(|found| {
        let remedy = "export the model as GLB, without compression of its meshes";
        broken(
            format!("a file that is no supported glTF ({found})"),
            "glTF 2.0 without extensions that are required",
            remedy,
        )
    })?;
    let buffers = Buffers::new(&read).map_err(|found| {
        broken(found, "buffers that are in the file itself", "export the model as GLB, which is one file")
    })?;
    let model = Model { name: name.to_owned(), ..Model::default() };
    let is_read = vec![false; read.nodes().len()];
    let mut reader = Reader { model, buffers, parts: BTreeMap::new(), is_read, not_read: 0, moving: 0 };
    let scene = read.default_scene().or_else(|| read.scenes().next());
    // Without a scene all nodes that have no parent are read.
    let roots: Vec<Node> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => roots(&read),
    };
    for node in roots {
        reader.node(&node, &Transform::default(), 0).map_err(|found| {
            broken(
                found,
                "numbers that the buffers have, and each node in one place",
                "export the model again; the file may be cut off",
            )
        })?;
    }
    reader.finish()
}

/// The parsed and checked file.
///
/// # Errors
/// The problem, in one line.
fn understood(bytes: &[u8]) -> Result<Gltf, String> {
    let read = Gltf::from_slice_without_validation(bytes).map_err(|error| said(&error.to_string()))?;
    let root = read.document.as_json();
    // The library looks up the accessors of positions before it checks that they exist.
    let mut attributes =
        root.meshes.iter().flat_map(|mesh| &mesh.primitives).flat_map(|one| one.attributes.values());
    if let Some(index) = attributes.find(|index| index.value() >= root.accessors.len()) {
        return Err(format!("accessor {} of {}", index.value(), root.accessors.len()));
    }
    let mut errors = Vec::new();
    root.validate(root, gltf::json::Path::new, &mut |path, error| {
        let path = path().to_string();
        // Bounds of positions are required by the format, but not needed here.
        let is_bound = error == Error::Missing && path.contains("attributes");
        if !is_bound {
            errors.push(format!("{path}: {error}"));
        }
    });
    match errors.into_iter().next() {
        Some(error) => Err(said(&error)),
        None => Ok(read),
    }
}

fn roots(read: &Gltf) -> Vec<Node<'_>> {
    let children: std::collections::BTreeSet<usize> = read
        .nodes()
        .flat_map(|node| node.children().map(|child| child.index()).collect::<Vec<_>>())
        .collect();
    read.nodes().filter(|node| !children.contains(&node.index())).collect()
}

struct Reader<'a> {
    model: Model,
    buffers: Buffers<'a>,
    parts: BTreeMap<Part, u32>,
    /// By node: whether it was read.
    is_read: Vec<bool>,
    /// Number of primitives that are no triangles.
    not_read: usize,
    /// Number of meshes with bones or morph targets.
    moving: usize,
}

impl Reader<'_> {
    /// Reads a node and those below it.
    ///
    /// # Errors
    /// What was found.
    fn node(&mut self, node: &Node, above: &Transform, depth: usize) -> Result<(), String> {
        if depth > DEEPEST {
            return Err(format!("nodes within nodes, {depth} deep"));
        }
        // Without this check a few nodes, each used twice by the one above, would become millions.
        if std::mem::replace(&mut self.is_read[node.index()], true) {
            return Err(format!("node {} in two places", node.index()));
        }
        let here = above.then(&Transform::from(node.transform().matrix()));
        if let Some(mesh) = node.mesh() {
            // A mesh with bones is placed by these, not by its node.
            let is_skinned = node.skin().is_some();
            self.moving += usize::from(is_skinned || mesh.weights().is_some());
            let place = if is_skinned { Transform::default() } else { here };
            let object = node.name().or(mesh.name()).map(str::to_owned);
            for primitive in mesh.primitives() {
                self.primitive(&primitive, object.clone(), &place)?;
            }
        }
        for child in node.children() {
            self.node(&child, &here, depth + 1)?;
        }
        Ok(())
    }

    fn primitive(
        &mut self,
        primitive: &Primitive,
        object: Option<String>,
        place: &Transform,
    ) -> Result<(), String> {
        let mode = primitive.mode();
        if !matches!(mode, Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            self.not_read += 1;
            return Ok(());
        }
        let Some(positions) = primitive.get(&gltf::Semantic::Positions) else { return Ok(()) };
        let positions = self.buffers.vectors::<3>(&positions)?;
        let count = positions.len();
        let fits = |length: usize| length == count;
        let normals =
            primitive.get(&gltf::Semantic::Normals).map(|normals| self.buffers.vectors::<3>(&normals));
        let normals = normals.transpose()?.filter(|normals| fits(normals.len()));
        let uvs = primitive.get(&gltf::Semantic::TexCoords(0)).map(|uvs| self.buffers.uvs(&uvs));
        let uvs = uvs.transpose()?.flatten().filter(|uvs| fits(uvs.len()));
        let indices = match primitive.indices() {
            Some(indices) => self.buffers.indices(&indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(index) = indices.iter().find(|index| **index as usize >= count) {
            return Err(format!("the vertex {index} of {count}"));
        }
        let material = primitive.material().name().map(str::to_owned);
        let part = self.part(Part { object, groups: Vec::new(), material });
        let model = &mut self.model;
        let starts = [model.positions.len(), model.uvs.len(), model.normals.len()].map(|start| start as u32);
        model.positions.extend(positions.iter().map(|at| place.point(*at)));
        model.normals.extend(normals.iter().flatten().map(|normal| place.normal(*normal)));
        // In glTF from the upper left corner, here from the lower left one.
        model.uvs.extend(uvs.iter().flatten().map(|[u, v]| [*u, 1.0 - v]));
        let corner = |index: u32| Corner {
            position: starts[0] + index,
            uv: uvs.is_some().then_some(starts[1] + index),
            normal: normals.is_some().then_some(starts[2] + index),
        };
        let triangles = triangles(mode, &indices).into_iter();
        if model.faces.len() + triangles.len() > MOST {
            return Err(format!("more than {MOST} triangles"));
        }
        let turned = triangles.map(|[a, b, c]| if place.is_mirrored() { [a, c, b] } else { [a, b, c] });
        model.faces.extend(turned.map(|triangle| Face { corners: triangle.map(corner), part }));
        Ok(())
    }

    fn part(&mut self, part: Part) -> u32 {
        let model = &mut self.model;
        *self.parts.entry(part).or_insert_with_key(|part| {
            model.parts.push(part.clone());
            model.parts.len() as u32 - 1
        })
    }

    fn finish(self) -> Result<Model, ModelError> {
        let Self { mut model, not_read, moving, .. } = self;
        if model.faces.is_empty() {
            let found = format!("no triangles, but {} positions", model.positions.len());
            return Err(ModelError::NoFaces { file: model.name, found });
        }
        if not_read > 0 {
            model.notes.push(format!("{}: lines and points are not read: {not_read}.", model.name));
        }
        if moving > 0 {
            model.notes.push(format!("{}: {moving} meshes that move are read as they rest.", model.name));
        }
        Ok(model)
    }
}

/// The triangles of a primitive.
fn triangles(mode: Mode, indices: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let windows = indices.array_windows().enumerate();
            windows.map(|(at, &[a, b, c])| if at % 2 == 0 { [a, b, c] } else { [b, a, c] }).collect()
        }
        Mode::TriangleFan => indices.array_windows().skip(1).map(|&[b, c]| [indices[0], b, c]).collect(),
        _ => indices.as_chunks().0.to_vec(),
    }
}

#[cfg(test)]
pub mod tests;
