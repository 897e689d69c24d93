//! The parameters that grow given attributes, looked up without a document.

use crate::attributes::{Attributes, Polarity, Spots};
use crate::learn::{Answer, Coverage, Note, Parameters};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Answers;
use crate::synth::marks::plan::asked::Asked;
use crate::synth::marks::plan::cell_size::cell_for;
use crate::synth::marks::plan::free_spacing::free_spacing;
use crate::synth::marks::plan::layer_lookup::{notes_of_marks, of_marks};
use crate::synth::training::Training;

/// The parameters with which a system grows given attributes.
#[derive(Clone)]
pub struct LookedUp<'a> {
    /// The system.
    pub system: System,
    /// Whether the stripes are the gaps between the lines that these parameters grow, as for stripes that cover more than half of
    /// their period.
    pub inverted: bool,
    /// px a cell of the grid that suits the attributes.
    pub cell: f64,
    /// The spacing that was taken where none was asked for, px.
    pub free_spacing: Option<f64>,
    polarity: Polarity,
    asked: Asked<'a>,
}

impl<'a> LookedUp<'a> {
    /// Looks up the parameters with which `system` grows the `wanted` attributes (px, degrees). If the spacing of `meinhardt-spots`
    /// is free, it is the one that a growth would take.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, Attributes, Spots};
    /// use dapple_engine::rd::System;
    /// use dapple_engine::synth::{LookedUp, Training};
    ///
    /// let spots = Spots { area: 300.0, aspect: 0.6, angle: 30.0, spacing: Some(40.0) };
    /// let looked = LookedUp::new(Training::built_in(), System::MEINHARDT_SPOTS, &Attributes::Spots(spots))?;
    /// assert_eq!(looked.parameters().named()[0].0, "rate");
    /// let area = looked.predict().predicted.get(Attribute::Area).unwrap();
    /// assert!((area / 300.0 - 1.0).abs() < 0.05);
    /// # Ok::<(), dapple_engine::synth::error::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn new(training: &'a Training, system: System, wanted: &Attributes) -> Result<Self, PlanError> {
        let Question { lines, polarity, cell, free_spacing } = Question::new(training, system, wanted);
        let asked = Answers::new(training).ask(system, &lines, cell)?;
        Ok(Self { system, inverted: polarity == Polarity::Negative, cell, free_spacing, polarity, asked })
    }

    /// Parameters on that grid.
    #[must_use]
    pub fn parameters(&self) -> Parameters {
        self.asked.parameters()
    }

    /// Spacing of the spots ÷ the system's own spacing.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        self.asked.pitch()
    }

    /// Whether the question lies within the range of the rows.
    #[must_use]
    pub fn coverage(&self) -> Coverage {
        self.asked.coverage()
    }

    /// Remarks for the user; lengths are px.
    #[must_use]
    pub fn notes(&self) -> Vec<Note> {
        notes_of_marks(self.polarity, &self.asked)
    }

    /// The answer with the predicted attributes, px. If the system grows spots of any spacing, a prediction takes three times as
    /// long as the lookup.
    #[must_use]
    pub fn predict(&self) -> Answer {
        of_marks(self.polarity, self.asked.predict())
    }
}

/// A question to a system.
struct Question {
    /// Spots, or the lines that it grows.
    lines: Attributes,
    polarity: Polarity,
    /// px a cell.
    cell: f64,
    /// The spacing that is taken where none was asked for, px.
    free_spacing: Option<f64>,
}

impl Question {
    fn new(training: &Training, system: System, wanted: &Attributes) -> Self {
        let mut filled = *wanted;
        let mut taken = None;
        if let Attributes::Spots(spots @ Spots { spacing: None, .. }) = &mut filled
            && system.description().free_spacing
        {
            let spacing = free_spacing(training, system, spots);
            spots.spacing = Some(spacing);
            taken = Some(spacing);
        }
        let polarity = match filled {
            Attributes::Stripes(stripes) if system.description().free_spacing => {
                Polarity::of_duty(stripes.duty())
            }
            _ => Polarity::Positive,
        };
        let lines = polarity.lines(&filled);
        Self { cell: cell_for(system, &lines), lines, polarity, free_spacing: taken }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::attributes::Stripes;

    fn wanted() -> impl Strategy<Value = (System, Attributes)> {
        let spots = (
            prop_oneof![Just(System::MEINHARDT_SPOTS), Just(System::TURING_SPOTS)],
            (1.0..12.0_f64, 0.05..=1.0_f64, 0.0..180.0_f64),
            proptest::option::of(0.5..8.0_f64),
        );
        let spots = spots.prop_map(|(system, (side, aspect, angle), apart)| {
            let spacing = apart.map(|apart| apart * side * side);
            (system, Attributes::Spots(Spots { area: side.powi(4), aspect, angle, spacing }))
        });
        let stripes = (
            prop_oneof![Just(System::MEINHARDT_STRIPES), Just(System::MEINHARDT_LINES)],
            (1.0..60.0_f64, 0.0..180.0_f64),
            proptest::option::of(0.1..0.95_f64),
        );
        let stripes = stripes.prop_map(|(system, (width, angle), duty)| {
            let duty = duty.filter(|_| system == System::MEINHARDT_LINES);
            let wavelength = duty.map(|duty| width / duty);
            (system, Attributes::Stripes(Stripes { width, angle, wavelength }))
        });
        prop_oneof![spots, stripes]
    }

    proptest! {
        #[test]
        fn what_is_looked_up_is_what_the_answer_with_a_prediction_says((system, wanted) in wanted()) {
            let looked = LookedUp::new(Training::built_in(), system, &wanted).expect("an answer");
            let Answer { parameters, pitch, coverage, notes, .. } = looked.predict();
            prop_assert_eq!(
                (looked.parameters(), looked.pitch(), looked.coverage(), looked.notes()),
                (parameters, pitch, coverage, notes)
            );
        }
    }
}
