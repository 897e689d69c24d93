//! Features that are preserved (borders, sharp edges and corners), and the surface onto which vertices are projected.

use super::half_edges::{Freedom, HalfEdges};
use crate::surface::adjacency::NONE;
use crate::surface::bounding_tree::BoundingTree;
use crate::surface::mesh::Mesh;
use crate::surface::vector::{Vector, dot, length, minus, unit};

/// An edge is sharp if the angle between the normals of its faces exceeds this, as cosine: 50°. An icosahedron has 42°, a cube 90°.
const SHARP: f64 = 0.642_787_609_686_539_3;
/// A vertex is a corner if its features bend by more than this, as cosine: 50°.
const CORNER: f64 = 0.642_787_609_686_539_3;
/// Faces lower than this share of their longest side have no reliable normal.
const SLIVER: f64 = 1e-4;

/// The original surface.
pub struct Original {
    surface: BoundingTree,
    /// Normals of its faces; 0 for those without area.
    normals: Vec<Vector>,
    features: BoundingTree,
}

impl Original {
    /// The surface of `mesh`; its features are marked in `made`, which is the same mesh.
    pub fn new(mesh: &Mesh, made: &mut HalfEdges) -> Self {
        let normals = (0..mesh.faces.len()).map(|face| unit(mesh.area_vector(face)).unwrap_or([0.0; 3]));
        let normals: Vec<Vector> = normals.collect();
        mark(made, &normals);
        let features = made.edges().filter(|half| made.features[*half as usize]);
        let segments: Vec<[Vector; 3]> = features
            .map(|half| {
                let [a, b] = [made.origin(half), made.target(half)].map(|vertex| made.place(vertex));
                [a, b, b]
            })
            .collect();
        Self {
            surface: BoundingTree::new((0..mesh.faces.len()).map(|face| mesh.corners(face))),
            normals,
            features: BoundingTree::new(segments),
        }
    }

    /// The nearest place of the surface whose normal is less than 90° from this one: not the other side of a thin sheet.
    pub fn on_surface(&self, at: Vector, normal: Vector) -> Vector {
        let is_fit = |face: u32| dot(self.normals[face as usize], normal) > 0.0;
        self.surface.nearest(at, is_fit).map_or(at, |found| found.at)
    }

    /// The nearest place of the features.
    pub fn on_features(&self, at: Vector) -> Vector {
        self.features.nearest(at, |_| true).map_or(at, |found| found.at)
    }
}

/// Marks sharp edges and corners.
fn mark(made: &mut HalfEdges, normals: &[Vector]) {
    let is_sliver = |face: usize| {
        let longest = (0..3).map(|k| made.length((3 * face + k) as u32)).fold(0.0, f64::max);
        length(made.area_vector(face)) < SLIVER * longest * longest
    };
    let sharp: Vec<u32> = made
        .edges()
        .filter(|half| {
            let twin = made.twins[*half as usize];
            let [a, b] = [*half as usize / 3, twin as usize / 3];
            twin != NONE && dot(normals[a], normals[b]) < SHARP && !is_sliver(a) && !is_sliver(b)
        })
        .collect();
    for half in sharp {
        made.features[half as usize] = true;
        made.features[made.twins[half as usize] as usize] = true;
    }
    for vertex in 0..made.positions.len() as u32 {
        if made.freedom(vertex) == Freedom::Along {
            let here = made.place(vertex);
            let ways: Vec<Vector> =
                made.features_at(vertex).filter_map(|end| unit(minus(made.place(end), here))).collect();
            made.fixed[vertex as usize] = ways.len() == 2 && -dot(ways[0], ways[1]) < CORNER;
        }
    }
}
