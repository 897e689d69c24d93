//! Training sets by system: built in, or from a folder of the user's.

use std::path::PathBuf;
use std::sync::OnceLock;

use crate::learn::{Row, TrainingError, TrainingSet};
use crate::rd::System;

/// The training sets that a growth asks, each read when first asked.
#[derive(Default)]
pub struct Training {
    folder: Option<PathBuf>,
    sets: [OnceLock<TrainingSet>; System::ALL.len()],
}

impl Training {
    /// The sets in `folder`, or the built-in ones.
    #[must_use]
    pub fn from(folder: Option<PathBuf>) -> Self {
        Self { folder, sets: Default::default() }
    }

    /// Only these rows of `system`; the built-in sets of the others.
    ///
    /// # Errors
    /// Too few rows, or not of this system.
    pub fn of_rows(system: System, rows: Vec<Row>) -> Result<Self, TrainingError> {
        let training = Self::default();
        let set = TrainingSet::from_rows(system.name(), rows)?;
        training.sets[system as usize].get_or_init(|| set);
        Ok(training)
    }

    /// The set of `system`.
    ///
    /// # Errors
    /// The file is missing or wrong: which one, where, what is allowed.
    pub fn of(&self, system: System) -> Result<&TrainingSet, TrainingError> {
        let slot = &self.sets[system as usize];
        if let Some(set) = slot.get() {
            return Ok(set);
        }
        let set = match &self.folder {
            Some(folder) => TrainingSet::load(folder, system.name())?,
            None => TrainingSet::embedded(system.name())?,
        };
        Ok(slot.get_or_init(|| set))
    }
}
