//! Directions of edges in the frames of their vertices.
//!
//! Around a vertex the angles of the faces are scaled so that they add up to 360°: its tangent plane (E. Praun et al., "Lapped
//! textures", 2000; F. Knöppel et al., "Globally optimal direction fields", 2013). Points near a vertex have a position in it.

use std::f64::consts::TAU;

use super::adjacency::{Adjacency, NONE, next, previous};
use super::marching::Opposite;
use super::mesh::Mesh;
use super::vector::{Vector, cross, distance, dot, length, minus};

/// Data by half-edge; the corner of a half-edge is that of its face at the vertex that it leaves.
#[derive(Clone, Debug)]
pub struct Tangents {
    /// Lengths of half-edges.
    pub lengths: Vec<f64>,
    /// The other two corners of the face in the plane of the vertex that a half-edge leaves.
    pub corners: Vec<[[f64; 2]; 2]>,
    /// Angle of the half-edge in the frame of its vertex, radians.
    pub angles: Vec<f64>,
    /// By vertex: angle in the plane ÷ angle on the surface.
    pub scales: Vec<f64>,
    /// The faces around each vertex; those of one vertex are adjacent in memory.
    spokes: Vec<Spoke>,
    /// Start and number of the faces of each vertex.
    starts: Vec<u32>,
}

/// A face in the tangent plane of a vertex.
#[derive(Clone, Copy, Debug)]
pub struct Spoke {
    /// Its other two corners, counter-clockwise.
    pub ends: [u32; 2],
    /// The second of them, opposite to the side from the vertex to the first.
    pub second: Opposite,
    /// The first of them, opposite to the side from the second to the vertex.
    pub first: Opposite,
}

impl Tangents {
    pub fn new(mesh: &Mesh, adjacency: &Adjacency, frames: &[[Vector; 2]]) -> Self {
        let halves = adjacency.twins.len();
        let vertex = |half: u32| mesh.faces[half as usize / 3][half as usize % 3] as usize;
        let place = |half: u32| mesh.positions[vertex(half)];
        let lengths: Vec<f64> =
            (0..halves as u32).map(|half| distance(place(half), place(next(half)))).collect();
        let mut all = Self {
            lengths,
            corners: vec![[[0.0; 2]; 2]; halves],
            angles: vec![0.0; halves],
            scales: vec![1.0; frames.len()],
            spokes: Vec::with_capacity(halves),
            starts: vec![0],
        };
        for (vertex, axes) in frames.iter().enumerate() {
            let fan = || adjacency.fan(vertex);
            let edge = |half: u32| minus(place(next(half)), mesh.positions[vertex]);
            let angle = |half: u32| {
                let (a, b) = (edge(half), minus(place(previous(half)), mesh.positions[vertex]));
                libm::atan2(length(cross(a, b)), dot(a, b))
            };
            let total: f64 = fan().map(angle).sum();
            let is_round = !adjacency.is_on_border(vertex) && total > 0.0;
            let scale = if is_round { TAU / total } else { 1.0 };
            all.scales[vertex] = scale;
            // The frame is clockwise, the fan counter-clockwise. The angle of the first edge is chosen so that the mean direction
            // of all edges agrees with the frame.
            let (mut passed, mut mean) = (0.0, [0.0; 2]);
            for half in fan() {
                let seen = axes.map(|axis| dot(edge(half), axis));
                let (sin, cos) = libm::sincos(scale * passed);
                mean = [mean[0] + cos * seen[0] - sin * seen[1], mean[1] + sin * seen[0] + cos * seen[1]];
                passed += angle(half);
            }
            let start = libm::atan2(mean[1], mean[0]);
            let mut passed = 0.0;
            for half in fan() {
                let displacement = |angle: f64, length: f64| {
                    let (sin, cos) = libm::sincos(angle);
                    [length * cos, length * sin]
                };
                let index = half as usize;
                all.angles[index] = start - scale * passed;
                passed += angle(half);
                let ends = [all.angles[index], start - scale * passed];
                let along = [all.lengths[index], all.lengths[previous(half) as usize]];
                all.corners[index] = [displacement(ends[0], along[0]), displacement(ends[1], along[1])];
                let corner = |half: u32| mesh.faces[half as usize / 3][half as usize % 3];
                let far = all.lengths[next(half) as usize];
                all.spokes.push(Spoke {
                    ends: [corner(next(half)), corner(previous(half))],
                    second: Opposite::new(along[0], [along[1], far]),
                    first: Opposite::new(along[1], [far, along[0]]),
                });
            }
            all.starts.push(all.spokes.len() as u32);
        }
        all
    }

    /// The faces around a vertex, counter-clockwise.
    pub fn spokes(&self, vertex: u32) -> &[Spoke] {
        let [from, to] = [0, 1].map(|k| self.starts[vertex as usize + k] as usize);
        &self.spokes[from..to]
    }

    /// Angle to add to a direction in the frame of the vertex that a half-edge leaves, for its parallel transport to the frame of
    /// the vertex that the half-edge leads to.
    pub fn transport(&self, adjacency: &Adjacency, half: u32) -> f64 {
        let twin = adjacency.twins[half as usize];
        let back = if twin == NONE {
            // The corner at the other end has this edge as its second side.
            let [_, [x, y]] = self.corners[next(half) as usize];
            libm::atan2(y, x)
        } else {
            self.angles[twin as usize]
        };
        back + 0.5 * TAU - self.angles[half as usize]
    }
}
