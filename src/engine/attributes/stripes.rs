//! Lines and paths → mean attributes of a set of stripes.

use super::{Stripes, axial_mean};
use crate::marks::Path;

impl Stripes {
    /// Width ÷ period: the share of the distance from one stripe to the next that is covered, 0..1.
    ///
    /// ```
    /// use dapple_engine::attributes::Stripes;
    ///
    /// let stripes = Stripes { width: 6.0, angle: 0.0, wavelength: Some(20.0) };
    /// assert_eq!(stripes.duty(), 0.3);
    /// ```
    #[must_use]
    pub fn duty(&self) -> f64 {
        self.wavelength.map_or(0.5, |wavelength| self.width / wavelength)
    }

    /// The attributes of a set of paths; `None` of none.
    ///
    /// The width is the plain mean, the angle the axial mean of their segments weighted by length (0 where the
    /// directions cancel). Lines have no wavelength: how far apart they are meant to be is not drawn.
    ///
    /// ```
    /// use dapple_engine::attributes::Stripes;
    /// use dapple_engine::marks::{Line, Path};
    ///
    /// let drawn = [4.0, 8.0].map(|width| Path::from(Line { from: [0.0, 0.0], to: [0.0, 30.0], width }));
    /// let stripes = Stripes::measure(&drawn).unwrap();
    /// assert_eq!((stripes.width, stripes.angle), (6.0, 90.0));
    /// ```
    #[must_use]
    pub fn measure(paths: &[Path]) -> Option<Self> {
        if paths.is_empty() {
            return None;
        }
        let segments = paths.iter().flat_map(Path::segments);
        let directions = segments.map(|segment| (segment.angle(), segment.length()));
        Some(Self {
            width: paths.iter().map(|path| path.width).sum::<f64>() / paths.len() as f64,
            angle: axial_mean(directions).map_or(0.0, |(angle, _)| angle),
            wavelength: None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::Line;

    #[test]
    fn width_is_a_plain_mean_and_direction_is_weighted_by_length() {
        let lines = [
            Line { from: [0.0, 0.0], to: [30.0, 0.0], width: 4.0 },
            Line { from: [7.0, 7.0], to: [7.0, -13.0], width: 8.0 },
            Line { from: [10.0, 10.0], to: [0.0, 0.0], width: 6.0 },
        ]
        .map(Path::from);
        let stripes = Stripes::measure(&lines).unwrap();
        assert_eq!(stripes.width, 6.0);
        // (30 − 20, √200) at the double angle.
        assert!((stripes.angle - 0.5 * 200f64.sqrt().atan2(10.0).to_degrees()).abs() < 1e-9, "{stripes:?}");
    }

    #[test]
    fn crossed_lines_of_one_length_point_along_x_and_none_have_no_attributes() {
        let lines = [
            Line { from: [0.0, 0.0], to: [20.0, 20.0], width: 4.0 },
            Line { from: [0.0, 20.0], to: [20.0, 0.0], width: 4.0 },
        ]
        .map(Path::from);
        assert_eq!(Stripes::measure(&lines).unwrap().angle, 0.0);
        assert_eq!(Stripes::measure(&[]), None);
    }
}
