//! Asking a training set.

use super::answer::{AskError, Prediction, checked};
use super::training_set::{Map, TrainingSet};
use super::{Found, Parameters};
use crate::attributes::Attributes;

impl TrainingSet {
    /// The parameters that give `wanted` (lengths in cells, angles any finite degrees). What they are predicted to grow is computed
    /// where it is asked for: [`Found::predict`].
    ///
    /// A question beyond the rows is moved to the nearest place within them first, so the parameters are
    /// always ones that grow a texture like those of the set; `coverage`, `nearest` and `notes` say so.
    ///
    /// # Errors
    /// [`AskError`]: attributes of the other kind, or not finite, or not positive.
    pub fn ask(&self, wanted: &Attributes) -> Result<Found, AskError> {
        match (&self.map, &checked(wanted)?) {
            (Map::Spots(map), Attributes::Spots(spots)) => Ok(map.map(spots.aspect).ask(spots)),
            (Map::Stripes(map), Attributes::Stripes(stripes)) => Ok(map.ask(stripes)),
            _ => Err(self.other_kind()),
        }
    }

    fn other_kind(&self) -> AskError {
        let takes = match self.map {
            Map::Spots(_) => "area, aspect, angle and perhaps spacing",
            Map::Stripes(_) => "width, angle and perhaps wavelength",
        };
        AskError::OtherKind { system: self.system().name, takes }
    }

    /// Predicts what `parameters` grow.
    ///
    /// Meant for parameters like those of the rows; far from them the regression of the nearest rows is clamped.
    #[must_use]
    pub fn predict(&self, parameters: &Parameters) -> Prediction {
        match &self.map {
            Map::Spots(map) => map.predict(parameters),
            Map::Stripes(map) => map.predict(parameters),
        }
    }
}
