//! What answers a question.

use std::sync::OnceLock;

use super::answer::{Answer, Prediction};
use super::coverage::{Coverage, Judgement};
use super::training_set::TrainingSet;
use super::{Note, Parameters};
use crate::attributes::Attributes;

/// What answers a question, without what it is predicted to grow: where spots may have any spacing, to predict takes three quarters of
/// the time of an answer. Lengths are cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The parameters of the simulation.
    pub parameters: Parameters,
    /// Spacing of the spots ÷ the spacing that the system gives them by itself; 1 = its own.
    pub pitch: f64,
    /// Whether the question lies within the range of the rows.
    pub coverage: Coverage,
    /// The nearest question within the rows; the question itself where it is within.
    pub nearest: Attributes,
    /// Remarks for the user.
    pub notes: Vec<Note>,
    /// What it is predicted to grow, once that is known.
    pub(super) prediction: OnceLock<Prediction>,
}

impl Found {
    /// The parameters for the question `nearest`, of marks as near to each other as their system puts them by itself.
    pub(super) fn judged(parameters: Parameters, nearest: Attributes, judgement: Judgement) -> Self {
        let Judgement { coverage, notes } = judgement;
        Self { parameters, pitch: 1.0, coverage, nearest, notes, prediction: OnceLock::new() }
    }

    /// The answer with what these parameters are predicted to grow; `set` is the one that was asked.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attributes, Spots};
    /// use dapple_engine::rd::System;
    /// use dapple_engine::synth::Training;
    ///
    /// let set = Training::built_in().set(System::MEINHARDT_SPOTS)?;
    /// let wanted = Spots { area: 60.0, aspect: 0.6, angle: 30.0, spacing: Some(25.0) };
    /// let found = set.ask(&Attributes::Spots(wanted))?;
    /// let Attributes::Spots(predicted) = found.predict(set).predicted else { unreachable!("spots were asked for") };
    /// assert!((predicted.area / wanted.area - 1.0).abs() < 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn predict(&self, set: &TrainingSet) -> Answer {
        let prediction = self.prediction.get_or_init(|| set.predict(&self.parameters));
        Answer::of(self, prediction)
    }
}
