//! Distances of places from an open border.

use super::geodesic;
use super::point::SurfacePoint;
use super::triangle_surface::Surface;

/// Distance of each vertex to the border.
pub struct Border {
    depths: Vec<f64>,
}

impl Border {
    /// The border of a surface; `None` if it has none.
    pub fn new(surface: &Surface) -> Option<Self> {
        let cells = 0..surface.mesh.positions.len();
        let on_border = cells.filter(|vertex| surface.is_on_border(*vertex)).map(|vertex| (vertex, 0.0));
        let depths = geodesic::spread(surface, on_border);
        // A part without a border is infinitely far from every border.
        depths.iter().any(|depth| depth.is_finite()).then_some(Self { depths })
    }

    /// Twice the shortest displacement to the border, which leads to the mirror image of a place, in the frame of the place. `None`
    /// if it is longer than `reach` or cannot be followed. For a place on the border it has the length `least`.
    pub fn image(&self, surface: &Surface, place: SurfacePoint, reach: f64, least: f64) -> Option<[f64; 2]> {
        let depth = surface.interpolate(place, |vertex| self.depths[vertex]);
        if depth.is_nan() || 2.0 * depth > reach {
            return None;
        }
        let corner = place.corner();
        let vertices = surface.mesh.faces[place.face as usize];
        let depth_at = |k: usize| self.depths[vertices[(corner + k) % 3] as usize];
        let [[ax, ay], [bx, by]] = surface.tangents.corners[3 * place.face as usize + corner];
        let (a, b) = (depth_at(1) - depth_at(0), depth_at(2) - depth_at(0));
        // The gradient g satisfies g · displacement = difference for both corners.
        let area = ax * by - ay * bx;
        let inward = [a * by - b * ay, b * ax - a * bx].map(|part| part / area);
        let steep = (inward[0] * inward[0] + inward[1] * inward[1]).sqrt();
        let far = (2.0 * depth).max(least);
        (steep > 0.0 && steep.is_finite()).then(|| inward.map(|part| -far * part / steep))
    }
}
