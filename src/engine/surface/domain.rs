//! A surface as a domain: vertices are cells, and lengths are in units of a mean cell's side.

use std::ops::Range;

use super::buckets::SurfaceBuckets;
use super::geodesic;
use super::local_map::LocalMap;
use super::point::SurfacePoint;
use super::triangle_surface::Surface;
use super::vector::{dot, minus, plus, times};
use crate::grid::{Borderless, Buckets, Domain, Space, atan2};

/// Cells of a part that is handed to a thread. Not tuned.
const PART: usize = 1 << 11;

/// The displacement to unreachable places, on another part of the surface, units. Its square is still finite.
const NOWHERE: [f64; 2] = [1e100, 0.0];

/// Largest excess of the distance of one end of a side through which a vertex may be reached, units.
const BESIDE: f64 = 1.5;

/// Normals whose cosine is above this are aligned by the shortest rotation: 60°.
const NEARLY_FLAT: f64 = 0.5;

impl Surface {
    /// Angle to add to a direction in the frame of one vertex for its parallel transport along the shortest displacement to
    /// another, degrees.
    fn turn_along(&self, from: usize, to: usize) -> f64 {
        let [there, back] = [[from, to], [to, from]].map(|[from, to]| {
            let [x, y] = self.displacement(self.place_of(from), self.place_of(to));
            atan2(y, x)
        });
        (back + std::f64::consts::PI - there).to_degrees()
    }
}

impl Domain for Surface {
    type Place = SurfacePoint;

    fn cells(&self) -> usize {
        self.mesh.positions.len()
    }

    fn center(&self, cell: usize) -> SurfacePoint {
        self.place_of(cell)
    }

    fn cell_at(&self, place: SurfacePoint) -> usize {
        self.vertex_of(place)
    }

    fn area(&self, cell: usize) -> f64 {
        self.cell_area(cell) / (self.unit() * self.unit())
    }

    fn displacement(&self, from: SurfacePoint, to: SurfacePoint) -> [f64; 2] {
        if from == to {
            return [0.0; 2];
        }
        let mut missing = self.mesh.faces[to.face as usize].to_vec();
        let map = LocalMap::new(self, from, f64::INFINITY, |vertex| {
            missing.retain(|corner| *corner != vertex);
            missing.is_empty()
        });
        map.displacement(self, to).map_or(NOWHERE, |displacement| displacement.map(|part| part / self.unit()))
    }

    fn moved(&self, from: SurfacePoint, displacement: [f64; 2]) -> SurfacePoint {
        self.walk(from, displacement.map(|part| part * self.unit()))
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        if from == to {
            return 0.0;
        }
        let (normal, other) = (self.normal(from), self.normal(to));
        let cos = dot(normal, other);
        if cos < NEARLY_FLAT {
            return self.turn_along(from, to);
        }
        // The first axis, rotated as the normal is rotated.
        let [first, _] = self.frame(from);
        let turned = minus(first, times(plus(normal, other), dot(first, other) / (1.0 + cos)));
        let [x, y] = self.frame(to).map(|axis| dot(turned, axis));
        atan2(y, x).to_degrees()
    }

    fn facing(&self, from: usize, to: usize) -> f64 {
        dot(self.normal(from), self.normal(to))
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        self.ring(cell)
    }

    fn near(
        &self,
        place: SurfacePoint,
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> {
        let unit = self.unit();
        let map = LocalMap::new(self, place, (reach + BESIDE) * unit, |_| false);
        let found = map.vertices().filter(|(vertex, _)| among.contains(vertex));
        let found: Vec<(usize, [f64; 2])> =
            found.map(|(vertex, displacement)| (vertex, displacement.map(|part| part / unit))).collect();
        found.into_iter().filter(move |(_, [x, y])| x * x + y * y <= reach * reach)
    }

    fn may_reach(&self, place: SurfacePoint, reach: f64, among: &Range<usize>) -> bool {
        self.boxes.may_reach(self.position(place), reach * self.unit(), among)
    }

    fn distances(&self, set: &[bool]) -> Option<Vec<f64>> {
        let known = set.iter().enumerate().filter(|(_, set)| **set).map(|(vertex, _)| (vertex, 0.0));
        let distances = geodesic::spread(self, known);
        Some(distances.into_iter().map(|distance| distance / self.unit()).collect())
    }

    fn part(&self) -> usize {
        PART
    }

    fn place_in(&self, cell: usize, [u, v]: [f64; 2]) -> SurfacePoint {
        // A third of the area of one of the faces: the corner, the midpoints of its sides and the centre of the face.
        let weight = |half: u32| {
            let area = self.mesh.area_vector(half as usize / 3);
            dot(area, area).sqrt()
        };
        let total: f64 = self.adjacency.fan(cell).map(weight).sum();
        let mut left = u * total;
        let Some(mut own) = self.adjacency.fan(cell).next() else { return self.place_of(cell) };
        for half in self.adjacency.fan(cell) {
            own = half;
            if left < weight(half) {
                break;
            }
            left -= weight(half);
        }
        let along = (left / weight(own)).clamp(0.0, 1.0);
        // Two halves of equal area, one at each side of the corner.
        let (is_first, along) = if along < 0.5 { (true, 2.0 * along) } else { (false, 2.0 * along - 1.0) };
        let root = along.sqrt();
        let [a, b, c] = [1.0 - root, root * (1.0 - v), root * v];
        // a, b, c: the weights of the corner, the midpoint of a side, and the centre of the face.
        let mut shares = [a + 0.5 * b + c / 3.0, 0.5 * b + c / 3.0, c / 3.0];
        if !is_first {
            shares.swap(1, 2);
        }
        let mut placed = [0.0; 3];
        (0..3).for_each(|k| placed[(own as usize % 3 + k) % 3] = shares[k]);
        SurfacePoint::new(own / 3, placed)
    }

    fn space(&self, _: f64) -> impl Space<Place = SurfacePoint> {
        Borderless::new(self)
    }

    fn buckets(&self, _: f64) -> impl Buckets<Place = SurfacePoint> {
        SurfaceBuckets::new(self)
    }
}
