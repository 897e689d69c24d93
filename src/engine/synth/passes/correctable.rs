//! What passes see of a layer, and change.

use super::found::{DrawnSpots, MergedSpots};
use super::own_thresholds::OwnThresholds;
use super::restarts::Restart;
use super::thresholds::Thresholds;
use crate::synth::error::LayerError;

/// How far a call of [`Correctable::grow`] has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grown {
    /// Cell updates that it has done.
    pub updates: u64,
    /// Whether the pattern has settled, or has been given up.
    pub settled: bool,
}

/// A layer that passes can correct.
///
/// A canvas answers to all of it. On a surface a place is a vertex, spots are numbered as on a canvas, and what is not said here has a
/// meaning there: a restart writes the initial concentrations about the vertices of `again` and grows on. A surface without drawn spots
/// answers [`DrawnSpots::default`].
pub trait Correctable: Thresholds + OwnThresholds {
    /// Grows on by about `budget` cell updates. Once it has settled it is measured.
    ///
    /// # Errors
    /// It has not grown to numbers.
    fn grow(&mut self, budget: u64) -> Result<Grown, LayerError>;

    /// Cells, or px, that one measurement looks at.
    fn measured(&self) -> u64;

    /// Compares what has grown with the spots that began, once the thresholds stay as they are.
    fn compare(&mut self);

    /// The spots that have grown together, as they were compared last.
    fn merged(&self) -> &MergedSpots;

    /// Keeps the pattern if it is better than the best so far. Drawn spots and those that have grown by half are compared with what was
    /// asked.
    fn keep(&mut self);

    /// The drawn spots, as they were compared last.
    fn drawn(&self) -> &DrawnSpots;

    /// How many marks have grown by half.
    fn half_grown(&self) -> usize;

    /// The nearest drawn spot beside a spot, and the nearest other one.
    fn beside(&self, spot: usize) -> [Option<usize>; 2];

    /// Lets spots begin again; the pattern then grows on.
    fn restart(&mut self, restart: &Restart);

    /// Lets the spots begin again that have grown by half. Returns how many.
    fn restart_half_grown(&mut self) -> usize;

    /// Whether the cells about the merged spots can grow on alone.
    fn has_parts(&mut self) -> bool {
        false
    }

    /// Begins to grow these cells on, without the surplus spots.
    fn begin_parts(&mut self) {}

    /// Grows them on. Returns how many cells were updated; `None` = they have settled, and their spots were measured and compared.
    fn grow_parts(&mut self) -> Option<u64> {
        None
    }

    /// Whether there is a pattern at all.
    ///
    /// # Errors
    /// Nothing grew, or nothing but marks.
    fn check(&self) -> Result<(), LayerError>;

    /// Begins the whole layer again in parameters that make up for what the layers beneath do to it. Returns whether they do much.
    ///
    /// # Errors
    /// The training set cannot be read.
    fn begin_unbiased(&mut self) -> Result<bool, LayerError> {
        Ok(false)
    }

    /// Makes the edges of the best pattern more or less ragged, once. Returns how many cells were measured; `None` = they are as asked.
    fn roughen(&mut self) -> Option<u64> {
        None
    }
}
