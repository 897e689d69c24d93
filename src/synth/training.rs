//! Training sets by system: built in, or from a folder of the user's.

use std::path::PathBuf;
use std::sync::OnceLock;

use crate::learn::{Row, TrainingError, TrainingSet};
use crate::rd::System;

/// The training sets of all systems. Each is read when it is first needed.
pub struct Training {
    folder: Option<PathBuf>,
    sets: [OnceLock<TrainingSet>; System::ALL.len()],
}

/// The built-in sets, read once in a process.
static BUILT_IN: Training = Training::new(None);

impl Training {
    const fn new(folder: Option<PathBuf>) -> Self {
        Self { folder, sets: [const { OnceLock::new() }; System::ALL.len()] }
    }

    /// The built-in sets, shared by all who ask for them.
    #[must_use]
    pub fn built_in() -> &'static Self {
        &BUILT_IN
    }

    /// The sets in `folder`; without one, the built-in ones.
    #[must_use]
    pub const fn from_folder(folder: Option<PathBuf>) -> Self {
        Self::new(folder)
    }

    /// Only these rows of `system`; the built-in sets of the others.
    ///
    /// # Errors
    /// Too few rows, or rows of another system.
    pub fn from_rows(system: System, rows: Vec<Row>) -> Result<Self, TrainingError> {
        let training = Self::default();
        let set = TrainingSet::from_rows(system.description(), rows)?;
        training.sets[system.index()].get_or_init(|| set);
        Ok(training)
    }

    /// The set of `system`.
    ///
    /// # Errors
    /// The file is missing or wrong: which one, where, what is allowed.
    pub fn set(&self, system: System) -> Result<&TrainingSet, TrainingError> {
        let slot = &self.sets[system.index()];
        if let Some(set) = slot.get() {
            return Ok(set);
        }
        let set = match &self.folder {
            Some(folder) => TrainingSet::load(folder, system.description(), &System::DESCRIPTIONS)?,
            None => TrainingSet::embedded(system.description())?,
        };
        Ok(slot.get_or_init(|| set))
    }
}

impl Default for Training {
    fn default() -> Self {
        Self::new(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_of_neighbours_that_are_built_in_are_those_that_cross_validation_chooses() {
        let chosen = |system: System| {
            let rows = Training::built_in().set(system).unwrap().rows().to_vec();
            TrainingSet::from_rows(system.description(), rows).unwrap().regression_neighbours()
        };
        assert_eq!(System::ALL.map(|system| system.description().neighbours), System::ALL.map(chosen));
    }
}
