//! A triangle mesh that is changed edge by edge.

use crate::surface::adjacency::{Adjacency, NONE, next, previous};
use crate::surface::mesh::{Mesh, area_vector};
use crate::surface::vector::{Vector, distance, plus};

/// Faces with their adjacency; half-edges are numbered as in [`Adjacency`].
pub struct HalfEdges {
    pub positions: Vec<Vector>,
    /// [`NONE`] three times for a face that has been removed.
    pub faces: Vec<[u32; 3]>,
    pub twins: Vec<u32>,
    /// By half-edge: whether it must stay where it is, as borders and sharp edges must.
    pub features: Vec<bool>,
    /// By vertex: a half-edge that leaves it, on a border the one without a twin; [`NONE`] for a vertex that has been removed.
    pub first: Vec<u32>,
    /// By vertex: the wanted length of edges there.
    pub wanted: Vec<f64>,
    /// By vertex: whether it must stay where it is.
    pub fixed: Vec<bool>,
}

/// Restrictions on the movement of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Freedom {
    /// Over the surface.
    Free,
    /// Along the two features that meet in it.
    Along,
    /// Not at all.
    Fixed,
}

impl HalfEdges {
    pub fn new(mesh: &Mesh, wanted: &(impl Fn(Vector) -> f64 + Sync)) -> Self {
        let Adjacency { twins, first } = Adjacency::new(mesh.positions.len(), &mesh.faces);
        Self {
            features: twins.iter().map(|twin| *twin == NONE).collect(),
            wanted: mesh.positions.iter().map(|at| wanted(*at)).collect(),
            fixed: vec![false; mesh.positions.len()],
            positions: mesh.positions.clone(),
            faces: mesh.faces.clone(),
            twins,
            first,
        }
    }

    /// The mesh of the remaining faces and vertices.
    pub fn to_mesh(&self) -> Mesh {
        let mut new = vec![NONE; self.positions.len()];
        let mut mesh = Mesh::default();
        for face in self.faces.iter().filter(|face| face[0] != NONE) {
            mesh.faces.push(face.map(|vertex| {
                let new = &mut new[vertex as usize];
                if *new == NONE {
                    *new = mesh.positions.len() as u32;
                    mesh.positions.push(self.positions[vertex as usize]);
                }
                *new
            }));
        }
        mesh
    }

    /// The vertex that a half-edge leaves.
    pub fn origin(&self, half: u32) -> u32 {
        self.faces[half as usize / 3][half as usize % 3]
    }

    /// The vertex that a half-edge leads to.
    pub fn target(&self, half: u32) -> u32 {
        self.origin(next(half))
    }

    pub fn place(&self, vertex: u32) -> Vector {
        self.positions[vertex as usize]
    }

    /// Length of an edge.
    pub fn length(&self, half: u32) -> f64 {
        distance(self.place(self.origin(half)), self.place(self.target(half)))
    }

    /// Length of an edge ÷ wanted length.
    pub fn relative_length(&self, half: u32) -> f64 {
        let wanted = |vertex: u32| self.wanted[vertex as usize];
        2.0 * self.length(half) / (wanted(self.origin(half)) + wanted(self.target(half)))
    }

    /// A vector along the normal of a face; its length is twice the area.
    pub fn area_vector(&self, face: usize) -> Vector {
        area_vector(self.faces[face].map(|vertex| self.place(vertex)))
    }

    /// The sum of the normals of the faces at a vertex, each with a length of twice its area.
    pub fn normal(&self, vertex: u32) -> Vector {
        self.fan(vertex).fold([0.0; 3], |sum, half| plus(sum, self.area_vector(half as usize / 3)))
    }

    /// One half-edge of each edge, in order.
    pub fn edges(&self) -> impl Iterator<Item = u32> {
        (0..self.twins.len() as u32).filter(|half| self.is_edge(*half))
    }

    /// Whether a half-edge represents its edge.
    pub fn is_edge(&self, half: u32) -> bool {
        let twin = self.twins[half as usize];
        self.faces[half as usize / 3][0] != NONE && (twin == NONE || half < twin)
    }

    /// The half-edges that leave a vertex, counter-clockwise.
    pub fn fan(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let first = self.first[vertex as usize];
        let mut half = first;
        std::iter::from_fn(move || {
            let found = half;
            if found == NONE {
                return None;
            }
            half = self.twins[previous(found) as usize];
            if half == first {
                half = NONE;
            }
            Some(found)
        })
    }

    /// The vertices adjacent to a vertex.
    pub fn ring(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let last = if self.is_on_border(vertex) { self.fan(vertex).last() } else { None };
        self.fan(vertex).map(|half| self.target(half)).chain(last.map(|half| self.origin(previous(half))))
    }

    pub fn is_on_border(&self, vertex: u32) -> bool {
        let first = self.first[vertex as usize];
        first == NONE || self.twins[first as usize] == NONE
    }

    /// Number of edges at a vertex.
    pub fn valence(&self, vertex: u32) -> usize {
        self.fan(vertex).count() + usize::from(self.is_on_border(vertex))
    }

    /// The ends of the features at a vertex.
    pub fn features_at(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let last = if self.is_on_border(vertex) { self.fan(vertex).last() } else { None };
        let along =
            self.fan(vertex).filter(|half| self.features[*half as usize]).map(|half| self.target(half));
        along.chain(last.map(|half| self.origin(previous(half))))
    }

    pub fn freedom(&self, vertex: u32) -> Freedom {
        if self.fixed[vertex as usize] {
            return Freedom::Fixed;
        }
        match self.features_at(vertex).count() {
            0 => Freedom::Free,
            2 => Freedom::Along,
            _ => Freedom::Fixed,
        }
    }

    /// Sets the first half-edge of a vertex, given any that leaves it.
    pub fn settle(&mut self, half: u32) {
        let vertex = self.origin(half) as usize;
        let mut first = half;
        loop {
            let twin = self.twins[first as usize];
            if twin == NONE {
                break;
            }
            first = next(twin);
            if first == half {
                break;
            }
        }
        self.first[vertex] = first;
    }

    /// Makes two half-edges twins, each of which may be none.
    pub fn join(&mut self, a: u32, b: u32) {
        for (half, twin) in [(a, b), (b, a)] {
            if half != NONE {
                self.twins[half as usize] = twin;
            }
        }
    }

    /// Adds a face without neighbours. Returns its first half-edge.
    pub fn add_face(&mut self, corners: [u32; 3]) -> u32 {
        self.faces.push(corners);
        self.twins.extend([NONE; 3]);
        self.features.extend([false; 3]);
        3 * (self.faces.len() as u32 - 1)
    }
}
