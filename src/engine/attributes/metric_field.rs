//! The metric of a parametric surface over a canvas, and what marks on the surface are on the canvas.
//!
//! A surface x(u) has the Jacobian J = ∂x/∂u at the point u of the canvas, and the metric tensor M = JᵀJ. A small mark is stretched by J from
//! the canvas to the surface. What shall diffuse by the matrix A on the surface diffuses by V A Vᵀ with V = M^(−½) on the canvas (Witkin and
//! Kass, "Reaction-Diffusion Textures", 1991, equation 8), so that marks grow there that J stretches to those that are wanted.

use super::regions::RegionGrid;
use super::{Attributes, Spots, Stripes};
use crate::marks::axial;

/// Metric tensors at nodes over a canvas, linear in between.
#[derive(Clone, Debug, PartialEq)]
pub struct MetricField {
    nodes: RegionGrid,
    tensors: Vec<Metric>,
}

/// A metric tensor M = JᵀJ: its entries xx, xy, yy. It must be positive definite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// The squared length on the surface of 1 px along x.
    pub xx: f64,
    /// The scalar product on the surface of 1 px along x and 1 px along y.
    pub xy: f64,
    /// The squared length on the surface of 1 px along y.
    pub yy: f64,
}

impl MetricField {
    /// The field with the metric that `at` returns for the centre of each node, px.
    #[must_use]
    pub fn new(nodes: RegionGrid, at: impl Fn([f64; 2]) -> Metric) -> Self {
        let tensors = (0..nodes.len()).map(|index| at(nodes.center(nodes.place(index)))).collect();
        Self { nodes, tensors }
    }

    /// Its nodes.
    #[must_use]
    pub fn nodes(&self) -> &RegionGrid {
        &self.nodes
    }

    /// The metric at a point of the canvas, px.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Metric {
        let mut sum = Metric { xx: 0.0, xy: 0.0, yy: 0.0 };
        for (node, weight) in self.nodes.corners(point) {
            let tensor = self.tensors[node];
            sum.xx += weight * tensor.xx;
            sum.xy += weight * tensor.xy;
            sum.yy += weight * tensor.yy;
        }
        sum
    }
}

impl Metric {
    /// The metric of heights over a canvas that rise by these slopes along x and y.
    #[must_use]
    pub fn of_slopes([x, y]: [f64; 2]) -> Self {
        Self { xx: 1.0 + x * x, xy: x * y, yy: 1.0 + y * y }
    }

    /// px² of the surface on 1 px² of the canvas: det J = √(det M).
    #[must_use]
    pub fn area(&self) -> f64 {
        (self.xx * self.yy - self.xy * self.xy).max(0.0).sqrt()
    }

    /// The length on the surface of a short vector of the canvas, px.
    #[must_use]
    pub fn length(&self, [x, y]: [f64; 2]) -> f64 {
        (self.xx * x * x + 2.0 * self.xy * x * y + self.yy * y * y).max(0.0).sqrt()
    }

    /// S = M^½, symmetric: J without a turn of the tangent plane.
    fn root(&self) -> Self {
        let area = self.area();
        let norm = (self.xx + self.yy + 2.0 * area).sqrt();
        Self { xx: (self.xx + area) / norm, xy: self.xy / norm, yy: (self.yy + area) / norm }
    }

    /// M⁻¹.
    fn inverse(&self) -> Self {
        let det = self.xx * self.yy - self.xy * self.xy;
        Self { xx: self.yy / det, xy: -self.xy / det, yy: self.xx / det }
    }

    fn applied(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.xx * x + self.xy * y, self.xy * x + self.yy * y]
    }

    /// What marks of the surface are on the canvas. The direction of marks on the surface is that of lines of the canvas laid on it.
    #[must_use]
    pub fn to_canvas(&self, on_surface: Attributes) -> Attributes {
        let (sin, cos) = libm::sincos(on_surface.angle().to_radians());
        let along = self.root().applied([cos, sin]);
        match on_surface {
            Attributes::Spots(spots) => {
                let degrees = libm::atan2(along[1], along[0]).to_degrees();
                let (aspect, angle) = stretched(&self.root().inverse(), spots.aspect, degrees);
                let area = spots.area / self.area();
                // The weighted mean edge of a triangulation hardly depends on a stretch that keeps areas: by .6 % at most of relaxed points
                // that are stretched to an aspect of .4, whose neighbours change.
                let spacing = spots.spacing.map(|spacing| spacing / self.area().sqrt());
                Attributes::Spots(Spots { area, aspect, angle, spacing })
            }
            Attributes::Stripes(stripes) => {
                // Across a stripe, n ⟂ Sd: |Sn| = det S ÷ |Sd|.
                let narrower = libm::hypot(along[0], along[1]) / self.area();
                let wavelength = stripes.wavelength.map(|wavelength| narrower * wavelength);
                Attributes::Stripes(Stripes { width: narrower * stripes.width, wavelength, ..stripes })
            }
        }
    }

    /// What spots of the canvas are on the surface: the inverse of [`Metric::to_canvas`].
    #[must_use]
    pub fn spots_to_surface(&self, spots: &Spots) -> Spots {
        let (aspect, degrees) = stretched(&self.root(), spots.aspect, spots.angle);
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let [x, y] = self.root().inverse().applied([cos, sin]);
        let angle = axial(libm::atan2(y, x).to_degrees());
        let spacing = spots.spacing.map(|spacing| spacing * self.area().sqrt());
        Spots { area: spots.area * self.area(), aspect, angle, spacing }
    }
}

/// Aspect and direction of the major axis, degrees, of an ellipse of this aspect and direction that is stretched by a symmetric matrix.
fn stretched(by: &Metric, aspect: f64, degrees: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let [major, minor] = [by.applied([cos, sin]), by.applied([-aspect * sin, aspect * cos])];
    // B Σ Bᵀ of the covariance Σ, but for a factor.
    let [xx, xy, yy] =
        [(0, 0), (0, 1), (1, 1)].map(|(i, k): (usize, usize)| major[i] * major[k] + minor[i] * minor[k]);
    let apart = libm::hypot(xx - yy, 2.0 * xy);
    let (high, low) = (xx + yy + apart, (xx + yy - apart).max(0.0));
    let angle =
        if apart > 1e-12 * high { 0.5 * libm::atan2(2.0 * xy, xx - yy).to_degrees() } else { degrees };
    ((low / high).sqrt(), axial(angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUND: Spots = Spots { area: 100.0, aspect: 1.0, angle: 0.0, spacing: Some(30.0) };

    fn spots(attributes: Attributes) -> Spots {
        match attributes {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(_) => panic!("spots were given"),
        }
    }

    #[test]
    fn a_round_spot_on_a_slope_is_narrow_along_the_slope_on_the_canvas() {
        // A slope of 1 along x: lengths grow by √2.
        let metric = Metric::of_slopes([1.0, 0.0]);
        let found = spots(metric.to_canvas(Attributes::Spots(ROUND)));
        let root = 2.0_f64.sqrt();
        assert!((found.area - 100.0 / root).abs() < 1e-9, "{found:?}");
        assert!((found.aspect - 1.0 / root).abs() < 1e-9 && (found.angle - 90.0).abs() < 1e-9, "{found:?}");
        assert!((found.spacing.expect("it was given") - 30.0 / root.sqrt()).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn stripes_across_a_slope_are_narrower_on_the_canvas_and_stripes_along_it_are_not() {
        let metric = Metric::of_slopes([0.0, 2.0]);
        let width = |angle: f64| {
            let stripes = Stripes { width: 10.0, angle, wavelength: Some(25.0) };
            match metric.to_canvas(Attributes::Stripes(stripes)) {
                Attributes::Stripes(found) => {
                    assert!((found.wavelength.expect("given") / found.width - 2.5).abs() < 1e-9);
                    assert!((found.angle - angle).abs() < 1e-9);
                    found.width
                }
                Attributes::Spots(_) => panic!("stripes were given"),
            }
        };
        assert!((width(90.0) - 10.0).abs() < 1e-9);
        assert!((width(0.0) - 10.0 / 5.0_f64.sqrt()).abs() < 1e-9);
    }

    #[test]
    fn spots_of_the_canvas_come_back_from_the_surface() {
        for slopes in [[0.0, 0.0], [0.7, -0.4], [-1.5, 0.2]] {
            let metric = Metric::of_slopes(slopes);
            for angle in [0.0, 35.0, 120.0] {
                let wanted = Spots { aspect: 0.6, angle, ..ROUND };
                let found = metric.spots_to_surface(&spots(metric.to_canvas(Attributes::Spots(wanted))));
                assert!((found.area - wanted.area).abs() < 1e-9, "{found:?}");
                assert!((found.aspect - wanted.aspect).abs() < 1e-9, "{found:?}");
                assert!(((found.angle - angle + 90.0).rem_euclid(180.0) - 90.0).abs() < 1e-7, "{found:?}");
            }
        }
    }

    #[test]
    fn lengths_and_areas_are_those_of_the_surface() {
        let metric = Metric::of_slopes([3.0, 4.0]);
        assert!((metric.length([0.6, 0.8]) - 26.0_f64.sqrt()).abs() < 1e-12);
        assert!((metric.length([-0.8, 0.6]) - 1.0).abs() < 1e-12);
        assert!((metric.area() - 26.0_f64.sqrt()).abs() < 1e-12);
    }
}
