//! The pieces of faces that lie above a threshold.
//!
//! Within a face, values are those of the quadratic surface through its corners and the midpoints of its sides; the values at the
//! midpoints are those of a cubic along the side with the slopes at its ends. So areas are those of the smooth surface, not of the
//! mesh, as with the splines of grids.

use crate::surface::Surface;

/// A triangle of a face above the threshold.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub face: u32,
    /// Its corners, as barycentric coordinates in the face.
    pub corners: [[f64; 3]; 3],
    /// Its area on the surface.
    pub area: f64,
}

/// Number of parts into which the sides of a face at the border of a spot are cut. With 8 areas change by less than 0.1 %.
const CUTS: usize = 4;

/// Excess of values over a threshold by vertex, and their slopes.
pub struct LevelSet<'a> {
    above: &'a [f64],
    slopes: Vec<[f64; 2]>,
}

impl<'a> LevelSet<'a> {
    /// Slopes are those of the least-squares plane through the neighbours of a vertex.
    pub fn new(surface: &Surface, above: &'a [f64]) -> Self {
        let slope = |vertex: usize| {
            let (mut products, mut right) = ([0.0; 3], [0.0; 2]);
            for (other, [x, y]) in surface.tangent_ring(vertex) {
                let weight = 1.0 / (x * x + y * y).max(f64::MIN_POSITIVE);
                let rise = above[other] - above[vertex];
                for (sum, product) in products.iter_mut().zip([x * x, x * y, y * y]) {
                    *sum += weight * product;
                }
                right = [right[0] + weight * x * rise, right[1] + weight * y * rise];
            }
            let [xx, xy, yy] = products;
            let size = xx * yy - xy * xy;
            let found =
                [yy * right[0] - xy * right[1], xx * right[1] - xy * right[0]].map(|part| part / size);
            if found.iter().all(|part| part.is_finite()) { found } else { [0.0; 2] }
        };
        // Only slopes at the border of a spot are needed.
        let is_near = |vertex: usize| {
            let sign = above[vertex] > 0.0;
            surface.ring(vertex).any(|other| (above[other] > 0.0) != sign)
        };
        let cells = 0..above.len();
        Self {
            above,
            slopes: cells.map(|vertex| if is_near(vertex) { slope(vertex) } else { [0.0; 2] }).collect(),
        }
    }

    /// The pieces of a face.
    pub fn pieces(&self, surface: &Surface, face: usize) -> Vec<Piece> {
        self.pieces_and_contour(surface, face).0
    }

    /// The pieces of a face, and the length of their border within it: the contour at the threshold.
    pub fn pieces_and_contour(&self, surface: &Surface, face: usize) -> (Vec<Piece>, f64) {
        let corners = surface.mesh.faces[face].map(|vertex| self.above[vertex as usize]);
        let [x, y, z] = surface.mesh.area_vector(face);
        let area = 0.5 * (x * x + y * y + z * z).sqrt();
        let whole = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        if corners.iter().all(|above| *above > 0.0) {
            return (vec![Piece { face: face as u32, corners: whole, area }], 0.0);
        }
        let places = surface.mesh.corners(face);
        let mut contour = 0.0;
        let middles = [0, 1, 2].map(|side| self.middle(surface, face, side));
        let value = |[a, b, c]: [f64; 3]| {
            let own =
                [a, b, c].into_iter().zip(corners).map(|(share, above)| share * (2.0 * share - 1.0) * above);
            own.sum::<f64>() + 4.0 * (a * b * middles[0] + b * c * middles[1] + c * a * middles[2])
        };
        let mut pieces = Vec::new();
        let at = |i: usize, j: usize| {
            let [second, third] = [i, j].map(|k| k as f64 / CUTS as f64);
            [1.0 - second - third, second, third]
        };
        let mut add = |part: [[f64; 3]; 3]| {
            let crossed = clip(part, part.map(value), |corners| {
                let share = share_of_area(corners);
                pieces.push(Piece { face: face as u32, corners, area: share * area });
            });
            if let Some([from, to]) = crossed {
                let way: [f64; 3] = std::array::from_fn(|axis| {
                    (0..3).map(|k| (to[k] - from[k]) * places[k][axis]).sum::<f64>()
                });
                contour += way.iter().map(|part| part * part).sum::<f64>().sqrt();
            }
        };
        for j in 0..CUTS {
            for i in 0..CUTS - j {
                add([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < CUTS {
                    add([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
        (pieces, contour)
    }

    /// The value at the midpoint of a side.
    fn middle(&self, surface: &Surface, face: usize, side: usize) -> f64 {
        let [from, to] = [side, (side + 1) % 3].map(|k| surface.mesh.faces[face][k] as usize);
        // Extrapolated from both ends towards each other.
        let [ahead, back] = surface.side_ways(face, side);
        let rise =
            |vertex: usize, way: [f64; 2]| self.slopes[vertex][0] * way[0] + self.slopes[vertex][1] * way[1];
        0.5 * (self.above[from] + self.above[to]) + 0.125 * (rise(from, ahead) + rise(to, back))
    }
}

/// The share of a face's area in a triangle, from the barycentric coordinates of its corners.
fn share_of_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let [[ux, uy], [vx, vy]] = [b, c].map(|other| [other[1] - a[1], other[2] - a[2]]);
    (ux * vy - uy * vx).abs()
}

/// Gives the triangles of the part of a triangle where the linear function with these values at its corners is above 0. Returns the
/// ends of the line where it is 0.
fn clip(
    corners: [[f64; 3]; 3],
    values: [f64; 3],
    mut each: impl FnMut([[f64; 3]; 3]),
) -> Option<[[f64; 3]; 2]> {
    let is_above = values.map(|value| value > 0.0);
    let count = is_above.iter().filter(|is| **is).count();
    if count == 0 {
        return None;
    }
    if count == 3 {
        each(corners);
        return None;
    }
    // First the corner that is the only one on its side.
    let lone = (0..3).find(|k| is_above[*k] == (count == 1)).unwrap_or(0);
    let [a, b, c] = [0, 1, 2].map(|k| (lone + k) % 3);
    let crossing = |to: usize| {
        let share = values[a] / (values[a] - values[to]);
        [0, 1, 2].map(|k| corners[a][k] + share * (corners[to][k] - corners[a][k]))
    };
    let (first, second) = (crossing(b), crossing(c));
    if count == 1 {
        each([corners[a], first, second]);
    } else {
        each([first, corners[b], corners[c]]);
        each([first, corners[c], second]);
    }
    Some([first, second])
}
