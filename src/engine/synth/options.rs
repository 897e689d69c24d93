//! Options for growing a document that are not stored in it.

use std::time::Duration;

use crate::synth::time::TimeLimit;
use crate::synth::training::Training;
use crate::synth::watch::Watch;

/// Options for growing a document that are not stored in it.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Canvas, px; `None` = the document's. The regions stretch with it, marks keep their size.
    pub size: Option<[u32; 2]>,
    /// Whether to correct the pattern; `None` = the document's setting.
    pub refine: Option<bool>,
    /// Whether to keep the concentrations of all chemicals, which takes 8 or 20 bytes a cell.
    pub concentrations: bool,
    /// The name of the document in messages, such as its path.
    pub source: &'a str,
    /// Training sets in which parameters are looked up.
    pub training: &'a Training,
    /// Bytes of memory that may be used: what needs more is refused before it grows. `None` = without a limit.
    pub memory: Option<f64>,
    /// Time limit, by laws: a growth that takes longer is refused before it begins.
    pub time: TimeLimit,
    /// Progress and cancelling.
    pub watch: Watch<'a>,
}

/// A clock: the time since some moment.
pub type Clock = fn() -> Duration;

/// Properties of the machine that the engine runs on; the engine does not query the system itself.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    /// Bytes of memory that may be used; `None` = without a limit.
    pub memory: Option<f64>,
    /// A clock for measuring its speed.
    pub clock: Clock,
}

impl Default for Options<'_> {
    /// Options for growing a document from the built-in training sets, without limits of memory and time and without progress.
    fn default() -> Self {
        Self {
            size: None,
            refine: None,
            concentrations: false,
            source: "the document",
            training: Training::built_in(),
            memory: None,
            time: TimeLimit::None,
            watch: Watch::NONE,
        }
    }
}

impl Options<'_> {
    /// The options that influence the result.
    #[must_use]
    pub fn settings(&self) -> Settings {
        Settings { size: self.size, refine: self.refine, concentrations: self.concentrations }
    }
}

/// The [`Options`] that a texture was grown with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// Canvas, px; `None` = the document's.
    pub size: Option<[u32; 2]>,
    /// Whether the pattern was corrected; `None` = the document's setting.
    pub refine: Option<bool>,
    /// Whether the concentrations of all chemicals were kept.
    pub concentrations: bool,
}
