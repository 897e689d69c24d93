//! The attributes of marks by name: the keys of reports, ranges and errors.

use std::fmt;

use serde::{Serialize, Serializer};

use super::Attributes;

/// An attribute of a set of marks. The order is that of the names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Attribute {
    /// Axial mean direction, degrees.
    Angle,
    /// How much directions scatter about the wanted one: root mean square, degrees.
    AngleScatter,
    /// Mean area of a spot.
    Area,
    /// Area ÷ spacing² of spots.
    Density,
    /// Minor ÷ major radius of spots, 0..1.
    Aspect,
    /// Width ÷ wavelength of stripes, 0..1.
    Duty,
    /// Width of the gaps between lines.
    Gap,
    /// Distance from one thread of a weave, or line of a pair, to the next.
    Period,
    /// (Contour ÷ contour of the ellipse with the same area, aspect and direction)²; 1 = smooth.
    Raggedness,
    /// Mean distance of neighbouring spots.
    Spacing,
    /// Distance from one stripe to the next.
    Wavelength,
    /// Mean width of a stripe.
    Width,
}

/// The unit of an attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Cells of the grid, or px.
    Length,
    /// Square cells of the grid, or px².
    Area,
    /// Degrees.
    Angle,
    /// None: a ratio.
    Share,
}

impl Unit {
    /// By what a value is multiplied where all lengths are multiplied by `factor`.
    #[must_use]
    pub const fn scale(self, factor: f64) -> f64 {
        match self {
            Self::Length => factor,
            Self::Area => factor * factor,
            Self::Angle | Self::Share => 1.0,
        }
    }
}

impl Attribute {
    /// All attributes.
    pub const ALL: [Self; 12] = [
        Self::Angle,
        Self::AngleScatter,
        Self::Area,
        Self::Density,
        Self::Aspect,
        Self::Duty,
        Self::Gap,
        Self::Period,
        Self::Raggedness,
        Self::Spacing,
        Self::Wavelength,
        Self::Width,
    ];

    /// Its name in reports and messages.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, Unit};
    ///
    /// assert_eq!(Attribute::AngleScatter.name(), "angle_rms");
    /// assert_eq!(Attribute::Area.unit(), Unit::Area);
    /// ```
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::AngleScatter => "angle_rms",
            Self::Area => "area",
            Self::Density => "area/spacing²",
            Self::Aspect => "aspect",
            Self::Duty => "duty",
            Self::Gap => "gap",
            Self::Period => "period",
            Self::Raggedness => "raggedness",
            Self::Spacing => "spacing",
            Self::Wavelength => "wavelength",
            Self::Width => "width",
        }
    }

    /// Its unit.
    #[must_use]
    pub const fn unit(self) -> Unit {
        match self {
            Self::Angle | Self::AngleScatter => Unit::Angle,
            Self::Area => Unit::Area,
            Self::Density | Self::Aspect | Self::Duty | Self::Raggedness => Unit::Share,
            Self::Gap | Self::Period | Self::Spacing | Self::Wavelength | Self::Width => Unit::Length,
        }
    }
}

impl fmt::Display for Attribute {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The name, so that maps by attribute have its name as key.
impl Serialize for Attribute {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl Attributes {
    /// The attributes that are known, with their values, in the order of reports.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, Attributes, Stripes};
    ///
    /// let stripes = Attributes::Stripes(Stripes { width: 6.0, angle: 30.0, wavelength: None });
    /// assert_eq!(stripes.listed(), [(Attribute::Width, 6.0), (Attribute::Angle, 30.0)]);
    /// ```
    #[must_use]
    pub fn listed(&self) -> Vec<(Attribute, f64)> {
        match self {
            Self::Spots(spots) => {
                let listed = [
                    (Attribute::Area, spots.area),
                    (Attribute::Aspect, spots.aspect),
                    (Attribute::Angle, spots.angle),
                ];
                listed.into_iter().chain(spots.spacing.map(|spacing| (Attribute::Spacing, spacing))).collect()
            }
            Self::Stripes(stripes) => {
                let listed = [(Attribute::Width, stripes.width), (Attribute::Angle, stripes.angle)];
                let wavelength = stripes.wavelength.map(|wavelength| (Attribute::Wavelength, wavelength));
                listed.into_iter().chain(wavelength).collect()
            }
        }
    }

    /// The value of an attribute; `None` where marks of this kind have none, or it is free. Stripes always have a duty.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, Attributes, Spots};
    ///
    /// let spots = Attributes::Spots(Spots { area: 100.0, aspect: 0.5, angle: 0.0, spacing: Some(20.0) });
    /// assert_eq!(spots.get(Attribute::Density), Some(0.25));
    /// assert_eq!(spots.get(Attribute::Width), None);
    /// ```
    #[must_use]
    pub fn get(&self, attribute: Attribute) -> Option<f64> {
        match (attribute, self) {
            (Attribute::Density, Self::Spots(spots)) => {
                spots.spacing.map(|spacing| spots.area / (spacing * spacing))
            }
            (Attribute::Duty, Self::Stripes(stripes)) => Some(stripes.duty()),
            _ => self.listed().into_iter().find(|(of, _)| *of == attribute).map(|(_, value)| value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Attribute;

    #[test]
    fn attributes_are_in_the_order_of_their_names() {
        let names = Attribute::ALL.map(Attribute::name);
        assert!(names.is_sorted() && Attribute::ALL.is_sorted(), "{names:?}");
    }
}
