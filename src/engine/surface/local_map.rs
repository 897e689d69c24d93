//! The surface about a place, mapped to its tangent plane: distances and directions of vertices.
//!
//! R. Schmidt, C. Grimm, B. Wyvill, "Interactive decal compositing with discrete exponential maps", SIGGRAPH 2006. Distances are
//! propagated from face to face (see [`super::marching`]), so that no vertex is reached through the body or across to another part.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::marching::{Opposite, Reached};
use super::point::SurfacePoint;
use super::tangent::Spoke;
use super::triangle_surface::Surface;

/// Vertices about a place, nearest first, with the displacements to them in the frame of the place; lengths are those of the mesh.
#[derive(Clone, Debug)]
pub struct LocalMap {
    /// The vertices in the order in which they were met.
    seen: Vec<Seen>,
    /// Index in `seen` of a vertex, plus 1: open addressing.
    slots: Vec<u32>,
    /// Vertices whose distance is final, nearest first.
    order: Vec<u32>,
    /// Vertices whose distance may still decrease, by the bits of their distances; for some a shorter distance is already known.
    front: BinaryHeap<Reverse<(u64, u32)>>,
}

#[derive(Clone, Copy, Debug)]
struct Seen {
    vertex: u32,
    is_known: bool,
    distance: f64,
    displacement: [f64; 2],
}

/// Slots of a new map. Not tuned.
const SLOTS: usize = 512;

impl LocalMap {
    /// All vertices within `reach`, until one for which `is_last` holds has been reached.
    pub fn new(
        surface: &Surface,
        place: SurfacePoint,
        reach: f64,
        mut is_last: impl FnMut(u32) -> bool,
    ) -> Self {
        let mut map = Self::about(surface, place);
        while let Some(vertex) = map.advance(surface, reach) {
            if is_last(vertex) {
                break;
            }
        }
        map
    }

    /// A map of the cell of a place and of the cells around it, whose positions in its tangent plane are known.
    pub fn about(surface: &Surface, place: SurfacePoint) -> Self {
        let mut map = Self {
            seen: Vec::with_capacity(SLOTS / 2),
            slots: vec![0; SLOTS],
            order: Vec::with_capacity(SLOTS / 2),
            front: BinaryHeap::with_capacity(SLOTS / 4),
        };
        let (cell, from) = surface.offset(place);
        let ring = surface.tangent_ring(cell);
        for (vertex, at) in std::iter::once((cell, [0.0; 2])).chain(ring) {
            let displacement = [at[0] - from[0], at[1] - from[1]];
            let distance = (displacement[0] * displacement[0] + displacement[1] * displacement[1]).sqrt();
            if map.index(vertex as u32).is_none() {
                map.add(Seen { vertex: vertex as u32, is_known: true, distance, displacement });
                map.front.push(Reverse((distance.to_bits(), map.seen.len() as u32 - 1)));
            }
        }
        map
    }

    /// Reaches the next vertex, and returns it; `None` if none is left within `reach`.
    pub fn advance(&mut self, surface: &Surface, reach: f64) -> Option<u32> {
        loop {
            let Reverse((bits, index)) = *self.front.peek()?;
            let Seen { vertex, distance, .. } = self.seen[index as usize];
            if distance > reach && distance.to_bits() == bits {
                return None;
            }
            self.front.pop();
            // Others have been reached by a shorter way in the meantime.
            if distance.to_bits() == bits {
                self.seen[index as usize].is_known = true;
                self.order.push(index);
                self.spread(surface, index);
                return Some(vertex);
            }
        }
    }

    /// Propagates distances from a final vertex to its neighbours that are not final, through the faces with another final vertex.
    fn spread(&mut self, surface: &Surface, index: u32) {
        let vertex = self.seen[index as usize].vertex;
        // The second corner of a face is the first of the next.
        let mut shared: Option<(u32, Option<u32>)> = None;
        for Spoke { ends, first, second } in surface.tangents.spokes(vertex) {
            let found = match shared {
                Some((vertex, found)) if vertex == ends[0] => [found, self.index(ends[1])],
                _ => ends.map(|vertex| self.index(vertex)),
            };
            let is_known = |found: Option<u32>| found.filter(|found| self.seen[*found as usize].is_known);
            let mut last = found[1];
            match found.map(is_known) {
                [Some(other), None] => last = self.reach([index, other], second, ends[1], found[1]),
                [None, Some(other)] => {
                    self.reach([other, index], first, ends[0], found[0]);
                }
                _ => {}
            }
            shared = Some((ends[1], last));
        }
    }

    /// Updates the corner opposite to the side between two final ones if the new distance is shorter. Returns its index in `seen`.
    fn reach(
        &mut self,
        known: [u32; 2],
        opposite: &Opposite,
        vertex: u32,
        found: Option<u32>,
    ) -> Option<u32> {
        let [a, b] = known.map(|known| &self.seen[known as usize]);
        let Reached { distance, share } = opposite.reached([a.distance, b.distance]);
        if found.is_some_and(|found| self.seen[found as usize].distance <= distance) {
            return found;
        }
        let displacement = direction([a, b], opposite.side, share).map(|part| part * distance);
        let seen = Seen { vertex, is_known: false, distance, displacement };
        let index = match found {
            Some(found) => {
                self.seen[found as usize] = seen;
                found
            }
            None => self.add(seen),
        };
        self.front.push(Reverse((distance.to_bits(), index)));
        Some(index)
    }

    fn slot(&self, vertex: u32) -> usize {
        let mask = self.slots.len() - 1;
        let mut slot = (vertex.wrapping_mul(0x9e37_79b1) >> 8) as usize & mask;
        while self.slots[slot] != 0 && self.seen[self.slots[slot] as usize - 1].vertex != vertex {
            slot = (slot + 1) & mask;
        }
        slot
    }

    /// The index of a vertex in `seen`.
    fn index(&self, vertex: u32) -> Option<u32> {
        self.slots[self.slot(vertex)].checked_sub(1)
    }

    fn add(&mut self, seen: Seen) -> u32 {
        self.seen.push(seen);
        let slot = self.slot(seen.vertex);
        self.slots[slot] = self.seen.len() as u32;
        if 2 * self.seen.len() > self.slots.len() {
            self.slots = vec![0; 4 * self.slots.len()];
            for index in 0..self.seen.len() {
                let slot = self.slot(self.seen[index].vertex);
                self.slots[slot] = index as u32 + 1;
            }
        }
        self.seen.len() as u32 - 1
    }

    /// Number of vertices that were reached.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Whether no vertex was reached.
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// The vertex that was reached as number `number`, and its distance.
    pub fn reached(&self, number: usize) -> (usize, f64) {
        let Seen { vertex, distance, .. } = self.seen[self.order[number] as usize];
        (vertex as usize, distance)
    }

    /// The vertices that were reached, with the displacements to them, nearest first.
    pub fn vertices(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        self.order.iter().map(|index| {
            let Seen { vertex, displacement, .. } = self.seen[*index as usize];
            (vertex as usize, displacement)
        })
    }

    /// The displacement to a vertex; `None` if it was not reached.
    pub fn way_to_vertex(&self, vertex: u32) -> Option<[f64; 2]> {
        self.index(vertex).map(|index| self.seen[index as usize].displacement)
    }

    /// The displacement to a place; `None` if no corner of its face was reached. If not all were, it is the displacement to its
    /// cell.
    pub fn displacement(&self, surface: &Surface, place: SurfacePoint) -> Option<[f64; 2]> {
        let corners = surface.mesh.faces[place.face as usize].map(|vertex| self.way_to_vertex(vertex));
        let shares = place.shares();
        let mut sum = [0.0; 2];
        for (corner, share) in corners.iter().zip(shares) {
            match corner {
                Some([x, y]) => sum = [sum[0] + share * x, sum[1] + share * y],
                None if share == 0.0 => {}
                None => return corners[place.corner()],
            }
        }
        Some(sum)
    }
}

/// The direction, of length 1, of points behind this share of the side between two vertices; `side` is its length.
fn direction([a, b]: [&Seen; 2], side: f64, share: f64) -> [f64; 2] {
    // Two vertices on opposite sides of the place were reached around the body: points between them are reached past one of them.
    let is_round = a.displacement[0] * b.displacement[0] + a.displacement[1] * b.displacement[1] < 0.0
        && a.distance.min(b.distance) > side;
    let share = match is_round {
        false => share,
        true if b.distance < a.distance => 1.0,
        true => 0.0,
    };
    let displacement = [0, 1].map(|axis| (1.0 - share) * a.displacement[axis] + share * b.displacement[axis]);
    let length = (displacement[0] * displacement[0] + displacement[1] * displacement[1]).sqrt();
    if length > 0.0 { displacement.map(|part| part / length) } else { [1.0, 0.0] }
}

impl Surface {
    /// The cell of a place, and the position of the place in the tangent plane of the cell.
    pub(super) fn offset(&self, place: SurfacePoint) -> (usize, [f64; 2]) {
        let corner = place.corner();
        let half = 3 * place.face as usize + corner;
        let shares = place.shares();
        let [first, second] = self.tangents.corners[half];
        let [a, b] = [1, 2].map(|k| shares[(corner + k) % 3]);
        let at = [0, 1].map(|axis| a * first[axis] + b * second[axis]);
        (self.mesh.faces[place.face as usize][corner] as usize, at)
    }
}
