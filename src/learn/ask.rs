//! Asking a training set.

use super::Parameters;
use super::answer::{Answer, AskError, Prediction, checked};
use super::training_set::{Map, TrainingSet};
use crate::attributes::Attributes;

impl TrainingSet {
    /// The parameters that give `wanted` (lengths in cells, angles any finite degrees).
    ///
    /// A question beyond the rows is moved to the nearest place within them first, so the parameters are
    /// always ones that grow a texture like those of the set; `coverage`, `nearest` and `notes` say so.
    ///
    /// # Errors
    /// [`AskError`]: attributes of the other kind, or not finite, or not positive.
    pub fn ask(&self, wanted: &Attributes) -> Result<Answer, AskError> {
        let reached = match (&self.map, &checked(wanted)?) {
            (Map::Spots(map), Attributes::Spots(spots)) => map.ask(spots),
            (Map::Stripes(map), Attributes::Stripes(stripes)) => map.ask(stripes),
            (Map::Spots(_), _) => return Err(self.other_kind("area, aspect, angle and perhaps spacing")),
            (Map::Stripes(_), _) => return Err(self.other_kind("width, angle and perhaps wavelength")),
        };
        Ok(Answer {
            parameters: reached.parameters,
            pitch: 1.0,
            predicted: reached.prediction.attributes,
            interval: reached.prediction.interval,
            coverage: reached.judgement.coverage,
            nearest: reached.nearest,
            notes: reached.judgement.notes,
        })
    }

    /// The parameters that [`Self::ask`] answers with, and the nearest question that can be answered, without what they are
    /// predicted to grow.
    ///
    /// # Errors
    /// As [`Self::ask`].
    pub fn parameters_for(&self, wanted: &Attributes) -> Result<(Parameters, Attributes), AskError> {
        if let (Map::Spots(map), Attributes::Spots(spots)) = (&self.map, &checked(wanted)?) {
            let map = map.map(spots.aspect);
            // Where the system determines the spacing, it is predicted.
            if map.dense() {
                let (parameters, nearest, _) = map.reach(spots);
                return Ok((parameters, Attributes::Spots(nearest)));
            }
        }
        self.ask(wanted).map(|answer| (answer.parameters, answer.nearest))
    }

    fn other_kind(&self, takes: &'static str) -> AskError {
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
