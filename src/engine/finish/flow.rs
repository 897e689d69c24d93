//! The direction of hair, scales and threads at each place of the canvas.

use crate::grid::{Edges, sin_cos_degrees};

/// Directions over a canvas.
#[derive(Clone, Debug, PartialEq)]
pub enum Flow {
    /// One direction: a unit vector, x to the right, y down.
    Uniform([f32; 2]),
    /// Directions at nodes in the centres of equal cells.
    Nodes {
        /// Columns and rows.
        size: [usize; 2],
        /// Width and height of a cell, px of the canvas.
        cell: [f32; 2],
        /// Continuation beyond the border.
        edges: Edges,
        /// Unit vectors, row by row.
        vectors: Vec<[f32; 2]>,
    },
}

impl Flow {
    /// The direction at an angle in degrees from +x towards +y.
    #[must_use]
    pub fn uniform(degrees: f64) -> Self {
        let (sin, cos) = sin_cos_degrees(degrees.rem_euclid(360.0));
        Self::Uniform([cos as f32, sin as f32])
    }

    /// Directions at nodes about `apart` px from each other on a canvas of `size` px; `direction` gives a vector at a point.
    #[must_use]
    pub fn nodes(size: [f32; 2], edges: Edges, apart: f32, direction: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        let nodes = size.map(|side| ((side / apart).ceil() as usize).max(1));
        let cell = [0, 1].map(|axis| size[axis] / nodes[axis] as f32);
        let node = |index: usize| {
            let place = [index % nodes[0], index / nodes[0]];
            let point = [0, 1].map(|axis| (place[axis] as f64 + 0.5) * f64::from(cell[axis]));
            unit(direction(point).map(|part| part as f32))
        };
        Self::Nodes { size: nodes, cell, edges, vectors: (0..nodes[0] * nodes[1]).map(node).collect() }
    }

    /// The unit vector at a point, px of the canvas.
    #[inline]
    #[must_use]
    pub fn at(&self, point: [f32; 2]) -> [f32; 2] {
        let (size, cell, edges, vectors) = match self {
            Self::Uniform(vector) => return *vector,
            Self::Nodes { size, cell, edges, vectors } => (size, cell, edges, vectors),
        };
        let place = [0, 1].map(|axis| point[axis] / cell[axis] - 0.5);
        let base = place.map(f32::floor);
        let [u, v] = [place[0] - base[0], place[1] - base[1]];
        let index = |axis: usize, by: isize| edges.index(base[axis] as isize + by, size[axis]);
        let mut sum = [0.0; 2];
        for (j, down) in [1.0 - v, v].into_iter().enumerate() {
            for (i, across) in [1.0 - u, u].into_iter().enumerate() {
                let vector = vectors[index(1, j as isize) * size[0] + index(0, i as isize)];
                sum = [sum[0] + down * across * vector[0], sum[1] + down * across * vector[1]];
            }
        }
        unit(sum)
    }
}

/// The vector of length 1 in the direction of `vector`; of no direction along −x.
#[inline]
fn unit(vector: [f32; 2]) -> [f32; 2] {
    let length = (vector[0] * vector[0] + vector[1] * vector[1]).sqrt();
    if length > 1e-6 { vector.map(|part| part / length) } else { [-1.0, 0.0] }
}

/// `vector` turned by a small angle in radians, at most about 1.3, from +x towards +y. Sine and cosine are Taylor polynomials,
/// so all machines give the same bits.
#[inline]
#[must_use]
pub fn turned(vector: [f32; 2], angle: f32) -> [f32; 2] {
    let square = angle * angle;
    let sin = angle
        * (1.0
            - square
                * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5_040.0 * (1.0 - square / 72.0)))));
    let cos =
        1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square * (1.0 / 40_320.0))));
    [cos * vector[0] - sin * vector[1], sin * vector[0] + cos * vector[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_read_between_nodes_and_across_the_border_of_a_tile() {
        let flow =
            Flow::nodes(
                [64.0, 32.0],
                Edges::Wrap,
                8.0,
                |[x, _]| if x < 32.0 { [1.0, 0.0] } else { [0.0, 2.0] },
            );
        assert_eq!(flow.at([12.0, 5.0]), [1.0, 0.0]);
        assert_eq!(flow.at([52.0, 5.0]), [0.0, 1.0]);
        let between = flow.at([0.0, 5.0]);
        assert!((between[0] - between[1]).abs() < 1e-6, "{between:?}");
    }

    #[test]
    fn vectors_are_turned_by_an_angle() {
        for k in -10..=10 {
            let angle = 0.12 * k as f32;
            let [x, y] = turned([1.0, 0.0], angle);
            assert!((x - libm::cosf(angle)).abs() < 2e-5 && (y - libm::sinf(angle)).abs() < 2e-5, "{angle}");
        }
    }
}
