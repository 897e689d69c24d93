//! An ellipse: a spot, drawn or measured.

use super::axial;
use crate::grid::Bounds;

/// An ellipse, px and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Centre, px.
    pub center: [f64; 2],
    /// `radii[0]` lies along `angle`, `radii[1]` across it, px; either may be the larger.
    pub radii: [f64; 2],
    /// Direction of `radii[0]`, degrees from +x towards +y.
    pub angle: f64,
}

impl Ellipse {
    /// The ellipse of this area (px²), aspect (0..1] and major axis (degrees).
    ///
    /// ```
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let spot = Ellipse::from_area([50.0, 40.0], 300.0, 0.5, 30.0);
    /// assert!((spot.area() - 300.0).abs() < 1e-9 && (spot.aspect() - 0.5).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn from_area(center: [f64; 2], area: f64, aspect: f64, angle: f64) -> Self {
        let minor = (area * aspect / std::f64::consts::PI).sqrt();
        Self { center, radii: [minor / aspect, minor], angle }
    }

    /// π·r₁·r₂, px².
    #[must_use]
    pub fn area(&self) -> f64 {
        std::f64::consts::PI * self.radii[0] * self.radii[1]
    }

    /// Minor ÷ major radius, 0..1 (1 = round).
    #[must_use]
    pub fn aspect(&self) -> f64 {
        let [r, q] = self.radii;
        r.min(q) / r.max(q)
    }

    /// Half the width and half the height of its bounding box, px.
    ///
    /// ```
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let upright = Ellipse { center: [50.0, 40.0], radii: [9.0, 4.0], angle: 90.0 };
    /// let [x, y] = upright.half_extents();
    /// assert!((x - 4.0).abs() < 1e-9 && (y - 9.0).abs() < 1e-9);
    /// ```
    #[must_use]
    pub fn half_extents(&self) -> [f64; 2] {
        let (s, c) = libm::sincos(self.angle.to_radians());
        let [r, q] = self.radii;
        [libm::hypot(r * c, q * s), libm::hypot(r * s, q * c)]
    }

    /// From the centre to the outline in this direction, a vector of any length, px.
    #[must_use]
    pub fn radius_towards(&self, direction: [f64; 2]) -> f64 {
        let (s, c) = libm::sincos(libm::atan2(direction[1], direction[0]) - self.angle.to_radians());
        let [a, b] = self.radii;
        a * b / libm::hypot(b * c, a * s)
    }

    /// The gap between the outlines of two ellipses on the line through their centres, px; negative where they overlap.
    ///
    /// ```
    /// use dapple_engine::grid::{Bounds, Edges};
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let disc = |x| Ellipse { center: [x, 50.0], radii: [5.0, 5.0], angle: 0.0 };
    /// let tile = Bounds { size: [100.0, 100.0], edges: Edges::Wrap };
    /// // Across the border of the tile their centres are 16 px apart.
    /// assert!((disc(8.0).gap_to(&disc(92.0), &tile) - 6.0).abs() < 1e-9);
    /// ```
    #[must_use]
    pub fn gap_to(&self, other: &Self, canvas: &Bounds) -> f64 {
        let displacement = canvas.shortest([0, 1].map(|axis| other.center[axis] - self.center[axis]));
        libm::hypot(displacement[0], displacement[1])
            - self.radius_towards(displacement)
            - other.radius_towards(displacement)
    }

    /// Direction of the major axis, degrees in [0, 180).
    ///
    /// ```
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let ellipse = Ellipse { center: [0.0, 0.0], radii: [4.0, 9.0], angle: 10.0 };
    /// assert_eq!(ellipse.major_angle(), 100.0);
    /// ```
    #[must_use]
    pub fn major_angle(&self) -> f64 {
        if self.radii[1] > self.radii[0] { axial(self.angle + 90.0) } else { axial(self.angle) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_major_axis_is_across_where_the_second_radius_is_larger() {
        let ellipse = Ellipse { center: [0.0, 0.0], radii: [2.0, 8.0], angle: 100.0 };
        assert_eq!(ellipse.major_angle(), 10.0);
        assert_eq!(ellipse.aspect(), 0.25);
    }

    #[test]
    fn the_radius_of_an_ellipse_is_that_of_its_axes() {
        let ellipse = Ellipse { center: [0.0; 2], radii: [12.0, 5.0], angle: 30.0 };
        let (s, c) = libm::sincos(30f64.to_radians());
        assert!((ellipse.radius_towards([c, s]) - 12.0).abs() < 1e-9);
        assert!((ellipse.radius_towards([-s, c]) - 5.0).abs() < 1e-9);
    }

    #[test]
    fn the_gap_of_ellipses_lies_between_their_outlines_also_across_the_border_of_a_tile() {
        let disc = |x: f64, radius: f64| Ellipse { center: [x, 20.0], radii: [radius; 2], angle: 0.0 };
        let canvas = Bounds { size: [100.0, 50.0], edges: crate::grid::Edges::Closed };
        assert!((disc(20.0, 10.0).gap_to(&disc(50.0, 14.0), &canvas) - 6.0).abs() < 1e-9);
        assert!((disc(20.0, 10.0).gap_to(&disc(30.0, 5.0), &canvas) + 5.0).abs() < 1e-9);
        let tile = Bounds { edges: crate::grid::Edges::Wrap, ..canvas };
        assert!((disc(10.0, 6.0).gap_to(&disc(90.0, 6.0), &tile) - 8.0).abs() < 1e-9);
    }

    #[test]
    fn an_ellipse_from_an_area_has_that_area_aspect_and_angle() {
        let ellipse = Ellipse::from_area([1.0, 2.0], 300.0, 0.4, 30.0);
        assert!((ellipse.area() - 300.0).abs() < 1e-9);
        assert!((ellipse.aspect() - 0.4).abs() < 1e-12);
        assert_eq!(ellipse.major_angle(), 30.0);
    }
}
