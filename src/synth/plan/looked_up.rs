//! The parameters that grow given attributes, without a document.

use crate::attributes::{Attributes, Polarity, Spots};
use crate::learn::Answer;
use crate::rd::System;
use crate::synth::plan::error::PlanError;
use crate::synth::plan::layer_lookup::of_marks;
use crate::synth::plan::lookup::{ask, cell_for, free_spacing};
use crate::synth::training::Training;

/// The parameters with which a system grows given attributes, and what is expected of them.
#[derive(Clone, Debug)]
pub struct LookedUp {
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
    pub answer: Answer,
}

impl LookedUp {
    /// Looks up the parameters with which `system` grows what is `wanted` (px, degrees). A spacing that
    /// `meinhardt-spots` is left free to choose is the one that growing takes then.
    ///
    /// ```
    /// use dapple::lookup::{Attributes, LookedUp, Spots, System, Training};
    ///
    /// let spots = Spots { area: 300.0, aspect: 0.6, angle: 30.0, spacing: Some(40.0) };
    /// let found = LookedUp::new(Training::built_in(), System::MEINHARDT_SPOTS, &Attributes::Spots(spots))?;
    /// assert_eq!(found.answer.parameters.named()[0].0, "rate");
    /// # Ok::<(), dapple::lookup::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn new(training: &Training, system: System, wanted: &Attributes) -> Result<Self, PlanError> {
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
        let cell = cell_for(system, &lines);
        let answer = of_marks(polarity, ask(training, system, &lines, cell)?);
        let inverted = polarity == Polarity::Negative;
        Ok(Self { system, inverted, cell, free_spacing: taken, answer })
    }
}
