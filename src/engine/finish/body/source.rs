//! The painted surface that gets a finish, and places on it.

use crate::surface::vector::{Vector, across, axis_beside, dot, length, plus, times, unit};
use crate::surface::{Surface, SurfacePoint};

/// How far outside of a place its neighbourhood is looked at, px, for slopes.
pub(super) const OUTSIDE: f64 = 0.61;

/// Colour and share of ink at a place: red, green, blue in the coding of sRGB, and 1 where a mark covers it, otherwise 0.
pub type Paint<'a> = Box<dyn Fn(SurfacePoint) -> [f32; 4] + Send + Sync + 'a>;

/// The painted surface that gets a finish. Lengths are px of the document.
pub struct SurfaceSource<'a> {
    /// The surface.
    pub surface: &'a Surface,
    /// Its colours.
    pub paint: Paint<'a>,
    /// For each vertex the layer whose mark covers it; 0 = none.
    pub labels: Vec<u8>,
    /// For each vertex the direction from head to tail, of length 1, in its tangent plane.
    pub flow: Vec<[f64; 3]>,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// A place on the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub point: SurfacePoint,
    pub at: Vector,
    /// Outwards, of length 1.
    pub normal: Vector,
}

impl SurfaceSource<'_> {
    pub(super) fn place(&self, point: SurfacePoint) -> Place {
        let mean = self.mean(point, |vertex| self.surface.normal(vertex));
        let flat = || unit(self.surface.mesh.area_vector(point.face as usize));
        let normal = unit(mean).or_else(flat).unwrap_or([0.0, 0.0, 1.0]);
        Place { point, at: self.surface.position(point), normal }
    }

    /// The direction from head to tail at a place.
    pub(super) fn flow_at(&self, place: &Place) -> Vector {
        let mean = self.mean(place.point, |vertex| self.flow[vertex]);
        let beside = || unit(across(axis_beside(place.normal), place.normal));
        unit(across(mean, place.normal)).or_else(beside).unwrap_or([1.0, 0.0, 0.0])
    }

    fn mean(&self, point: SurfacePoint, of: impl Fn(usize) -> Vector) -> Vector {
        let corners = self.surface.mesh.faces[point.face as usize];
        let all = corners.iter().zip(point.shares());
        all.fold([0.0; 3], |sum, (vertex, share)| plus(sum, times(of(*vertex as usize), share)))
    }

    /// The place on the surface to which a displacement leads straight on; its part off the tangent plane is not counted.
    pub(super) fn displaced(&self, from: SurfacePoint, by: Vector) -> SurfacePoint {
        let axes = self.surface.frame(self.surface.vertex_of(from));
        let [x, y] = axes.map(|axis| dot(by, axis));
        let (wanted, found) = (length(by), (x * x + y * y).sqrt());
        if found <= 1e-9 * wanted {
            from
        } else {
            self.surface.walk(from, [x, y].map(|part| part * wanted / found))
        }
    }
}

/// Whether a colour is that of a mark.
pub(super) fn is_ink(colour: [f32; 4]) -> bool {
    colour[3] >= 0.5
}

/// A vector in single precision.
pub(super) fn single(vector: Vector) -> [f32; 3] {
    vector.map(|part| part as f32)
}
