//! A triangle surface to grow on: its vertices are cells, with normals, frames, and places between them.

use super::adjacency::{Adjacency, NONE, next, previous};
use super::block_boxes::BlockBoxes;
use super::bounding_tree::BoundingTree;
use super::mesh::Mesh;
use super::point::SurfacePoint;
use super::tangent::Tangents;
use super::vector::{Vector, across, axis_beside, cross, distance, dot, length, minus, plus, times, unit};

/// A mesh with the data that a growth on it needs. Lengths are those of the mesh.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Its triangles; neighbours should be close in memory, as they are after [`remesh`](super::remesh()).
    pub mesh: Mesh,
    pub(super) adjacency: Adjacency,
    pub(super) tangents: Tangents,
    normals: Vec<Vector>,
    frames: Vec<[Vector; 2]>,
    /// Area of each vertex's cell: a third of the faces around it.
    areas: Vec<f64>,
    along: Vector,
    unit: f64,
    tree: BoundingTree,
    pub(super) boxes: BlockBoxes,
}

impl Surface {
    /// The surface of a manifold, as [`remesh`](super::remesh()) and [`prepare`](super::prepare()) return it. The first axis of
    /// each frame is the projection of `along` onto the tangent plane; if that is 0, another axis.
    #[must_use]
    pub fn new(mesh: Mesh, along: [f64; 3]) -> Self {
        let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
        let mut areas = vec![0.0; mesh.positions.len()];
        for (face, corners) in mesh.faces.iter().enumerate() {
            let share = length(mesh.area_vector(face)) / 6.0;
            corners.iter().for_each(|vertex| areas[*vertex as usize] += share);
        }
        let normals: Vec<Vector> =
            (0..mesh.positions.len()).map(|vertex| normal_at(&mesh, &adjacency, vertex)).collect();
        let frames: Vec<[Vector; 2]> = normals.iter().map(|normal| frame(*normal, along)).collect();
        let area: f64 = areas.iter().sum();
        let side = (area / areas.len().max(1) as f64).sqrt();
        Self {
            tangents: Tangents::new(&mesh, &adjacency, &frames),
            tree: BoundingTree::new((0..mesh.faces.len()).map(|face| mesh.corners(face))),
            boxes: BlockBoxes::new(&mesh.positions),
            unit: if side > 0.0 { side } else { 1.0 },
            mesh,
            adjacency,
            normals,
            frames,
            areas,
            along: unit(along).unwrap_or([0.0; 3]),
        }
    }

    /// The side of a square of a mean cell's area: the unit of length of [`crate::grid::Domain`].
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// The unit vector outwards at a vertex.
    #[must_use]
    pub fn normal(&self, vertex: usize) -> [f64; 3] {
        self.normals[vertex]
    }

    /// The axes of the frame of a vertex: the second is the first rotated by 90°, clockwise seen from outside, as y to x on a
    /// canvas.
    #[must_use]
    pub fn frame(&self, vertex: usize) -> [[f64; 3]; 2] {
        self.frames[vertex]
    }

    /// The frames of all vertices.
    #[must_use]
    pub fn frames(&self) -> &[[[f64; 3]; 2]] {
        &self.frames
    }

    /// The squared length of the projection of the direction `along` onto the tangent plane of a vertex, 0..1.
    pub(super) fn along_share(&self, vertex: usize) -> f64 {
        let projected = across(self.along, self.normals[vertex]);
        dot(projected, projected)
    }

    /// The area of a vertex's cell.
    #[must_use]
    pub fn cell_area(&self, vertex: usize) -> f64 {
        self.areas[vertex]
    }

    /// The nearest place of the surface; its first corner if there is no face.
    #[must_use]
    pub fn closest(&self, point: [f64; 3]) -> SurfacePoint {
        let found = self.tree.nearest(point, |_| true);
        found.map_or(SurfacePoint { face: 0, weights: [1.0, 0.0] }, |found| {
            SurfacePoint::new(found.triangle, found.weights)
        })
    }

    /// The nearest place whose normal is less than 90° from this one: not the back of a thin sheet.
    #[must_use]
    pub fn closest_facing(&self, point: [f64; 3], normal: [f64; 3]) -> SurfacePoint {
        let is_fit = |face: u32| dot(self.mesh.area_vector(face as usize), normal) > 0.0;
        let found = self.tree.nearest(point, is_fit);
        found.map_or_else(|| self.closest(point), |found| SurfacePoint::new(found.triangle, found.weights))
    }

    /// The position of a place.
    #[must_use]
    pub fn position(&self, place: SurfacePoint) -> [f64; 3] {
        let corners = self.mesh.corners(place.face as usize);
        let [a, b, c] = place.shares();
        plus(plus(times(corners[0], a), times(corners[1], b)), times(corners[2], c))
    }

    /// The value at a place, interpolated between those of the corners.
    #[must_use]
    pub fn interpolate(&self, place: SurfacePoint, value: impl Fn(usize) -> f64) -> f64 {
        let corners = self.mesh.faces[place.face as usize];
        corners.iter().zip(place.shares()).map(|(vertex, share)| share * value(*vertex as usize)).sum()
    }

    /// The place at a vertex.
    #[must_use]
    pub fn place_of(&self, vertex: usize) -> SurfacePoint {
        let half = self.adjacency.first[vertex];
        if half == NONE {
            return SurfacePoint { face: 0, weights: [1.0, 0.0] };
        }
        let weights = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]][half as usize % 3];
        SurfacePoint { face: half / 3, weights }
    }

    /// The vertex with the largest barycentric coordinate at a place.
    #[must_use]
    pub fn vertex_of(&self, place: SurfacePoint) -> usize {
        self.mesh.faces[place.face as usize][place.corner()] as usize
    }

    /// Whether a vertex lies on a border.
    #[must_use]
    pub fn is_on_border(&self, vertex: usize) -> bool {
        self.adjacency.is_on_border(vertex)
    }

    /// The vertices adjacent to a vertex, counter-clockwise.
    pub fn ring(&self, vertex: usize) -> impl Iterator<Item = usize> {
        let origin = |half: u32| self.mesh.faces[half as usize / 3][half as usize % 3] as usize;
        let last = if self.is_on_border(vertex) { self.adjacency.fan(vertex).last() } else { None };
        let along = self.adjacency.fan(vertex).map(move |half| origin(next(half)));
        along.chain(last.map(move |half| origin(previous(half))))
    }

    /// The vertices adjacent to a vertex, with their positions in its tangent plane, in its frame.
    pub fn tangent_ring(&self, vertex: usize) -> impl Iterator<Item = (usize, [f64; 2])> {
        let origin = |half: u32| self.mesh.faces[half as usize / 3][half as usize % 3] as usize;
        let corners = |half: u32| self.tangents.corners[half as usize];
        let last = if self.is_on_border(vertex) { self.adjacency.fan(vertex).last() } else { None };
        let along = self.adjacency.fan(vertex).map(move |half| (origin(next(half)), corners(half)[0]));
        along.chain(last.map(move |half| (origin(previous(half)), corners(half)[1])))
    }

    /// The displacements from the two ends of a side of a face to each other, each in the frame of its end. Side k begins at corner
    /// k.
    #[must_use]
    pub fn side_ways(&self, face: usize, side: usize) -> [[f64; 2]; 2] {
        let half = (3 * face + side) as u32;
        [self.tangents.corners[half as usize][0], self.tangents.corners[next(half) as usize][1]]
    }
}

/// The normal at a vertex, exact on spheres.
///
/// N. Max, "Weights for computing vertex normals from facet normals", Journal of Graphics Tools 4 (1999).
fn normal_at(mesh: &Mesh, adjacency: &Adjacency, vertex: usize) -> Vector {
    let here = mesh.positions[vertex];
    let (mut sum, mut by_area) = ([0.0; 3], [0.0; 3]);
    for half in adjacency.fan(vertex) {
        let face = mesh.faces[half as usize / 3];
        let corner = |half: u32| minus(mesh.positions[face[half as usize % 3] as usize], here);
        let (a, b) = (corner(next(half)), corner(previous(half)));
        let area = cross(a, b);
        by_area = plus(by_area, area);
        sum = plus(sum, times(area, 1.0 / (dot(a, a) * dot(b, b)).max(f64::MIN_POSITIVE)));
    }
    unit(sum).or_else(|| unit(by_area)).unwrap_or([0.0, 0.0, 1.0])
}

/// The axes at a normal. If `along` is within a thousandth of it, its projection has no reliable direction.
fn frame(normal: Vector, along: Vector) -> [Vector; 2] {
    let length_along = length(along);
    let projected = across(along, normal);
    let is_sure = distance(projected, [0.0; 3]) > 1e-3 * length_along;
    let first = if is_sure { unit(projected) } else { None };
    let first = first.or_else(|| unit(across(axis_beside(normal), normal))).unwrap_or([1.0, 0.0, 0.0]);
    [first, cross(first, normal)]
}
