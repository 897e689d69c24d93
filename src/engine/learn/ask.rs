//! Questions to a training set.

use super::answer::{Answer, AskError, Prediction, checked};
use super::training_set::{Regressions, TrainingSet};
use super::{Found, InCells, Parameters};
use crate::attributes::Attributes;

impl TrainingSet {
    /// The parameters that give `wanted` (angles any finite degrees). The predicted attributes are computed only on request:
    /// [`Found::predict`].
    ///
    /// A question beyond the rows is first moved to the nearest place within them, so that the parameters always grow a texture
    /// like those of the set; `coverage`, `nearest` and `notes` tell whether it was moved.
    ///
    /// # Errors
    /// [`AskError`]: attributes of the other kind, or not finite, or not positive.
    pub fn ask(&self, wanted: &InCells<Attributes>) -> Result<Found, AskError> {
        match (&self.map, &checked(wanted)?) {
            (Regressions::Spots(map), Attributes::Spots(spots)) => Ok(map.map(spots.aspect).ask(spots)),
            (Regressions::Stripes(map), Attributes::Stripes(stripes)) => Ok(map.ask(stripes)),
            _ => Err(self.other_kind()),
        }
    }

    fn other_kind(&self) -> AskError {
        let takes = match self.map {
            Regressions::Spots(_) => "area, aspect, angle and perhaps spacing",
            Regressions::Stripes(_) => "width, angle and perhaps wavelength",
        };
        AskError::OtherKind { system: self.system().name, takes }
    }

    /// Predicts the attributes that `parameters` grow.
    ///
    /// Meant for parameters like those of the rows; far from them the regression of the nearest rows is clamped.
    #[must_use]
    pub fn predict(&self, parameters: &Parameters) -> InCells<Prediction> {
        InCells(match &self.map {
            Regressions::Spots(map) => map.predict(parameters),
            Regressions::Stripes(map) => map.predict(parameters),
        })
    }
}

impl Found {
    /// The answer with the predicted attributes; `set` is the training set that was asked.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, Attributes, Spots};
    /// use dapple_engine::learn::InCells;
    /// use dapple_engine::rd::System;
    /// use dapple_engine::synth::Training;
    ///
    /// let set = Training::built_in().set(System::MEINHARDT_SPOTS)?;
    /// let wanted = Spots { area: 60.0, aspect: 0.6, angle: 30.0, spacing: Some(25.0) };
    /// let found = set.ask(&InCells(Attributes::Spots(wanted)))?;
    /// let InCells(answer) = found.predict(set);
    /// let area = answer.predicted.get(Attribute::Area).unwrap();
    /// assert!((area / wanted.area - 1.0).abs() < 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn predict(&self, set: &TrainingSet) -> InCells<Answer> {
        let prediction = self.prediction.get_or_init(|| set.predict(&self.parameters));
        let InCells(Prediction { attributes: predicted, interval }) = prediction.clone();
        let Self { parameters, pitch, coverage, nearest: InCells(nearest), notes: InCells(notes), .. } =
            self.clone();
        InCells(Answer { parameters, pitch, predicted, interval, coverage, nearest, notes })
    }
}
