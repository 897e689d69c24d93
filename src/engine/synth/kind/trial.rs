//! The time of a growth, measured on a part of it.

use crate::synth::kind::Previewed;

/// The work of a growth.
pub enum Work {
    /// About so many seconds, by a law: nothing of it can be timed before all of it is done.
    Seconds(f64),
    /// So many units of work.
    Units {
        /// How many.
        units: f64,
        /// Does some of them; returns how many.
        part: Box<dyn FnMut() -> f64>,
    },
}

/// A growth of which a part is timed.
pub struct Trial {
    /// Its work.
    pub work: Work,
    /// How it looks at first.
    pub look: Box<dyn Previewed>,
}
