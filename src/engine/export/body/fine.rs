//! A finer mesh for pictures and files: each triangle is split in four, on a curved surface and with a smooth pattern.
//!
//! New positions by Phong tessellation (Boubekeur & Alexa, "Phong tessellation", SIGGRAPH Asia 2008), new values by cubics along the
//! edges.

use super::curved::slopes;
use super::vector::{Vector, dot, minus, plus, unit};
use crate::surface::{Mesh, edges};

/// Share of the distance to the tangent planes at the ends of an edge by which its new vertex moves: the paper's ¾.
const PHONG: f64 = 0.75;
/// The cosine between the normals of two neighbours below which the edge between them stays straight: 50°.
const SHARP: f64 = 0.64;

/// A mesh with its normals and patterns.
#[derive(Clone, Debug)]
pub struct Fine {
    /// The triangles.
    pub mesh: Mesh,
    /// Normals by vertex.
    pub normals: Vec<Vector>,
    /// The patterns by vertex, one a layer.
    pub patterns: Vec<Vec<f32>>,
}

impl Fine {
    /// This body with each triangle split in four.
    #[must_use]
    pub fn split(&self) -> Self {
        let (edges, sides) = edges(&self.mesh.faces);
        let mut fine = self.clone();
        for [a, b] in &edges {
            let [a, b] = [*a as usize, *b as usize];
            fine.normals.push(unit(plus(self.normals[a], 1.0, self.normals[b])));
            fine.mesh.positions.push(self.middle([a, b]));
        }
        for pattern in &mut fine.patterns {
            let slopes = slopes(&self.mesh, pattern);
            let middle = |[a, b]: &[u32; 2]| {
                let [a, b] = [*a as usize, *b as usize];
                let way = minus(self.mesh.positions[b], self.mesh.positions[a]);
                let bent = dot(slopes[a], way) - dot(slopes[b], way);
                let value = 0.5 * f64::from(pattern[a] + pattern[b]) + 0.125 * bent;
                value.clamp(0.0, 1.0) as f32
            };
            let middles: Vec<f32> = edges.iter().map(middle).collect();
            pattern.extend(middles);
        }
        let first = self.mesh.positions.len() as u32;
        let quarters = |([a, b, c], sides): (&[u32; 3], &[u32; 3])| {
            let [ab, bc, ca] = sides.map(|side| first + side);
            [[*a, ab, ca], [ab, *b, bc], [ca, bc, *c], [ab, bc, ca]]
        };
        fine.mesh.faces = self.mesh.faces.iter().zip(&sides).flat_map(quarters).collect();
        fine
    }

    /// The middle of an edge on the curved surface; halfway between its ends where the surface has a sharp edge.
    fn middle(&self, ends: [usize; 2]) -> Vector {
        let [a, b] = ends.map(|end| self.mesh.positions[end]);
        let half = plus(a, 0.5, minus(b, a));
        if dot(self.normals[ends[0]], self.normals[ends[1]]) < SHARP {
            return half;
        }
        let lift = |end: usize| {
            let normal = self.normals[end];
            let height = dot(minus(half, self.mesh.positions[end]), normal);
            normal.map(|part| -height * part)
        };
        let [up, there] = ends.map(lift);
        plus(plus(half, 0.5 * PHONG, up), 0.5 * PHONG, there)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An octahedron of radius 1, with a value by place.
    fn octahedron(value: fn(Vector) -> f64) -> Fine {
        let positions = vec![
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ];
        let faces =
            vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        let patterns = vec![positions.iter().map(|at| value(*at) as f32).collect()];
        Fine { normals: positions.clone(), patterns, mesh: Mesh { positions, faces } }
    }

    #[test]
    fn splitting_makes_four_triangles_of_one_and_keeps_the_vertices() {
        let coarse = octahedron(|_| 0.5);
        let fine = coarse.split();
        assert_eq!((fine.mesh.faces.len(), fine.mesh.positions.len()), (32, 18));
        assert_eq!(fine.mesh.positions[..6], coarse.mesh.positions[..]);
        assert!(fine.patterns[0].iter().all(|value| *value == 0.5));
    }

    #[test]
    fn a_sphere_that_is_split_becomes_rounder() {
        // Normals of an octahedron are at right angles: split without bending first.
        let mut sphere = octahedron(|_| 0.0).split();
        for position in &mut sphere.mesh.positions {
            *position = unit(*position);
        }
        sphere.normals = sphere.mesh.positions.clone();
        let volume = |mesh: &Mesh| mesh.volume();
        let flat = volume(&sphere.mesh);
        let fine = volume(&sphere.split().mesh);
        let exact = 4.0 / 3.0 * std::f64::consts::PI;
        assert!(exact - fine < 0.75 * (exact - flat) && fine < exact, "{flat} {fine} {exact}");
    }

    #[test]
    fn a_pattern_between_vertices_follows_its_slopes() {
        // On a plate, a quadratic: cubics along the edges are exact where the gradients are.
        let square = |x: f64| x * x / 100.0;
        let n = 9;
        let positions: Vec<Vector> = (0..n * n).map(|i| [f64::from(i % n), f64::from(i / n), 0.0]).collect();
        let corner = |x: i32, y: i32| (y * n + x) as u32;
        let cells = (0..n - 1).flat_map(|y| (0..n - 1).map(move |x| (x, y)));
        let faces = cells.flat_map(|(x, y)| {
            let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            [[a, b, c], [a, c, d]]
        });
        let mesh = Mesh { faces: faces.collect(), positions };
        let patterns = vec![mesh.positions.iter().map(|[x, _, _]| square(*x) as f32).collect()];
        let coarse = Fine { normals: vec![[0.0, 0.0, 1.0]; mesh.positions.len()], patterns, mesh };
        let fine = coarse.split();
        let inner = fine
            .mesh
            .positions
            .iter()
            .zip(&fine.patterns[0])
            .filter(|([x, y, _], _)| [x, y].iter().all(|c| **c > 1.6 && **c < f64::from(n) - 2.6));
        for ([x, _, _], value) in inner {
            assert!((f64::from(*value) - square(*x)).abs() < 2e-4, "{x}: {value}");
        }
    }
}
