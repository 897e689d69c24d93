//! The distance by which the colours of a finish may move along a surface, so that marks keep their area and their number; on a
//! canvas it is [`crate::finish::Reach`].

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::finish::reach::SHARE;
use crate::surface::vector::{Vector, distance, middle};
use crate::surface::{Surface, SurfacePoint};

/// A distance that is farther than any that is asked for.
const FAR: f32 = 1e9;
/// A neighbour's disc nearly holds that of a vertex if its radius is larger by this share of their distance.
const RISE: f32 = 0.85;

/// Thickness and distance to the nearest edge at each vertex, px.
#[derive(Clone, Debug)]
pub(super) struct SurfaceReach {
    distance: Vec<f32>,
    /// Local radius of the thinner side of the nearest edge.
    radius: Vec<f32>,
}

impl SurfaceReach {
    /// The reach for the `labels` of the vertices; radii above `most` px count as that.
    pub fn of(surface: &Surface, labels: &[u8], most: f32) -> Self {
        let edges = Edges::new(surface, labels, most);
        let thick = thickness(surface, &edges.distance, most);
        let of_vertex = |vertex: usize| match edges.nearest[vertex] {
            None => most,
            Some([a, b]) => {
                let other = if labels[a as usize] == labels[vertex] { b } else { a };
                thick[vertex].min(thick[other as usize])
            }
        };
        let radius = (0..labels.len()).map(of_vertex).collect();
        Self { distance: edges.distance, radius }
    }

    /// Whether a place is at most `most` px from the edge of a mark.
    pub fn is_near(&self, surface: &Surface, point: SurfacePoint, most: f32) -> bool {
        self.distance[surface.vertex_of(point)] <= most
    }

    /// By how many px the colour at a place may move, if it is wanted to move by at most `wanted` px.
    pub fn at(&self, surface: &Surface, point: SurfacePoint, wanted: f32) -> f32 {
        let distance = surface.interpolate(point, |vertex| f64::from(self.distance[vertex])) as f32;
        if distance > wanted { wanted } else { wanted.min(SHARE * self.radius[surface.vertex_of(point)]) }
    }
}

/// The nearest edge between two labels: its distance from each vertex, and the two vertices that it parts.
struct Edges {
    distance: Vec<f32>,
    nearest: Vec<Option<[u32; 2]>>,
}

impl Edges {
    /// Distances up to `most` px, in a straight line to the edges that are found from vertex to vertex.
    fn new(surface: &Surface, labels: &[u8], most: f32) -> Self {
        let count = labels.len();
        let place = |vertex: u32| surface.mesh.positions[vertex as usize];
        let mut found = Self { distance: vec![FAR; count], nearest: vec![None; count] };
        let mut heap: BinaryHeap<Reverse<(u32, u32)>> = BinaryHeap::new();
        let offer = |found: &mut Self, heap: &mut BinaryHeap<_>, vertex: usize, [a, b]: [u32; 2]| {
            let edge: Vector = middle(place(a), place(b));
            let far = distance(edge, surface.mesh.positions[vertex]) as f32;
            if far < found.distance[vertex] && far <= most {
                found.distance[vertex] = far;
                found.nearest[vertex] = Some([a, b]);
                heap.push(Reverse((far.to_bits(), vertex as u32)));
            }
        };
        for vertex in 0..count {
            for other in surface.ring(vertex).filter(|other| labels[*other] != labels[vertex]) {
                offer(&mut found, &mut heap, vertex, [vertex as u32, other as u32]);
            }
        }
        while let Some(Reverse((bits, vertex))) = heap.pop() {
            let vertex = vertex as usize;
            let (true, Some(edge)) = (found.distance[vertex].to_bits() == bits, found.nearest[vertex]) else {
                continue;
            };
            for other in surface.ring(vertex).filter(|other| labels[*other] == labels[vertex]) {
                offer(&mut found, &mut heap, other, edge);
            }
        }
        found
    }
}

/// Local thickness by the discs around the middle lines, where no neighbour has a disc that holds that of the vertex.
fn thickness(surface: &Surface, far: &[f32], most: f32) -> Vec<f32> {
    let places = &surface.mesh.positions;
    let apart = |a: usize, b: usize| distance(places[a], places[b]) as f32;
    let mut thick: Vec<f32> = far.iter().map(|distance| distance.min(most)).collect();
    let mut stamps = vec![u32::MAX; far.len()];
    let mut around = Vec::new();
    for vertex in 0..far.len() {
        let radius = far[vertex].min(most);
        let is_ridge = surface.ring(vertex).all(|near| far[near] < far[vertex] + RISE * apart(vertex, near));
        let is_inside = radius >= most && surface.ring(vertex).all(|near| far[near] >= most);
        // Within a wide place all discs have the radius `most`: those at its border are enough.
        if (radius < most && !is_ridge) || is_inside {
            continue;
        }
        around.clear();
        around.push(vertex);
        stamps[vertex] = vertex as u32;
        let mut next = 0;
        while let Some(at) = around.get(next).copied() {
            next += 1;
            thick[at] = thick[at].max(radius);
            for other in surface.ring(at) {
                if std::mem::replace(&mut stamps[other], vertex as u32) != vertex as u32
                    && apart(vertex, other) <= radius
                {
                    around.push(other);
                }
            }
        }
    }
    thick
}
