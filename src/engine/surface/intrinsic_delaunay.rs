//! Triangles that are given by the lengths of their edges alone, and the flips that make them Delaunay.
//!
//! Fisher, Springborn, Bobenko & Schröder, "An algorithm for the construction of intrinsic Delaunay triangulations with
//! applications to digital geometry processing" (2006). After the flips the cotangents opposite every inner edge have a sum ≥ 0.

use std::collections::VecDeque;

/// Index in place of the second triangle of an edge at the border.
const NONE: u32 = u32::MAX;
/// Largest number of flips per edge: lengths that do not form a metric might never reach an end.
const FLIPS_AN_EDGE: usize = 50;

/// Triangles by the lengths of their edges.
#[derive(Clone, Debug)]
pub struct Triangulation {
    /// The vertices of each triangle.
    pub corners: Vec<[u32; 3]>,
    /// The edges of each triangle: from corner k to corner k + 1.
    pub sides: Vec<[u32; 3]>,
    /// Lengths by edge.
    pub lengths: Vec<f64>,
    /// The one or two triangles of each edge.
    faces: Vec<[u32; 2]>,
}

/// The edges of triangles by their ends, the lower index first, in ascending order; and the edges of each triangle, from corner k
/// to corner k + 1.
pub fn edges(faces: &[[u32; 3]]) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
    let ends = |face: &[u32; 3], k: usize| {
        let (a, b) = (face[k], face[(k + 1) % 3]);
        [a.min(b), a.max(b)]
    };
    let mut edges: Vec<[u32; 2]> = faces.iter().flat_map(|face| [0, 1, 2].map(|k| ends(face, k))).collect();
    edges.sort_unstable();
    edges.dedup();
    let number = |ends: [u32; 2]| edges.partition_point(|other| *other < ends) as u32;
    let sides = faces.iter().map(|face| [0, 1, 2].map(|k| number(ends(face, k)))).collect();
    (edges, sides)
}

impl Triangulation {
    /// Triangles with these corners, sides and lengths. An edge belongs to at most two triangles; further triangles treat it as a
    /// border.
    pub fn new(corners: Vec<[u32; 3]>, sides: Vec<[u32; 3]>, lengths: Vec<f64>) -> Self {
        let mut faces = vec![[NONE; 2]; lengths.len()];
        for (face, sides) in sides.iter().enumerate() {
            for side in sides {
                let of = &mut faces[*side as usize];
                if let Some(free) = of.iter_mut().find(|face| **face == NONE) {
                    *free = face as u32;
                }
            }
        }
        Self { corners, sides, lengths, faces }
    }

    /// The lengths of the sides of a triangle.
    pub fn of(&self, face: usize) -> [f64; 3] {
        self.sides[face].map(|side| self.lengths[side as usize])
    }

    /// Flips edges until all are Delaunay, in the order of their numbers.
    pub fn flip_to_delaunay(&mut self) {
        let count = self.lengths.len();
        let mut waiting: VecDeque<u32> = (0..count as u32).collect();
        let mut is_waiting = vec![true; count];
        let mut left = FLIPS_AN_EDGE * count;
        while let Some(edge) = waiting.pop_front() {
            is_waiting[edge as usize] = false;
            let Some(quad) = self.quad(edge) else { continue };
            if left == 0 || quad.is_delaunay() || !self.flip(edge, &quad) {
                continue;
            }
            left -= 1;
            for side in quad.around {
                if !std::mem::replace(&mut is_waiting[side as usize], true) {
                    waiting.push_back(side);
                }
            }
        }
    }

    /// The two triangles at an inner edge; `None` at a border and if both sides are one triangle.
    fn quad(&self, edge: u32) -> Option<Quad> {
        let [face, other] = self.faces[edge as usize];
        if face == NONE || other == NONE || face == other {
            return None;
        }
        let ([a, b, c], [_, bc, ca]) = self.from(face, edge)?;
        let ([d_from, d_to, d], [_, first, second]) = self.from(other, edge)?;
        // The other triangle may have the opposite orientation, as somewhere on a Möbius strip.
        let (ad, db) = if [d_from, d_to] == [a, b] { (second, first) } else { (first, second) };
        if a == b {
            return None;
        }
        let length = |side: u32| self.lengths[side as usize];
        let lengths = [length(edge), length(bc), length(ca), length(ad), length(db)];
        Some(Quad { faces: [face, other], ends: [a, b], tips: [c, d], around: [bc, ca, ad, db], lengths })
    }

    /// The corners and sides of a triangle from one of its edges on.
    fn from(&self, face: u32, edge: u32) -> Option<([u32; 3], [u32; 3])> {
        let (corners, sides) = (self.corners[face as usize], self.sides[face as usize]);
        let first = sides.iter().position(|side| *side == edge)?;
        Some(([0, 1, 2].map(|k| corners[(first + k) % 3]), [0, 1, 2].map(|k| sides[(first + k) % 3])))
    }

    /// Replaces an edge by the other diagonal; false if that would make a triangle without area.
    fn flip(&mut self, edge: u32, quad: &Quad) -> bool {
        let Quad { faces: [face, other], ends: [a, b], tips: [c, d], around: [bc, ca, ad, db], lengths } =
            *quad;
        let [_, length_bc, length_ca, length_ad, length_db] = lengths;
        let Some(diagonal) = quad.diagonal() else { return false };
        if area4([diagonal, length_db, length_bc]) <= 0.0 || area4([diagonal, length_ca, length_ad]) <= 0.0 {
            return false;
        }
        self.lengths[edge as usize] = diagonal;
        (self.corners[face as usize], self.sides[face as usize]) = ([c, d, b], [edge, db, bc]);
        (self.corners[other as usize], self.sides[other as usize]) = ([d, c, a], [edge, ca, ad]);
        self.hand_over(db, other, face);
        self.hand_over(ca, face, other);
        true
    }

    /// Moves an edge from triangle `from` to triangle `to`.
    fn hand_over(&mut self, edge: u32, from: u32, to: u32) {
        if let Some(face) = self.faces[edge as usize].iter_mut().find(|face| **face == from) {
            *face = to;
        }
    }
}

/// The two triangles of an edge from a to b, whose other corners are c and d.
#[derive(Clone, Copy)]
struct Quad {
    faces: [u32; 2],
    /// a, b.
    ends: [u32; 2],
    /// c, d.
    tips: [u32; 2],
    /// The edges bc, ca, ad, db.
    around: [u32; 4],
    /// The lengths of ab, bc, ca, ad, db.
    lengths: [f64; 5],
}

/// Sums of cotangents above the negative of this count as 0: the diagonals of a square must not be flipped for ever.
const TOLERANCE: f64 = 1e-9;

impl Quad {
    /// Whether the sum of the angles opposite the edge is at most 180°.
    fn is_delaunay(&self) -> bool {
        let [ab, bc, ca, ad, db] = self.lengths;
        cotangent(ab, [bc, ca]) + cotangent(ab, [ad, db]) >= -TOLERANCE
    }

    /// The length of the other diagonal, with both triangles laid in a plane; `None` if it is not finite.
    fn diagonal(&self) -> Option<f64> {
        let [ab, bc, ca, ad, db] = self.lengths;
        // With a at 0 and b on the first axis.
        let tip = |to_a: f64, to_b: f64| {
            let x = (ab * ab + to_a * to_a - to_b * to_b) / (2.0 * ab);
            [x, (to_a * to_a - x * x).max(0.0).sqrt()]
        };
        let ([cx, cy], [dx, dy]) = (tip(ca, bc), tip(ad, db));
        let length = ((cx - dx) * (cx - dx) + (cy + dy) * (cy + dy)).sqrt();
        (length.is_finite() && length > 0.0).then_some(length)
    }
}

/// Four times the area of a triangle with these sides; 0 if they form none. Kahan's form of Heron's formula.
pub fn area4(sides: [f64; 3]) -> f64 {
    let mut sorted = sides;
    sorted.sort_unstable_by(f64::total_cmp);
    let [c, b, a] = sorted;
    let product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    product.max(0.0).sqrt()
}

/// Least area of a triangle ÷ the square of its longest side; for a thinner one the cotangents are limited to those of this ratio.
const THINNEST: f64 = 1e-8;

/// The cotangent of the angle opposite a side, between two others.
pub fn cotangent(opposite: f64, [a, b]: [f64; 2]) -> f64 {
    let longest = opposite.max(a).max(b);
    let area4 = area4([opposite, a, b]).max(4.0 * THINNEST * longest * longest);
    if area4 > 0.0 { (a * a + b * b - opposite * opposite) / area4 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangulated(faces: &[[u32; 3]], length: impl Fn([u32; 2]) -> f64) -> Triangulation {
        let (edges, sides) = edges(faces);
        let lengths = edges.iter().map(|ends| length(*ends)).collect();
        Triangulation::new(faces.to_vec(), sides, lengths)
    }

    /// Four corners of a kite: its two triangles share the long diagonal, 0 to 1.
    fn kite(faces: &[[u32; 3]]) -> Triangulation {
        let at: [[f64; 2]; 4] = [[-2.0, 0.0], [2.0, 0.0], [0.0, 0.5], [0.0, -1.0]];
        triangulated(faces, |[a, b]| {
            let [a, b] = [a, b].map(|end| at[end as usize]);
            ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
        })
    }

    fn is_delaunay(triangulation: &Triangulation) -> bool {
        let mut edges = 0..triangulation.lengths.len() as u32;
        edges.all(|edge| triangulation.quad(edge).is_none_or(|quad| quad.is_delaunay()))
    }

    #[test]
    fn the_long_diagonal_of_a_kite_is_flipped_to_the_short_one() {
        // Also if the second triangle has the opposite orientation.
        for faces in [[[0, 1, 2], [1, 0, 3]], [[0, 1, 2], [0, 1, 3]]] {
            let mut kite = kite(&faces);
            kite.flip_to_delaunay();
            assert!(is_delaunay(&kite));
            assert!((kite.lengths[0] - 1.5).abs() < 1e-12, "{:?}", kite.lengths);
            let sums: Vec<u32> = kite.corners.iter().map(|corners| corners.iter().sum()).collect();
            assert!(kite.corners.iter().all(|corners| corners.contains(&2) && corners.contains(&3)));
            assert_eq!(sums.iter().sum::<u32>(), 11);
        }
    }

    #[test]
    fn flips_keep_the_area_and_end_in_any_metric() {
        // A grid of squares cut along one diagonal, sheared so that half of the edges must be flipped, some more than once.
        let n = 8u32;
        let square = |x: u32, y: u32| {
            let at = |x: u32, y: u32| y * (n + 1) + x;
            [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]]
        };
        let faces: Vec<[u32; 3]> = (0..n * n).flat_map(|cell| square(cell % n, cell / n)).collect();
        for shear in [0.0, 0.7, -2.3] {
            let place = |end: u32| {
                let (x, y) = (f64::from(end % (n + 1)), f64::from(end / (n + 1)));
                [x + shear * y, y]
            };
            let mut triangulation = triangulated(&faces, |[a, b]| {
                let ([ax, ay], [bx, by]) = (place(a), place(b));
                ((ax - bx) * (ax - bx) + (ay - by) * (ay - by)).sqrt()
            });
            triangulation.flip_to_delaunay();
            assert!(is_delaunay(&triangulation), "{shear}");
            let area: f64 = (0..faces.len()).map(|face| 0.25 * area4(triangulation.of(face))).sum();
            assert!((area - f64::from(n * n)).abs() < 1e-9, "{shear}: {area}");
        }
    }

    #[test]
    fn triangles_that_share_an_edge_with_too_many_others_end_there() {
        let fin = triangulated(&[[0, 1, 2], [1, 0, 3], [0, 1, 4]], |_| 1.0);
        assert_eq!(fin.faces[0], [0, 1]);
    }

    #[test]
    fn lengths_that_make_no_triangle_give_finite_cotangents() {
        for sides in [[3.0, 1.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 1.0]] {
            assert!(cotangent(sides[0], [sides[1], sides[2]]).is_finite(), "{sides:?}");
        }
    }
}
