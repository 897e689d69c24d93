//! Fields of values by vertex, between the vertices: cubics with the slopes at the vertices.

use crate::export::body::curved::{Cubic, slopes};
use crate::export::body::vector::{Vector, plus};
use crate::surface::{Surface, SurfacePoint};

/// Fields of values by vertex of a surface.
pub struct Fields<'a> {
    surface: &'a Surface,
    all: Vec<Field>,
}

/// The values of a field by vertex, and how steep it is there.
struct Field {
    values: Vec<f32>,
    slopes: Vec<Vector>,
}

impl<'a> Fields<'a> {
    /// These fields.
    #[must_use]
    pub fn new(surface: &'a Surface, all: &[&[f32]]) -> Self {
        let field =
            |values: &&[f32]| Field { values: values.to_vec(), slopes: slopes(&surface.mesh, values) };
        Self { surface, all: all.iter().map(field).collect() }
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// The values of all fields at a place.
    #[must_use]
    pub fn values(&self, point: SurfacePoint) -> Vec<f32> {
        let vertices = self.vertices(point);
        let places = self.surface.mesh.corners(point.face as usize);
        let shares = point.shares().map(|share| share as f32);
        let value = |field: &Field| {
            let values = vertices.map(|vertex| field.values[vertex]);
            Cubic::new(places, values, vertices.map(|vertex| field.slopes[vertex])).at(shares)
        };
        self.all.iter().map(value).collect()
    }

    /// How steep all fields are at a place, a unit of length of the surface.
    #[must_use]
    pub fn slopes(&self, point: SurfacePoint) -> Vec<[f64; 3]> {
        let (vertices, shares) = (self.vertices(point), point.shares());
        let slope = |field: &Field| {
            (0..3).fold([0.0; 3], |sum, at| plus(sum, shares[at], field.slopes[vertices[at]]))
        };
        self.all.iter().map(slope).collect()
    }

    fn vertices(&self, point: SurfacePoint) -> [usize; 3] {
        self.surface.mesh.faces[point.face as usize].map(|vertex| vertex as usize)
    }
}
