//! Lengths of edges in the metric of a stretch: along a direction of faster diffusion lengths are shorter.
//!
//! A stretch ρ represents the diffusion tensor of determinant 1 with eigenvalues 1/ρ along a direction and ρ across it, as on a
//! flat grid. Its inverse is the metric ds² = ρ·along² + across²/ρ, which has determinant 1, too: areas do not change.

use super::mesh::Mesh;
use super::vector::{dot, minus};
use crate::grid::sin_cos_degrees;

/// The anisotropy of a diffusion tensor of determinant 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Minor ÷ major axis of the ellipse that it makes of a circle, above 0 and at most 1; 1 = isotropic.
    pub ratio: f32,
    /// Direction of the major axis in the vertex's frame, degrees.
    pub degrees: f32,
}

impl Stretch {
    /// The isotropic metric: no stretch in any direction.
    pub const NONE: Self = Self { ratio: 1.0, degrees: 0.0 };
}

/// The metric of a vertex in space: the squared length of a vector from its components along `axes`; the vector need not lie in the
/// tangent plane.
struct Metric {
    ratio: f64,
    /// The unit vector along the major axis, and that across it.
    axes: [[f64; 3]; 2],
}

impl Metric {
    fn new(frame: &[[f64; 3]; 2], stretch: Stretch) -> Self {
        let (sin, cos) = sin_cos_degrees(f64::from(stretch.degrees));
        let [x, y] = frame;
        let turned = |a: f64, b: f64| [0, 1, 2].map(|i| a * x[i] + b * y[i]);
        Self { ratio: f64::from(stretch.ratio), axes: [turned(cos, sin), turned(-sin, cos)] }
    }

    /// The squared length of an edge ÷ its squared length in space. For an edge that leaves the tangent plane the direction is that
    /// of its projection.
    fn factor(&self, edge: [f64; 3]) -> f64 {
        let [along, across] = self.axes.map(|axis| {
            let part = dot(axis, edge);
            part * part
        });
        let projected = along + across;
        if self.ratio == 1.0 || projected <= 0.0 {
            return 1.0;
        }
        (self.ratio * along + across / self.ratio) / projected
    }
}

/// The length of each of `edges` in the mean metric of its ends.
pub fn lengths(mesh: &Mesh, frames: &[[[f64; 3]; 2]], stretch: &[Stretch], edges: &[[u32; 2]]) -> Vec<f64> {
    let metrics: Vec<Metric> =
        frames.iter().zip(stretch).map(|(frame, stretch)| Metric::new(frame, *stretch)).collect();
    let length = |[a, b]: &[u32; 2]| {
        let [from, to] = [a, b].map(|end| mesh.positions[*end as usize]);
        let edge = minus(to, from);
        let [a, b] = [a, b].map(|end| metrics.get(*end as usize).map_or(1.0, |metric| metric.factor(edge)));
        (0.5 * (a + b) * dot(edge, edge)).sqrt()
    };
    edges.iter().map(length).collect()
}

/// The largest ratio of the longest side of a triangle to the sum of the others. Closer to 1, angles are lost in rounding.
const LONGEST: f64 = 0.99;
/// Rounds over all triangles: a side that became shorter may be too short for the triangle on its other side.
const ROUNDS: usize = 20;

/// Shortens the edges that are too long for a triangle, given by its three edges. Where the metric varies within a cell (at the
/// singularities of directions) lengths violate the triangle inequality.
///
/// Only these edges change. Adding a length to every edge, as is usual for degenerate meshes, would make the metric more isotropic
/// everywhere: spots of an aspect of 0.5 got one of 0.61.
pub fn hold_triangle_inequality(triangles: &[[u32; 3]], lengths: &mut [f64]) {
    for _ in 0..ROUNDS {
        let mut changed = false;
        for sides in triangles {
            let of = sides.map(|side| lengths[side as usize]);
            let sum: f64 = of.iter().sum();
            for (side, length) in sides.iter().zip(of) {
                let others = sum - length;
                if length > others {
                    lengths[*side as usize] = LONGEST * others;
                    changed = true;
                }
            }
        }
        if !changed {
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    /// The length of an edge from 0 to `to`, where the plane z = 0 has this stretch.
    fn length(to: [f64; 3], stretch: Stretch) -> f64 {
        let mesh = Mesh { positions: vec![[0.0; 3], to], faces: Vec::new() };
        lengths(&mesh, &[FRAME; 2], &[stretch; 2], &[[0, 1]])[0]
    }

    #[test]
    fn an_edge_along_the_major_axis_is_shorter_by_the_root_of_the_stretch_and_one_across_it_longer() {
        let stretch = Stretch { ratio: 0.25, degrees: 90.0 };
        assert!((length([0.0, 2.0, 0.0], stretch) - 1.0).abs() < 1e-12);
        assert!((length([2.0, 0.0, 0.0], stretch) - 4.0).abs() < 1e-12);
        let oblique = length([1.0, 1.0, 0.0], Stretch { ratio: 0.25, degrees: 45.0 });
        assert!((oblique - 0.5 * 2.0f64.sqrt()).abs() < 1e-12);
        assert_eq!(length([3.0, 4.0, 0.0], Stretch::NONE), 5.0);
    }

    #[test]
    fn an_edge_out_of_the_tangent_plane_keeps_its_length_in_space() {
        let stretch = Stretch { ratio: 0.25, degrees: 0.0 };
        assert_eq!(length([0.0, 0.0, 3.0], stretch), 3.0);
        assert!((length([3.0, 0.0, 4.0], stretch) - 2.5).abs() < 1e-12);
    }

    #[test]
    fn only_an_edge_that_is_too_long_for_its_triangle_is_shortened() {
        let mut lengths = [1.0, 1.0, 3.0, 1.5, 1.2];
        hold_triangle_inequality(&[[0, 1, 2], [2, 3, 4]], &mut lengths);
        assert_eq!(lengths, [1.0, 1.0, 2.0 * LONGEST, 1.5, 1.2]);
    }
}
