//! A line: a drawn piece of a stripe.

use super::axial;

/// A straight line with a width, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end, px.
    pub from: [f64; 2],
    /// The other end, px.
    pub to: [f64; 2],
    /// Width of the stroke, px.
    pub width: f64,
}

impl Line {
    /// Distance between its ends, px.
    ///
    /// ```
    /// use dapple_engine::marks::Line;
    ///
    /// let line = Line { from: [10.0, 10.0], to: [40.0, 50.0], width: 4.0 };
    /// assert_eq!(line.length(), 50.0);
    /// ```
    #[must_use]
    pub fn length(&self) -> f64 {
        let (dx, dy) = (self.to[0] - self.from[0], self.to[1] - self.from[1]);
        (dx * dx + dy * dy).sqrt()
    }

    /// Its direction, degrees in [0, 180).
    #[must_use]
    pub fn angle(&self) -> f64 {
        axial(libm::atan2(self.to[1] - self.from[1], self.to[0] - self.from[0]).to_degrees())
    }

    /// The point halfway between its ends; the region that holds it owns the line.
    #[must_use]
    pub fn center(&self) -> [f64; 2] {
        [0.5 * (self.from[0] + self.to[0]), 0.5 * (self.from[1] + self.to[1])]
    }
}
