//! Answers of a training set, and errors in questions.

use super::coverage::Coverage;
use super::in_cells::{InCells, Lengths};
use super::{Note, Parameters};
use crate::attributes::{Attribute, Attributes, Spots, Stripes};
use crate::marks::axial;

/// Half the width of a 90 % interval in standard deviations of a normal distribution.
pub(super) const Z90: f64 = 1.645;

/// The answer to wanted attributes. Parameters are in cells; all other lengths are px, or cells in an [`InCells`].
#[derive(Clone, Debug)]
pub struct Answer {
    /// The parameters of the simulation.
    pub parameters: Parameters,
    /// Spacing of the spots ÷ the system's own spacing.
    pub pitch: f64,
    /// The attributes of the marks that these parameters are predicted to grow; spots always with their spacing, lines with their
    /// wavelength.
    pub predicted: Attributes,
    /// The 90 % interval of each attribute, for a patch like those of the set.
    /// Angles are degrees about the predicted one and may leave 0..180.
    pub interval: Vec<(Attribute, [f64; 2])>,
    /// Whether the question lies within the range of the rows.
    pub coverage: Coverage,
    /// The nearest question within the rows; equal to the question if that is within.
    pub nearest: Attributes,
    /// Remarks for the user.
    pub notes: Vec<Note>,
}

impl Answer {
    /// The answer of a law: it holds for the question itself, and no rows say how exactly.
    #[must_use]
    pub fn of_law(parameters: Parameters, wanted: Attributes) -> Self {
        Self {
            parameters,
            predicted: wanted,
            interval: Vec::new(),
            coverage: Coverage::Inside,
            nearest: wanted,
            notes: Vec::new(),
            pitch: 1.0,
        }
    }
}

impl Lengths for Answer {
    fn scaled(self, factor: f64) -> Self {
        Self {
            predicted: self.predicted.scaled(factor),
            interval: self.interval.scaled(factor),
            nearest: self.nearest.scaled(factor),
            notes: self.notes.scaled(factor),
            ..self
        }
    }
}

/// The attributes that parameters are predicted to grow.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// The attributes; spots always with their spacing.
    pub attributes: Attributes,
    /// For each attribute its 90 % range, as in [`Answer::interval`].
    pub interval: Vec<(Attribute, [f64; 2])>,
}

impl Prediction {
    /// Half the interval of a length or an area, in ln units.
    pub(super) fn half_width(&self, attribute: Attribute) -> f64 {
        let found = self.interval.iter().find(|(of, _)| *of == attribute);
        found.map_or(0.0, |(_, [low, high])| 0.5 * (libm::log(*high) - libm::log(*low)))
    }
}

/// The reason why a question cannot be asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AskError {
    /// A question about stripes to a spot set, or about spots to a stripe set.
    #[error("{system} takes {takes}")]
    OtherKind {
        /// The set's system.
        system: &'static str,
        /// The attributes that it takes.
        takes: &'static str,
    },
    /// The value of an attribute is out of range.
    #[error("{attribute} {value} is not {allowed}")]
    Value {
        /// The attribute.
        attribute: Attribute,
        /// Its value.
        value: f64,
        /// The allowed values.
        allowed: &'static str,
    },
}

fn length(attribute: Attribute, value: f64) -> Result<f64, AskError> {
    let allowed = "a finite number above 0";
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(AskError::Value { attribute, value, allowed })
    }
}

fn angle(value: f64) -> Result<f64, AskError> {
    let (attribute, allowed) = (Attribute::Angle, "a finite number of degrees");
    if value.is_finite() { Ok(axial(value)) } else { Err(AskError::Value { attribute, value, allowed }) }
}

fn aspect(value: f64) -> Result<f64, AskError> {
    let (attribute, allowed) = (Attribute::Aspect, "above 0 and at most 1");
    if value > 0.0 && value <= 1.0 { Ok(value) } else { Err(AskError::Value { attribute, value, allowed }) }
}

fn checked_spots(spots: &Spots) -> Result<Spots, AskError> {
    Ok(Spots {
        area: length(Attribute::Area, spots.area)?,
        aspect: aspect(spots.aspect)?,
        angle: angle(spots.angle)?,
        spacing: spots.spacing.map(|spacing| length(Attribute::Spacing, spacing)).transpose()?,
    })
}

/// The attributes of a question, in cells, with their angle in [0, 180).
///
/// # Errors
/// [`AskError::Value`]: a value out of its range.
pub(super) fn checked(InCells(attributes): &InCells<Attributes>) -> Result<Attributes, AskError> {
    Ok(match attributes {
        Attributes::Spots(spots) => Attributes::Spots(checked_spots(spots)?),
        Attributes::Stripes(stripes) => Attributes::Stripes(Stripes {
            width: length(Attribute::Width, stripes.width)?,
            angle: angle(stripes.angle)?,
            wavelength: stripes
                .wavelength
                .map(|wavelength| length(Attribute::Wavelength, wavelength))
                .transpose()?,
        }),
    })
}
