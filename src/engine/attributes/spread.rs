//! How much the spots of a set vary: drawn and grown ones are measured alike.

use serde::{Deserialize, Serialize};

use super::moments::{deviation, variation, weighted_variation};
use super::spacing::neighbours;
use super::{Attribute, axial_mean};
use crate::marks::{Ellipse, turn};

/// How much spots vary about their means; 0 = all the same. Standard deviations are those of the set itself (Σ ÷ n).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Coefficient of variation of the area: standard deviation ÷ mean.
    pub area: f64,
    /// Root mean square turn of the major axes from their axial mean, degrees, weighted by 1 − aspect. Directions
    /// that are uniformly distributed have 90/√3 = 52°.
    pub angle: f64,
    /// Standard deviation of minor ÷ major radius.
    pub aspect: f64,
    /// Weighted coefficient of variation of the Delaunay edges, with the weights that they have in the spacing.
    pub spacing: f64,
}

/// The spread of uniformly distributed directions, 90/√3 degrees.
const UNIFORM: f64 = 51.961_524_227_066_32;

impl Spread {
    /// No variation.
    pub const ZERO: Self = Self { area: 0.0, angle: 0.0, aspect: 0.0, spacing: 0.0 };

    /// How much a set of ellipses varies.
    ///
    /// ```
    /// use dapple_engine::attributes::Spread;
    /// use dapple_engine::marks::Ellipse;
    ///
    /// let alike = [20.0, 50.0, 80.0].map(|x| Ellipse::from_area([x, 40.0], 200.0, 0.6, 45.0));
    /// assert!(Spread::measure(&alike).area < 1e-9);
    /// ```
    #[must_use]
    pub fn measure(ellipses: &[Ellipse]) -> Self {
        let axes = ellipses.iter().map(|ellipse| (ellipse.major_angle(), 1.0 - ellipse.aspect()));
        let centers: Vec<[f64; 2]> = ellipses.iter().map(|ellipse| ellipse.center).collect();
        Self {
            area: variation(ellipses.iter().map(Ellipse::area)),
            angle: scatter(axes),
            aspect: deviation(ellipses.iter().map(Ellipse::aspect)),
            spacing: weighted_variation(
                neighbours(&centers, None).iter().map(|edge| (edge.length, edge.weight)),
            ),
        }
    }

    /// Whether nothing varies, except for rounding.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.named().iter().all(|(_, value)| *value < 1e-6)
    }

    /// Its numbers with the names they have in documents and reports.
    #[must_use]
    pub fn named(&self) -> [(Attribute, f64); 4] {
        [
            (Attribute::Area, self.area),
            (Attribute::Angle, self.angle),
            (Attribute::Aspect, self.aspect),
            (Attribute::Spacing, self.spacing),
        ]
    }

    /// The numbers of both, combined one by one by `join`.
    #[must_use]
    pub fn with(&self, other: &Self, join: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            area: join(self.area, other.area),
            angle: join(self.angle, other.angle),
            aspect: join(self.aspect, other.aspect),
            spacing: join(self.spacing, other.spacing),
        }
    }
}

/// Root mean square turn of axial angles (degrees) from their axial mean, under weights; 0 without any weight.
#[must_use]
pub fn scatter(angles: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let angles: Vec<(f64, f64)> = angles.into_iter().collect();
    let total: f64 = angles.iter().map(|(_, weight)| weight).sum();
    if total <= 0.0 {
        return 0.0;
    }
    let Some((mean, _)) = axial_mean(angles.iter().copied()) else { return UNIFORM };
    let square = |(angle, weight): &(f64, f64)| weight * turn(*angle, mean) * turn(*angle, mean);
    (angles.iter().map(square).sum::<f64>() / total).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ellipse(x: f64, area: f64, aspect: f64, angle: f64) -> Ellipse {
        Ellipse::from_area([x, 0.0], area, aspect, angle)
    }

    #[test]
    fn ellipses_that_are_alike_have_no_spread() {
        let spread = Spread::measure(&[
            ellipse(0.0, 30.0, 0.5, 20.0),
            ellipse(9.0, 30.0, 0.5, 20.0),
            ellipse(18.0, 30.0, 0.5, 20.0),
        ]);
        assert!(spread.named().iter().all(|(_, value)| *value < 1e-6), "{spread:?}");
        assert_eq!(Spread::measure(&[]), Spread::ZERO);
    }

    #[test]
    fn two_ellipses_differ_by_half_of_their_difference() {
        let spread = Spread::measure(&[ellipse(0.0, 80.0, 0.4, 170.0), ellipse(9.0, 120.0, 0.4, 10.0)]);
        assert!((spread.area - 0.2).abs() < 1e-9 && spread.aspect < 1e-9, "{spread:?}");
        assert!((spread.angle - 10.0).abs() < 1e-9 && spread.spacing == 0.0, "{spread:?}");
        let spread = Spread::measure(&[ellipse(0.0, 80.0, 0.4, 0.0), ellipse(9.0, 80.0, 0.6, 0.0)]);
        assert!((spread.aspect - 0.1).abs() < 1e-9 && spread.area < 1e-9, "{spread:?}");
    }

    #[test]
    fn a_round_ellipse_does_not_change_the_scatter_of_directions() {
        let pair = [ellipse(0.0, 50.0, 0.4, 10.0), ellipse(9.0, 50.0, 0.4, 30.0)];
        let with_round = [pair[0], pair[1], ellipse(20.0, 50.0, 1.0, 80.0)];
        assert!((Spread::measure(&pair).angle - Spread::measure(&with_round).angle).abs() < 1e-6);
        assert_eq!(Spread::measure(&[with_round[2]; 3]).angle, 0.0);
    }

    #[test]
    fn directions_that_cancel_count_as_uniform() {
        assert_eq!(scatter([(40.0, 1.0), (130.0, 1.0)]), UNIFORM);
        let even =
            scatter((0..180).map(|degree| (f64::from(degree) + if degree == 0 { 1e-3 } else { 0.0 }, 1.0)));
        assert!((even - UNIFORM).abs() < 0.1, "{even}");
    }

    #[test]
    fn the_spacing_varies_as_the_edges_that_count() {
        // In a row: 8 and 12 have full weight, 60 is over 3.5 times the median distance to the nearest.
        let places = [0.0, 8.0, 20.0, 28.0, 40.0, 100.0];
        let spread = Spread::measure(&places.map(|x| ellipse(x, 10.0, 0.5, 0.0)));
        assert!((spread.spacing - 0.2).abs() < 1e-9, "{spread:?}");
    }
}
