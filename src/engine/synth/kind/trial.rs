//! The time of a growth, measured for a part of it.

use crate::synth::kind::Previewed;

/// The work of a growth.
pub enum Work {
    /// Approximate time in seconds, by a law: no part of the work can be timed by itself.
    Seconds(f64),
    /// Work in units.
    Units {
        /// Number of units.
        units: f64,
        /// Does some of the units; returns their number.
        part: Box<dyn FnMut() -> f64>,
    },
}

/// A growth of which a part is timed.
pub struct Trial {
    /// Its work.
    pub work: Work,
    /// Its first picture.
    pub look: Box<dyn Previewed>,
}
