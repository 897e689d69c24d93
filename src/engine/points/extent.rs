//! The rectangle that points lie in, with or without a border along each axis.

use crate::grid::{Bounds, Edges};

/// A rectangle from (0, 0) to `size`, px. Along an axis that wraps, its two sides are identified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Width and height, px, both positive.
    pub size: [f64; 2],
    /// Whether x and y wrap.
    pub wrap: [bool; 2],
}

impl From<Bounds> for Extent {
    fn from(bounds: Bounds) -> Self {
        Self { size: bounds.size, wrap: [bounds.edges == Edges::Wrap; 2] }
    }
}

impl Extent {
    /// Whether a point lies on the rectangle or its border. Along an axis that wraps, every point does.
    #[must_use]
    pub fn contains(&self, at: [f64; 2]) -> bool {
        (0..2).all(|axis| self.wrap[axis] || (0.0..=self.size[axis]).contains(&at[axis]))
    }

    /// The image of a point that lies in the rectangle along the axes that wrap.
    #[must_use]
    pub fn folded(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            if !self.wrap[axis] {
                return at[axis];
            }
            let folded = at[axis].rem_euclid(self.size[axis]);
            // The remainder of a tiny negative number is rounded up to the side itself.
            if folded >= self.size[axis] { 0.0 } else { folded }
        })
    }

    /// The shortest of the images of `displacement` across the borders that wrap.
    #[must_use]
    pub fn shortest(&self, displacement: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let side = self.size[axis];
            if self.wrap[axis] {
                displacement[axis] - side * (displacement[axis] / side).round()
            } else {
                displacement[axis]
            }
        })
    }

    /// The shifts, px, by whole sides, with which a box from `low` to `high` meets the box from `window[0]` to `window[1]`. Along
    /// an axis that does not wrap, the only shift is 0.
    #[must_use]
    pub fn images(&self, low: [f64; 2], high: [f64; 2], window: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
        let span = |axis: usize| -> Vec<f64> {
            let side = self.size[axis];
            if !self.wrap[axis] {
                let meets = low[axis] <= window[1][axis] && high[axis] >= window[0][axis];
                return if meets { vec![0.0] } else { Vec::new() };
            }
            let first = ((window[0][axis] - high[axis]) / side).ceil() as i64;
            let last = ((window[1][axis] - low[axis]) / side).floor() as i64;
            (first..=last).map(|image| image as f64 * side).collect()
        };
        let (across, down) = (span(0), span(1));
        down.iter().flat_map(|y| across.iter().map(move |x| [*x, *y])).collect()
    }

    /// Low and high corner of the rectangle, extended by a `margin`, px, along the axes that do not wrap.
    #[must_use]
    pub fn framed(&self, margin: f64) -> [[f64; 2]; 2] {
        let beyond = self.wrap.map(|wrap| if wrap { 0.0 } else { margin });
        [[-beyond[0], -beyond[1]], [self.size[0] + beyond[0], self.size[1] + beyond[1]]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CYLINDER: Extent = Extent { size: [10.0, 6.0], wrap: [true, false] };

    #[test]
    fn one_axis_can_wrap_while_the_other_has_a_border() {
        assert_eq!(CYLINDER.folded([-1.0, -1.0]), [9.0, -1.0]);
        assert_eq!(CYLINDER.shortest([8.0, 5.0]), [-2.0, 5.0]);
        assert!(CYLINDER.contains([-30.0, 6.0]) && !CYLINDER.contains([1.0, 6.5]));
        assert_eq!(CYLINDER.framed(2.0), [[0.0, -2.0], [10.0, 8.0]]);
        assert_eq!(CYLINDER.folded([-1e-20, 0.0]), [0.0, 0.0]);
    }

    #[test]
    fn a_box_at_the_border_has_an_image_at_the_other_side() {
        let window = [[0.0, 0.0], [10.0, 6.0]];
        assert_eq!(CYLINDER.images([8.0, 1.0], [11.0, 2.0], window), [[-10.0, 0.0], [0.0, 0.0]]);
        assert_eq!(CYLINDER.images([4.0, 1.0], [5.0, 2.0], window), [[0.0, 0.0]]);
        assert!(CYLINDER.images([4.0, 7.0], [5.0, 8.0], window).is_empty());
        assert_eq!(CYLINDER.images([-6.0, 0.0], [16.0, 1.0], window).len(), 3);
    }
}
