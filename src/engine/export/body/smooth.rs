//! Values between the vertices of a mesh, on smooth curves.

use super::curved::{Cubic, slopes};
use super::vector::Vector;
use crate::surface::Mesh;

/// Values by vertex that can be read between these.
#[derive(Clone, Debug)]
pub struct Smooth<'a> {
    mesh: &'a Mesh,
    values: &'a [f32],
    slopes: Vec<Vector>,
}

impl<'a> Smooth<'a> {
    /// The values of a mesh, one a vertex.
    #[must_use]
    pub fn new(mesh: &'a Mesh, values: &'a [f32]) -> Self {
        Self { mesh, values, slopes: slopes(mesh, values) }
    }

    /// The value at a place of a face, given by the shares of its corners.
    #[must_use]
    pub fn at(&self, face: usize, shares: [f64; 3]) -> f32 {
        let corners = self.mesh.faces[face].map(|vertex| vertex as usize);
        let places = corners.map(|vertex| self.mesh.positions[vertex]);
        let values = corners.map(|vertex| self.values[vertex]);
        Cubic::new(places, values, corners.map(|vertex| self.slopes[vertex]))
            .at(shares.map(|share| share as f32))
    }
}
