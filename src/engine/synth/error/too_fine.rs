//! The reason why a pattern is too fine for its model.

use crate::synth::time::in_words;

/// A growth on a model needs too much time or memory.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TooFine {
    /// The pattern does not fit into memory.
    #[error(
        "about {vertices:.0} vertices need about {:.1} GB of memory, {:.1} GB are free; make \"px\" of the model less, or draw larger \
         marks",
        needed / 1e9, free / 1e9
    )]
    Memory {
        /// Vertices of the remeshed surface.
        vertices: f64,
        /// Bytes needed.
        needed: f64,
        /// Bytes free.
        free: f64,
    },
    /// The finish does not fit into memory.
    #[error(
        "the finish needs about {:.1} GB of memory, {:.1} GB are free; make its \"size\" larger, or \"px\" of the model less",
        needed / 1e9, free / 1e9
    )]
    Finish {
        /// Bytes needed.
        needed: f64,
        /// Bytes free.
        free: f64,
    },
    /// The pattern takes too long.
    #[error(
        "about {vertices:.0} vertices take {} of one core, such a surface may take {}; make \"px\" of the model less, draw larger marks, \
         or allow more with --minutes {}",
        in_words(*needed), in_words(*allowed), (needed / 60.0).ceil().max(1.0)
    )]
    Time {
        /// Vertices of the remeshed surface.
        vertices: f64,
        /// Seconds needed.
        needed: f64,
        /// Seconds allowed.
        allowed: f64,
    },
}
