//! The operations by which passes measure and change a layer.

use super::found::{DrawnSpots, MergedSpots};
use super::own_thresholds::OwnThresholds;
use super::restarts::Restart;
use super::thresholds::Thresholds;
use crate::synth::error::LayerError;

/// The result of a call of [`Correctable::grow`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grown {
    /// Cell updates that it has done.
    pub updates: u64,
    /// Whether the pattern has settled, or has been given up.
    pub settled: bool,
}

/// A layer that passes can correct.
///
/// A canvas implements all of it. On a surface a place is a vertex, spots are numbered as on a canvas, and the default methods
/// apply: a restart writes the initial concentrations about the vertices of `again` and continues the growth. A surface without
/// drawn spots returns [`DrawnSpots::default`].
pub trait Correctable: Thresholds + OwnThresholds {
    /// Continues the growth by about `budget` cell updates, and measures the pattern once it has settled.
    ///
    /// # Errors
    /// The concentrations are not finite.
    fn grow(&mut self, budget: u64) -> Result<Grown, LayerError>;

    /// Number of cells, or px, of one measurement.
    fn measured(&self) -> u64;

    /// Compares the grown spots with those that began, after the thresholds have been moved for the last time.
    fn compare(&mut self);

    /// The spots that have merged, by the last comparison.
    fn merged(&self) -> &MergedSpots;

    /// Keeps the pattern if it is better than the best so far. Drawn spots and half-grown marks are compared with the sketch.
    fn keep(&mut self);

    /// The drawn spots, by the last comparison.
    fn drawn(&self) -> &DrawnSpots;

    /// The number of half-grown marks.
    fn half_grown(&self) -> usize;

    /// The drawn spot nearest to `spot`, and the nearest other spot.
    fn beside(&self, spot: usize) -> [Option<usize>; 2];

    /// Restarts spots; the growth of the pattern then continues.
    fn restart(&mut self, restart: &Restart);

    /// Restarts the half-grown spots. Returns their number.
    fn restart_half_grown(&mut self) -> usize;

    /// Whether the cells about the merged spots can be grown on their own.
    fn has_parts(&mut self) -> bool {
        false
    }

    /// Begins to grow these cells, without the surplus spots.
    fn begin_parts(&mut self) {}

    /// Continues the growth of these cells. Returns the number of cell updates; `None` = they have settled, and their spots have
    /// been measured and compared.
    fn grow_parts(&mut self) -> Option<u64> {
        None
    }

    /// Checks that there is a pattern.
    ///
    /// # Errors
    /// Nothing grew, or nothing but marks.
    fn check(&self) -> Result<(), LayerError>;

    /// Begins the whole layer again with parameters that compensate for the effects of the layers beneath. Returns whether these
    /// effects are large.
    ///
    /// # Errors
    /// The training set cannot be read.
    fn begin_unbiased(&mut self) -> Result<bool, LayerError> {
        Ok(false)
    }

    /// Changes the raggedness of the edges of the best pattern by one step. Returns the number of cells that were measured; `None`
    /// = the edges are as asked for.
    fn roughen(&mut self) -> Option<u64> {
        None
    }
}
