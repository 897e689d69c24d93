//! Converts the part of an oblique photograph between four corners of a flat object to a view from straight above.
//!
//! The projection of the unit square onto a quadrilateral, in homogeneous coordinates, with (u, v) 0..1 in the square:
//!
//! ```text
//! x = (a·u + b·v + c) ÷ (g·u + h·v + 1),  y = (d·u + e·v + f) ÷ (g·u + h·v + 1)
//! ```
//!
//! P. Heckbert, "Fundamentals of texture mapping and image warping", UC Berkeley (1989), 2.2.3.

use super::Raster;

/// The four corners of a quadrilateral: upper left, upper right, lower right, lower left, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners(pub [[f64; 2]; 4]);

/// Least sine of the exterior angle at a corner (3°): otherwise the object is seen edge-on.
const SINE: f64 = 0.05;

impl Corners {
    /// Whether the corners are those of a convex quadrilateral, in clockwise order as seen, and not nearly a triangle.
    #[must_use]
    pub fn are_convex(&self) -> bool {
        (0..4).all(|k| {
            let [a, b, c] = [self.0[k], self.0[(k + 1) % 4], self.0[(k + 2) % 4]];
            let [one, two] = [way(a, b), way(b, c)];
            cross(one, two) > SINE * length(one) * length(two)
        })
    }

    /// Width and height of the flattened picture, px: the longer one of two opposite sides, so that no detail is lost.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        let side = |k: usize| length(way(self.0[k], self.0[(k + 1) % 4]));
        [side(0).max(side(2)), side(1).max(side(3))]
    }

    /// The part of `raster` between the corners as a rectangle of [`Self::size`], rounded.
    ///
    /// The corners must be convex, see [`Self::are_convex`].
    #[must_use]
    pub fn flattened(&self, raster: &Raster) -> Raster {
        let sides = self.size().map(|side| side.round().max(1.0));
        let project = self.projection();
        raster.warped(sides.map(|side| side as usize), |[x, y]| project([x / sides[0], y / sides[1]]))
    }

    /// The position of a point of the unit square, px. The corners must be convex, see [`Self::are_convex`].
    pub fn projection(&self) -> impl Fn([f64; 2]) -> [f64; 2] + Sync + use<> {
        let (across, down, [g, h]) = self.coefficients();
        move |[u, v]| {
            let depth = g * u + h * v + 1.0;
            [across, down].map(|row| (row[0] * u + row[1] * v + row[2]) / depth)
        }
    }

    /// The position of a point, px, in the unit square; beyond 0..1 outside of the corners. These must be convex.
    pub fn unprojection(&self) -> impl Fn([f64; 2]) -> [f64; 2] + Sync + use<> {
        let ([a, b, c], [d, e, f], [g, h]) = self.coefficients();
        // Two linear equations: (a − x·g)·u + (b − x·h)·v = x − c, and likewise for y.
        move |[x, y]| {
            let (one, two) = ([a - x * g, b - x * h], [d - y * g, e - y * h]);
            let area = cross(one, two);
            [cross([x - c, y - f], [one[1], two[1]]) / area, cross([one[0], two[0]], [x - c, y - f]) / area]
        }
    }

    /// [a, b, c], [d, e, f], [g, h].
    fn coefficients(&self) -> ([f64; 3], [f64; 3], [f64; 2]) {
        let [p, q, r, s] = self.0;
        let sum = [p[0] - q[0] + r[0] - s[0], p[1] - q[1] + r[1] - s[1]];
        let [one, two] = [way(r, q), way(r, s)];
        let area = cross(one, two);
        let g = cross(sum, two) / area;
        let h = cross(one, sum) / area;
        let row = |k: usize| [q[k] - p[k] + g * q[k], s[k] - p[k] + h * s[k], p[k]];
        (row(0), row(1), [g, h])
    }
}

fn way(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn cross(one: [f64; 2], two: [f64; 2]) -> f64 {
    one[0] * two[1] - one[1] * two[0]
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const OBLIQUE: Corners = Corners([[12.0, 9.0], [90.0, 17.0], [83.0, 70.0], [5.0, 88.0]]);

    #[test]
    fn the_corners_of_the_square_lie_at_the_corners() {
        let project = OBLIQUE.projection();
        for (unit, corner) in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].into_iter().zip(OBLIQUE.0) {
            let found = project(unit);
            assert!((0..2).all(|k| (found[k] - corner[k]).abs() < 1e-9), "{found:?} {corner:?}");
        }
    }

    #[test]
    fn a_projected_point_is_projected_back() {
        let (project, back) = (OBLIQUE.projection(), OBLIQUE.unprojection());
        for unit in [[0.0, 0.0], [0.3, 0.8], [1.0, 0.1], [1.2, -0.1]] {
            let found = back(project(unit));
            assert!((0..2).all(|k| (found[k] - unit[k]).abs() < 1e-9), "{found:?} {unit:?}");
        }
    }

    #[test]
    fn straight_lines_stay_straight_and_the_diagonals_cross_in_the_middle() {
        let project = OBLIQUE.projection();
        let middle = project([0.5, 0.5]);
        for (from, to) in [(OBLIQUE.0[0], OBLIQUE.0[2]), (OBLIQUE.0[1], OBLIQUE.0[3])] {
            let off = cross(way(from, to), way(from, middle)) / length(way(from, to));
            assert!(off.abs() < 1e-9, "{off}");
        }
    }

    #[test]
    fn corners_in_another_order_or_in_a_line_are_no_quadrilateral() {
        assert!(OBLIQUE.are_convex());
        let [p, q, r, s] = OBLIQUE.0;
        for wrong in [[q, p, r, s], [p, s, r, q], [p, q, q, s], [p, q, [45.0, 40.0], s]] {
            assert!(!Corners(wrong).are_convex(), "{wrong:?}");
        }
    }

    #[test]
    fn corners_of_the_picture_itself_leave_it_as_it_is() {
        let rgb = (0..3 * 20 * 10).map(|k| (k * 7 % 251) as u8).collect();
        let raster = Raster { size: [20, 10], rgb, dpi: Some(72.0) };
        let corners = Corners([[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [0.0, 10.0]]);
        assert_eq!(corners.flattened(&raster), raster);
    }
}
