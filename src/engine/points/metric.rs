//! Lengths that depend on the direction: an ellipse is the unit circle.

/// The quadratic form of an ellipse: d² = xx·x² + 2·xy·x·y + yy·y² is 1 on the ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Coefficients, 1/px².
    pub form: [f64; 3],
    /// Half the width and half the height of the ellipse's bounding box, px.
    pub half: [f64; 2],
    /// Radius of the circle of the same area, px.
    pub radius: f64,
}

impl Metric {
    /// A circle of `radius` px.
    #[must_use]
    pub fn circle(radius: f64) -> Self {
        Self { form: [radius.powi(-2), 0.0, radius.powi(-2)], half: [radius; 2], radius }
    }

    /// The ellipse of the area of a circle of `radius` px, with minor ÷ major axis `aspect`, 0..1, and the major axis along
    /// `angle`, degrees.
    ///
    /// ```
    /// use dapple_engine::points::metric::Metric;
    ///
    /// // An ellipse along x: 10 px away in this direction is nearer than 10 px across.
    /// let metric = Metric::ellipse(10.0, 0.5, 0.0);
    /// assert!(metric.square([10.0, 0.0]) < metric.square([0.0, 10.0]));
    /// ```
    #[must_use]
    pub fn ellipse(radius: f64, aspect: f64, angle: f64) -> Self {
        let [major, minor] = [radius / aspect.sqrt(), radius * aspect.sqrt()];
        let (s, c) = libm::sincos(angle.to_radians());
        let [along, across] = [major.powi(-2), minor.powi(-2)];
        let form = [along * c * c + across * s * s, (along - across) * s * c, along * s * s + across * c * c];
        let half = [libm::hypot(major * c, minor * s), libm::hypot(major * s, minor * c)];
        Self { form, half, radius }
    }

    /// Square of the length of `displacement`, px, where the ellipse has the radius 1.
    #[must_use]
    pub fn square(&self, [x, y]: [f64; 2]) -> f64 {
        self.form[0] * x * x + 2.0 * self.form[1] * x * y + self.form[2] * y * y
    }

    /// The gradient of [`Self::square`] at `displacement`, px.
    #[must_use]
    pub fn slope(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [xx, xy, yy] = self.form;
        [2.0 * (xx * x + xy * y), 2.0 * (xy * x + yy * y)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn displacements_along_the_half_axes_have_length_1() {
        let metric = Metric::ellipse(6.0, 0.25, 30.0);
        let (s, c) = libm::sincos(30f64.to_radians());
        assert!((metric.square([12.0 * c, 12.0 * s]) - 1.0).abs() < 1e-12);
        assert!((metric.square([-3.0 * s, 3.0 * c]) - 1.0).abs() < 1e-12);
        let round = Metric::ellipse(6.0, 1.0, 77.0);
        let [x, y] = metric.slope([12.0 * c, 12.0 * s]);
        assert!((x * c + y * s - 2.0 / 12.0).abs() < 1e-12, "the square rises by 2 d ÷ 12² a px");
        assert!((round.square([3.0, 4.0]) - Metric::circle(6.0).square([5.0, 0.0])).abs() < 1e-12);
    }
}
