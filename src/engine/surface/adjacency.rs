//! Adjacency of triangles.
//!
//! The half-edge 3 · f + k runs from corner k of face f to the next corner; the face lies to its left. The two half-edges
//! of an edge between two faces are twins. The half-edges that leave a vertex form its fan, counter-clockwise.

/// No half-edge: there is a border.
pub const NONE: u32 = u32::MAX;

/// The half-edge after this one in its face.
pub fn next(half: u32) -> u32 {
    if half % 3 == 2 { half - 2 } else { half + 1 }
}

/// The half-edge before this one in its face.
pub fn previous(half: u32) -> u32 {
    if half.is_multiple_of(3) { half + 2 } else { half - 1 }
}

/// Neighbourhood of the faces of a manifold.
#[derive(Clone, Debug)]
pub struct Adjacency {
    /// By half-edge: the other half-edge of its edge, or [`NONE`].
    pub twins: Vec<u32>,
    /// By vertex: the first half-edge of its fan, which has no twin if the vertex is on a border; [`NONE`] for a vertex without
    /// faces.
    pub first: Vec<u32>,
}

impl Adjacency {
    /// The adjacency of these faces between this number of vertices. If an edge has more than two faces, only two are joined.
    pub fn new(vertices: usize, faces: &[[u32; 3]]) -> Self {
        let origin = |half: u32| faces[half as usize / 3][half as usize % 3];
        let halves = 0..3 * faces.len() as u32;
        let mut sorted: Vec<(u32, u32, u32)> = halves
            .clone()
            .map(|half| {
                let (from, to) = (origin(half), origin(next(half)));
                (from.min(to), from.max(to), half)
            })
            .collect();
        sorted.sort_unstable();
        let mut twins = vec![NONE; 3 * faces.len()];
        let mut at = 0;
        while at + 1 < sorted.len() {
            let [(a, b, half), (c, d, other)] = [sorted[at], sorted[at + 1]];
            if (a, b) == (c, d) && origin(half) != origin(other) {
                (twins[half as usize], twins[other as usize]) = (other, half);
                at += 2;
            } else {
                at += 1;
            }
        }
        let mut first = vec![NONE; vertices];
        for half in halves {
            let first = &mut first[origin(half) as usize];
            if *first == NONE || twins[half as usize] == NONE {
                *first = half;
            }
        }
        Self { twins, first }
    }

    /// The next half-edge that leaves the same vertex, counter-clockwise; [`NONE`] at a border.
    pub fn turned(&self, half: u32) -> u32 {
        self.twins[previous(half) as usize]
    }

    /// The half-edges that leave a vertex, counter-clockwise. Each has a face on its left.
    pub fn fan(&self, vertex: usize) -> impl Iterator<Item = u32> {
        let first = self.first[vertex];
        let mut half = first;
        std::iter::from_fn(move || {
            let found = half;
            if found == NONE {
                return None;
            }
            half = self.turned(found);
            if half == first {
                half = NONE;
            }
            Some(found)
        })
    }

    /// Whether a vertex lies on a border.
    pub fn is_on_border(&self, vertex: usize) -> bool {
        let first = self.first[vertex];
        first == NONE || self.twins[first as usize] == NONE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::{cube, plate};

    #[test]
    fn fans_of_a_closed_mesh_go_round_and_those_on_a_border_from_side_to_side() {
        let mesh = cube(4, 1.0);
        let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
        assert!(adjacency.twins.iter().all(|twin| *twin != NONE));
        let fans: usize = (0..mesh.positions.len()).map(|vertex| adjacency.fan(vertex).count()).sum();
        assert_eq!(fans, 3 * mesh.faces.len());
        let mesh = plate([5, 4], 1.0);
        let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
        let fans: usize = (0..mesh.positions.len()).map(|vertex| adjacency.fan(vertex).count()).sum();
        assert_eq!(fans, 3 * mesh.faces.len());
        let border = (0..mesh.positions.len()).filter(|vertex| adjacency.is_on_border(*vertex)).count();
        assert_eq!(border, 2 * (5 + 4));
    }
}
