//! Marks → numbers: drawn and grown marks are measured alike.

mod attribute;
mod attribute_map;
pub mod columns;
pub mod coordinates;
pub mod direction_groups;
pub mod free;
pub mod metric_field;
pub mod modulation;
pub mod moments;
pub mod pair_columns;
pub mod periods;
mod polarity;
pub mod regions;
pub mod spacing;
mod spots;
pub mod spread;
mod stripes;
pub mod system;

pub use attribute::{Attribute, Unit};
pub use attribute_map::AttributeMap;
pub use polarity::Polarity;
pub use spread::Spread;

use serde::{Deserialize, Serialize};

/// Mean attributes of a set of spots.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spots {
    /// Mean area of a spot, px².
    pub area: f64,
    /// Mean minor ÷ major radius, 0..1 (1 = round).
    pub aspect: f64,
    /// Axial mean of the major axes, degrees in [0, 180), weighted by 1 − aspect.
    pub angle: f64,
    /// Weighted mean length of the Delaunay edges between the marks, px; `None` = free: the spacing that the system has by itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spacing: Option<f64>,
}

/// Mean attributes of a set of stripes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stripes {
    /// Mean width of a stripe, px.
    pub width: f64,
    /// Axial mean direction, degrees in [0, 180), weighted by length.
    pub angle: f64,
    /// Distance from one stripe to the next, px; `None` = twice the width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelength: Option<f64>,
}

/// The attributes of a set of marks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Attributes {
    /// Attributes of ellipses.
    Spots(Spots),
    /// Attributes of lines and paths.
    Stripes(Stripes),
}

impl Attributes {
    /// The attributes of the same pattern with all lengths multiplied by `factor` (and areas by its square).
    ///
    /// ```
    /// use dapple_engine::attributes::{Attributes, Spots};
    ///
    /// let spots = Spots { area: 100.0, aspect: 0.5, angle: 30.0, spacing: Some(20.0) };
    /// let doubled = Spots { area: 400.0, spacing: Some(40.0), ..spots };
    /// assert_eq!(Attributes::Spots(spots).scaled(2.0), Attributes::Spots(doubled));
    /// ```
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Spots(spots) => Self::Spots(Spots {
                area: spots.area * factor * factor,
                spacing: spots.spacing.map(|spacing| spacing * factor),
                ..spots
            }),
            Self::Stripes(stripes) => Self::Stripes(Stripes {
                width: stripes.width * factor,
                wavelength: stripes.wavelength.map(|wavelength| wavelength * factor),
                ..stripes
            }),
        }
    }

    /// The distance from one mark to the next, px: the spacing of spots, the wavelength of stripes; `None` where it is free.
    #[must_use]
    pub fn distance(&self) -> Option<f64> {
        match self {
            Self::Spots(spots) => spots.spacing,
            Self::Stripes(stripes) => stripes.wavelength,
        }
    }

    /// Its direction, degrees in [0, 180).
    #[must_use]
    pub fn angle(&self) -> f64 {
        match self {
            Self::Spots(spots) => spots.angle,
            Self::Stripes(stripes) => stripes.angle,
        }
    }
}

/// Axial mean of angles (degrees) under weights, with its double-angle resultant length 0..1.
///
/// Mean of (cos 2θ, sin 2θ), half its direction. `None` where all weights are 0 or the directions cancel.
///
/// ```
/// use dapple_engine::attributes::axial_mean;
///
/// let (angle, _) = axial_mean([(170.0, 1.0), (10.0, 1.0)]).unwrap();
/// assert!(angle.min(180.0 - angle) < 1e-9);
/// ```
#[must_use]
pub fn axial_mean(angles: impl IntoIterator<Item = (f64, f64)>) -> Option<(f64, f64)> {
    let (mut c, mut s, mut total) = (0.0, 0.0, 0.0);
    for (angle, weight) in angles {
        let double = (2.0 * angle).to_radians();
        c += weight * libm::cos(double);
        s += weight * libm::sin(double);
        total += weight;
    }
    let length = (c * c + s * s).sqrt();
    if total <= 0.0 || length <= 1e-12 * total {
        return None;
    }
    Some((crate::marks::axial(0.5 * libm::atan2(s, c).to_degrees()), length / total))
}
