//! Spots on a triangle surface: the parts of it that lie above a threshold.

pub(super) mod level_set;
mod moments;

use std::f64::consts::PI;

use rayon::prelude::*;

use crate::grid::{Domain, UnionFind};
use crate::marks::{Ellipse, axial};
use crate::measure::spots::{SPECK_CELLS, SPECK_SHARE, usual_area};
use crate::surface::{LocalMap, Surface, SurfacePoint};
use level_set::{LevelSet, Piece};
use moments::PlaneMoments;

/// A connected part of a surface above a threshold. Lengths are those of the surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSpot {
    /// Its centre of mass, in its tangent plane.
    pub place: SurfacePoint,
    /// Its area on the surface.
    pub area: f64,
    /// Radii of the ellipse with its area and the aspect of its second moments, the larger first.
    pub radii: [f64; 2],
    /// Direction of the first radius, in the frame of the vertex that `place` lies at, 0..180.
    pub degrees: f64,
    /// Whether all of it was measured: it touches no open border.
    pub whole: bool,
    /// Area ÷ (π·r₁·r₂), where 2√λ are the radii of an ellipse of second moments λ: 1 for an ellipse, less for merged or bent marks.
    pub fill: f64,
    /// The highest value in it.
    pub peak: f32,
    /// The vertices in it.
    pub vertices: Vec<u32>,
}

impl SurfaceSpot {
    /// Minor ÷ major radius, 0..1.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        self.radii[1] / self.radii[0]
    }
}

/// Number of times that a spot is measured again from its new centre: not tuned.
const LOOKS: usize = 2;

/// The spots of `values` above `threshold`, both by vertex, in the order of their first vertices. Values between vertices are those
/// of a smooth surface, as on grids. Specks are left out as on grids: spots smaller than 2 cells, or than 5 % of the usual area.
#[must_use]
pub fn surface_spots(surface: &Surface, values: &[f32], threshold: &[f32]) -> Vec<SurfaceSpot> {
    let above: Vec<f64> = values
        .iter()
        .zip(threshold)
        .map(|(value, threshold)| f64::from(*value) - f64::from(*threshold))
        .collect();
    let level_set = LevelSet::new(surface, &above);
    let parts = parts(surface, &above, &level_set);
    let area = |part: &Part| part.pieces.iter().map(|piece| piece.area).sum::<f64>();
    let usual = usual_area(parts.iter().map(area));
    let least = (SPECK_SHARE * usual).max(SPECK_CELLS * surface.unit() * surface.unit());
    let spots: Vec<&Part> = parts.iter().filter(|part| area(part) >= least).collect();
    spots.into_par_iter().map(|part| part.spot(surface, &above, values)).collect()
}

/// A connected part.
#[derive(Clone, Debug, Default)]
struct Part {
    vertices: Vec<u32>,
    pieces: Vec<Piece>,
}

/// The connected parts: vertices above the threshold that share an edge, and the pieces of faces at them.
fn parts(surface: &Surface, above: &[f64], level_set: &LevelSet) -> Vec<Part> {
    let mut sets = UnionFind::new(above.len());
    let is_above = |vertex: u32| above[vertex as usize] > 0.0;
    for face in &surface.mesh.faces {
        for k in 0..3 {
            if is_above(face[k]) && is_above(face[(k + 1) % 3]) {
                sets.join(face[k], face[(k + 1) % 3], [0, 0]);
            }
        }
    }
    let mut index = vec![usize::MAX; above.len()];
    let mut parts: Vec<Part> = Vec::new();
    for vertex in (0..above.len() as u32).filter(|vertex| is_above(*vertex)) {
        let root = sets.find(vertex).0 as usize;
        if index[root] == usize::MAX {
            index[root] = parts.len();
            parts.push(Part::default());
        }
        index[vertex as usize] = index[root];
        parts[index[root]].vertices.push(vertex);
    }
    for (face, corners) in surface.mesh.faces.iter().enumerate() {
        // All corners above the threshold belong to one part.
        if let Some(corner) = corners.iter().find(|vertex| is_above(**vertex)) {
            parts[index[*corner as usize]].pieces.extend(level_set.pieces(surface, face));
        }
    }
    parts
}

impl Part {
    fn spot(&self, surface: &Surface, above: &[f64], values: &[f32]) -> SurfaceSpot {
        let height = |vertex: &&u32| above[**vertex as usize];
        let highest = self.vertices.iter().max_by(|a, b| height(a).total_cmp(&height(b)).then(b.cmp(a)));
        let highest = highest.copied().unwrap_or(0);
        let mut place = surface.center(highest as usize);
        let mut moments = self.moments(surface, place);
        for _ in 0..LOOKS {
            // Measured from the previous centre, in the frame there.
            place = surface.walk(place, moments.middle());
            moments = self.moments(surface, place);
        }
        let area: f64 = self.pieces.iter().map(|piece| piece.area).sum();
        let [xx, xy, yy] = moments.central();
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let apart = (half * half + xy * xy).sqrt();
        let (major, minor) = (mean + apart, (mean - apart).max(0.0));
        let aspect = if major > 0.0 { (minor / major).sqrt().clamp(1e-6, 1.0) } else { 1.0 };
        let degrees = axial(0.5 * libm::atan2(xy, half).to_degrees());
        let peak =
            self.vertices.iter().map(|vertex| values[*vertex as usize]).fold(f32::NEG_INFINITY, f32::max);
        SurfaceSpot {
            place,
            area,
            radii: Ellipse::from_area([0.0; 2], area, aspect, degrees).radii,
            degrees,
            whole: !self.vertices.iter().any(|vertex| surface.is_on_border(*vertex as usize)),
            fill: area / (4.0 * PI * (major * minor).sqrt()).max(f64::MIN_POSITIVE),
            peak,
            vertices: self.vertices.clone(),
        }
    }

    /// The moments of all pieces in the tangent plane of a place, in its frame.
    fn moments(&self, surface: &Surface, place: SurfacePoint) -> PlaneMoments {
        let mut missing: Vec<u32> =
            self.pieces.iter().flat_map(|piece| surface.mesh.faces[piece.face as usize]).collect();
        missing.sort_unstable();
        missing.dedup();
        let (corners, mut left) = (missing, 0);
        let map = LocalMap::new(surface, place, f64::INFINITY, |vertex| {
            left += usize::from(corners.binary_search(&vertex).is_ok());
            left == corners.len()
        });
        let mut moments = PlaneMoments::default();
        for piece in &self.pieces {
            let ways = surface.mesh.faces[piece.face as usize].map(|vertex| map.way_to_vertex(vertex));
            if let [Some(a), Some(b), Some(c)] = ways {
                let plane =
                    |shares: [f64; 3]| [0, 1].map(|k| shares[0] * a[k] + shares[1] * b[k] + shares[2] * c[k]);
                moments.add(piece.area, piece.corners.map(plane));
            }
        }
        moments
    }
}

#[cfg(test)]
mod tests;
