//! A patch of a system of pairs, grown from a few drawn marks by the laws alone, for training rows.

mod document;
mod drawn;
mod measured;
mod reason;

pub use document::side_by_side;
pub use drawn::Drawn;
pub use reason::PairReason;

use crate::attributes::system::Description;
use crate::learn::PairRow;
use crate::rd::pairs::PairKind;
use crate::synth::error::GrowError;
use crate::synth::growth::Growth;
use crate::synth::options::Options;
use crate::synth::training::Training;
use crate::synth::watch::{Cancelled, Watch};

/// Period of the first direction, px; the grid is as fine as its pair needs.
const PERIOD: f64 = 24.0;
/// Width of the lines between cells, px.
const GAP: f64 = 8.0;
/// Prefix of the names of errors.
const ERROR: &str = "error of ";

/// A value by its name.
type Named = (&'static str, f64);

/// A patch that is to be grown.
#[derive(Clone, Copy, Debug)]
pub struct PairPatch {
    /// The system, from [`crate::document::systems::of_pairs`].
    pub system: &'static Description,
    /// The drawn marks.
    pub drawn: Drawn,
    /// Periods along a side, of the widest period; for cells their number.
    pub periods: f64,
    /// Least number of periods or cells for the patch to be used as training data.
    pub least: f64,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl PairPatch {
    /// Grows it by the laws alone, and measures it. Returns a row with the seed of the patch, or the reason why it is not used.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn grow(&self, watch: &Watch) -> Result<Result<PairRow, PairReason>, Cancelled> {
        let training = Training::with_pairs(self.system, Vec::new()).unwrap_or_default();
        let grown = self.grown(&training, false, watch)?;
        Ok(grown.and_then(|named| self.enough(named)).map(|named| {
            let value =
                |name: &str| named.iter().find(|(of, _)| *of == name).map_or(0.0, |(_, value)| *value);
            let values = self.system.columns.iter().map(|column| value(column.name)).collect();
            PairRow { seed: self.seed, values }
        }))
    }

    /// Grows it as a document is grown, with the factors of the laws from `training`, corrected or not. Returns the relative errors
    /// of the measured values against the drawn ones, by name; or the reason why it is not a texture.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn errors(
        &self,
        training: &Training,
        corrects: bool,
        watch: &Watch,
    ) -> Result<Result<Vec<Named>, PairReason>, Cancelled> {
        let grown = self.grown(training, corrects, watch)?;
        Ok(grown.map(|named| {
            let errors = named.iter().filter_map(|(name, value)| Some((name.strip_prefix(ERROR)?, *value)));
            errors.collect()
        }))
    }

    /// The measurements by the names of the columns, and errors by names that begin with [`ERROR`].
    fn grown(
        &self,
        training: &Training,
        corrects: bool,
        watch: &Watch,
    ) -> Result<Result<Vec<Named>, PairReason>, Cancelled> {
        let options = Options {
            refine: Some(corrects),
            source: "the patch",
            training,
            watch: *watch,
            ..Options::default()
        };
        let grown = match Growth::begin(&self.document(), &options, None).run() {
            Ok(grown) => grown,
            Err(GrowError::Cancelled(cancelled)) => return Err(cancelled),
            Err(error) => return Ok(Err(PairReason::Blank(error.to_string()))),
        };
        let Some(layer) = grown.layers.first() else {
            return Ok(Err(PairReason::Blank("no layer".to_owned())));
        };
        Ok(match (layer.pairs(), layer.areas()) {
            (Some(pairs), _) => self.pairs(pairs),
            (None, Some(areas)) => self.cells(areas),
            (None, None) => Err(PairReason::Blank("no layer".to_owned())),
        })
    }

    /// The measurements, if there are enough periods or cells.
    fn enough(&self, named: Vec<Named>) -> Result<Vec<Named>, PairReason> {
        let found = named.iter().find(|(name, _)| ["periods", "cells"].contains(name)).map_or(0.0, |of| of.1);
        if found < self.least { Err(PairReason::TooFew { found, least: self.least }) } else { Ok(named) }
    }

    /// The system of pairs; `None` for cells.
    fn kind(&self) -> Option<PairKind> {
        PairKind::of(self.system)
    }
}
