//! The methods, from attributes to parameters, that are compared.

use crate::attributes::Attributes;
use crate::cli::Error;
use crate::learn::{Coverage, InCells, Method, Note, Parameters};
use crate::rd::System;
use crate::synth::marks::grow::probe::{ProbeError, When, probed};
use crate::synth::marks::plan::Answers;
use crate::synth::{Training, Watch};

/// A method that finds parameters for attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// From the training rows alone.
    Learnt(Method),
    /// By local regression, corrected by growths of a patch; the level of the growth is then corrected. `dapple grow`
    /// does this.
    Refined,
}

impl Way {
    /// The method of `dapple grow --no-refine`.
    pub const REGRESSION: Self = Self::Learnt(Method::LocalRegression);

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Learnt(method) => method.name(),
            Self::Refined => "LWR + refinement",
        }
    }

    /// The parameters, in cells, for `wanted` (px) on a grid of `cell` px a cell.
    pub fn parameters(
        self,
        training: &Training,
        system: System,
        wanted: &Attributes,
        cell: f64,
        when: When,
        watch: &Watch,
    ) -> Result<Parameters, Error> {
        let answers = Answers::new(training);
        let asked = |wanted| answers.ask(system, wanted, cell).map_err(Error::step);
        match self {
            Self::REGRESSION => Ok(asked(wanted)?.parameters()),
            Self::Learnt(method) => {
                let set = training.set(system).map_err(Error::step)?;
                set.by(method, &InCells::from_px(*wanted, cell)).map_err(Error::step)
            }
            Self::Refined => {
                let found = probed(training, system, std::slice::from_ref(wanted), cell, when, watch);
                let found = found.map_err(|error| match error {
                    ProbeError::Cancelled(_) => Error::Interrupted,
                    other => Error::step(other),
                })?;
                let corrected = found.iter().map(|found| found.offset.applied(-1.0, wanted)).next();
                Ok(asked(&corrected.unwrap_or(*wanted))?.parameters())
            }
        }
    }

    /// Why there is no answer for `wanted`: it is outside the training set, or was moved into it. `None` if there is an
    /// answer, or if the method has no limits.
    pub fn refusal(
        self,
        training: &Training,
        system: System,
        wanted: &Attributes,
        cell: f64,
    ) -> Result<Option<String>, Error> {
        if !matches!(self, Self::REGRESSION | Self::Refined) {
            return Ok(None);
        }
        let asked = Answers::new(training).ask(system, wanted, cell).map_err(Error::step)?;
        let moved: Vec<String> = asked
            .notes()
            .iter()
            .filter(|note| matches!(note, Note::Beyond { .. } | Note::Together { .. }))
            .map(ToString::to_string)
            .collect();
        Ok((asked.coverage() == Coverage::Outside || !moved.is_empty()).then(|| moved.join("; ")))
    }
}
