//! The parameters that grow given attributes, without a document.

use crate::attributes::{Attributes, Polarity, Spots};
use crate::learn::{Answer, Found};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::layer_lookup::of_marks;
use crate::synth::marks::plan::lookup::{ask, cell_for, find, free_spacing};
use crate::synth::training::Training;

/// The parameters with which a system grows given attributes, and what is expected of them.
#[derive(Clone, Debug)]
pub struct LookedUp<A = Answer> {
    /// The system.
    pub system: System,
    /// Whether stripes are the gaps between the lines that these parameters grow: those that cover more than half of their
    /// period.
    pub inverted: bool,
    /// px a cell of the grid that suits the attributes.
    pub cell: f64,
    /// The spacing that was taken where none was asked for, px.
    pub free_spacing: Option<f64>,
    /// Parameters on that grid; attributes in px.
    pub answer: A,
}

impl LookedUp {
    /// Looks up the parameters with which `system` grows what is `wanted` (px, degrees). A spacing that
    /// `meinhardt-spots` is left free to choose is the one that growing takes then.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attributes, Spots};
    /// use dapple_engine::rd::System;
    /// use dapple_engine::synth::{LookedUp, Training};
    ///
    /// let spots = Spots { area: 300.0, aspect: 0.6, angle: 30.0, spacing: Some(40.0) };
    /// let looked = LookedUp::new(Training::built_in(), System::MEINHARDT_SPOTS, &Attributes::Spots(spots))?;
    /// assert_eq!(looked.answer.parameters.named()[0].0, "rate");
    /// # Ok::<(), dapple_engine::synth::error::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn new(training: &Training, system: System, wanted: &Attributes) -> Result<Self, PlanError> {
        let Question { lines, polarity, cell, free_spacing } = Question::new(training, system, wanted);
        let answer = of_marks(polarity, ask(training, system, &lines, cell)?);
        Ok(Self { system, inverted: polarity == Polarity::Negative, cell, free_spacing, answer })
    }
}

impl LookedUp<Found> {
    /// As [`LookedUp::new`], without what is predicted to grow. Where the system grows spots of any spacing this takes a
    /// quarter of the time.
    ///
    /// # Errors
    /// As [`LookedUp::new`].
    pub fn unpredicted(training: &Training, system: System, wanted: &Attributes) -> Result<Self, PlanError> {
        let Question { lines, polarity, cell, free_spacing } = Question::new(training, system, wanted);
        let found = find(training, system, &lines, cell)?;
        let inverted = polarity == Polarity::Negative;
        let answer = if inverted { found.of_gaps() } else { found };
        Ok(Self { system, inverted, cell, free_spacing, answer })
    }
}

/// What a system is asked for.
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
        fn what_is_found_without_a_prediction_is_what_the_answer_says((system, wanted) in wanted()) {
            let training = Training::built_in();
            let answer = LookedUp::new(training, system, &wanted).expect("an answer");
            let found = LookedUp::unpredicted(training, system, &wanted).expect("an answer");
            prop_assert_eq!(&found.answer, &Found::from(answer.answer));
            prop_assert_eq!(
                (found.system, found.inverted, found.cell, found.free_spacing),
                (answer.system, answer.inverted, answer.cell, answer.free_spacing)
            );
        }
    }
}
