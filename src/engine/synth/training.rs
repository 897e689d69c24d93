//! Training sets by system: built in, or from a folder of the user's.

use std::sync::OnceLock;

use crate::attributes::system::Description;
use crate::document::systems::{SYSTEMS, of_pairs, of_parameters};
use crate::learn::{Folder, PairRow, PairSet, Row, TrainingError, TrainingSet};
use crate::rd::System;

/// The training sets of all systems. Each is read when it is first needed.
pub struct Training {
    folder: Option<Box<dyn Folder>>,
    sets: [OnceLock<TrainingSet>; SYSTEMS.len()],
    pairs: [OnceLock<Option<PairSet>>; SYSTEMS.len()],
}

/// The built-in sets, read once in a process.
static BUILT_IN: Training = Training::new(None);

impl Training {
    const fn new(folder: Option<Box<dyn Folder>>) -> Self {
        let pairs = [const { OnceLock::new() }; SYSTEMS.len()];
        Self { folder, sets: [const { OnceLock::new() }; SYSTEMS.len()], pairs }
    }

    /// The built-in sets, shared by all who ask for them.
    #[must_use]
    pub fn built_in() -> &'static Self {
        &BUILT_IN
    }

    /// The sets in `folder`.
    #[must_use]
    pub fn from_folder(folder: Box<dyn Folder>) -> Self {
        Self::new(Some(folder))
    }

    /// A collection with only these rows of `system`, and the built-in sets of the other systems.
    ///
    /// # Errors
    /// Too few rows, or rows of another system.
    pub fn from_rows(system: System, rows: Vec<Row>) -> Result<Self, TrainingError> {
        let training = Self::default();
        let set = TrainingSet::from_rows(system.description(), rows)?;
        training.sets[place(system.description())].get_or_init(|| set);
        Ok(training)
    }

    /// The built-in sets, with these rows of the system of pairs `system`; without rows its laws alone hold.
    ///
    /// # Errors
    /// Too few rows.
    pub fn with_pairs(system: &'static Description, rows: Vec<PairRow>) -> Result<Self, TrainingError> {
        let training = Self::default();
        let set = PairSet::from_rows(system, rows)?;
        if let Some(slot) = training.slot_of_pairs(system) {
            slot.get_or_init(|| set);
        }
        Ok(training)
    }

    fn slot_of_pairs(&self, system: &Description) -> Option<&OnceLock<Option<PairSet>>> {
        system.coordinates().map(|_| &self.pairs[place(system)])
    }

    /// The rows of the system of pairs `system`; `None` if there are none, so that its laws alone hold.
    ///
    /// # Errors
    /// The file is missing or wrong: which one, where, what is allowed.
    pub fn pairs(&self, system: &'static Description) -> Result<Option<&PairSet>, TrainingError> {
        let Some(slot) = self.slot_of_pairs(system) else { return Ok(None) };
        if let Some(set) = slot.get() {
            return Ok(set.as_ref());
        }
        let known: Vec<&'static Description> = of_parameters().chain(of_pairs()).collect();
        let set = match &self.folder {
            Some(folder) => PairSet::load(&**folder, system, &known)?,
            None => PairSet::embedded(system)?,
        };
        Ok(slot.get_or_init(|| set).as_ref())
    }

    /// The set of `system`.
    ///
    /// ```
    /// use dapple_engine::rd::System;
    /// use dapple_engine::synth::Training;
    ///
    /// let set = Training::built_in().set(System::TURING_SPOTS)?;
    /// assert!(set.rows().len() > 100);
    /// # Ok::<(), dapple_engine::learn::TrainingError>(())
    /// ```
    ///
    /// # Errors
    /// The file is missing or wrong: which one, where, what is allowed.
    pub fn set(&self, system: System) -> Result<&TrainingSet, TrainingError> {
        let slot = &self.sets[place(system.description())];
        if let Some(set) = slot.get() {
            return Ok(set);
        }
        let set = match &self.folder {
            Some(folder) => {
                let known: Vec<&'static Description> = of_parameters().collect();
                TrainingSet::load(&**folder, system.description(), &known)?
            }
            None => TrainingSet::embedded(system.description())?,
        };
        Ok(slot.get_or_init(|| set))
    }
}

/// The index of a system in the list.
fn place(system: &Description) -> usize {
    SYSTEMS.iter().position(|other| *other == system).unwrap_or(0)
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
