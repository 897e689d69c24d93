//! Ellipses → mean attributes of a set of spots.

use super::{Spots, axial_mean, spacing::mean_spacing};
use crate::marks::Ellipse;

impl Spots {
    /// The attributes of a set of ellipses; `None` of none.
    ///
    /// Area and aspect are plain means, the angle is the axial mean of the major axes weighted by
    /// 1 − aspect (0 where they have no direction: all round, or cancelling), the spacing that of the
    /// centres (`None` of one ellipse: free).
    ///
    /// ```
    /// use dapple_engine::attributes::Spots;
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let drawn = [30.0, 60.0].map(|x| Ellipse::from_area([x, 40.0], 200.0, 0.6, 45.0));
    /// let spots = Spots::measure(&drawn).unwrap();
    /// assert!((spots.area - 200.0).abs() < 1e-9 && (spots.angle - 45.0).abs() < 1e-9);
    /// assert_eq!(spots.spacing, Some(30.0));
    /// ```
    #[must_use]
    pub fn measure(ellipses: &[Ellipse]) -> Option<Self> {
        if ellipses.is_empty() {
            return None;
        }
        let n = ellipses.len() as f64;
        let axes = ellipses.iter().map(|ellipse| (ellipse.major_angle(), 1.0 - ellipse.aspect()));
        let centers: Vec<_> = ellipses.iter().map(|ellipse| ellipse.center).collect();
        Some(Self {
            area: ellipses.iter().map(Ellipse::area).sum::<f64>() / n,
            aspect: ellipses.iter().map(Ellipse::aspect).sum::<f64>() / n,
            angle: axial_mean(axes).map_or(0.0, |(angle, _)| angle),
            spacing: mean_spacing(&centers),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn ellipse(center: [f64; 2], radii: [f64; 2], angle: f64) -> Ellipse {
        Ellipse { center, radii, angle }
    }

    #[test]
    fn area_and_aspect_are_plain_means_over_the_ellipses() {
        let spots =
            Spots::measure(&[ellipse([0.0, 0.0], [4.0, 2.0], 0.0), ellipse([30.0, 0.0], [6.0, 6.0], 77.0)])
                .unwrap();
        assert!((spots.area - PI * (8.0 + 36.0) / 2.0).abs() < 1e-12);
        assert_eq!(spots.aspect, 0.75);
    }

    #[test]
    fn a_round_ellipse_does_not_change_the_mean_direction() {
        let spots =
            Spots::measure(&[ellipse([0.0, 0.0], [4.0, 2.0], 170.0), ellipse([30.0, 0.0], [6.0, 6.0], 77.0)])
                .unwrap();
        assert!((spots.angle - 170.0).abs() < 1e-9);
    }

    #[test]
    fn directions_are_weighted_by_elongation_and_read_across_180_degrees() {
        // Weights 0.5 and 0.5 at 170° and 10°: 0°, not 90°.
        let pair = [ellipse([0.0; 2], [4.0, 2.0], 170.0), ellipse([9.0, 0.0], [1.0, 2.0], -80.0)];
        let spots = Spots::measure(&pair).unwrap();
        assert!(spots.angle.min(180.0 - spots.angle) < 1e-9, "{spots:?}");
        // Weights 0.75 at 0° and 0.25 at 45°: half of atan2(0.25, 0.75).
        let pair = [ellipse([0.0; 2], [4.0, 1.0], 0.0), ellipse([9.0, 0.0], [4.0, 3.0], 45.0)];
        let spots = Spots::measure(&pair).unwrap();
        assert!((spots.angle - 0.5 * (1.0f64 / 3.0).atan().to_degrees()).abs() < 1e-9);
    }

    #[test]
    fn spots_without_a_direction_point_along_x() {
        assert_eq!(Spots::measure(&[ellipse([0.0; 2], [3.0, 3.0], 40.0)]).unwrap().angle, 0.0);
        let cross = [ellipse([0.0; 2], [4.0, 2.0], 40.0), ellipse([9.0, 0.0], [4.0, 2.0], 130.0)];
        assert_eq!(Spots::measure(&cross).unwrap().angle, 0.0);
    }

    #[test]
    fn a_lone_spot_has_a_free_spacing_and_none_have_no_attributes() {
        assert_eq!(Spots::measure(&[ellipse([0.0; 2], [3.0, 2.0], 40.0)]).unwrap().spacing, None);
        assert_eq!(Spots::measure(&[]), None);
    }
}
