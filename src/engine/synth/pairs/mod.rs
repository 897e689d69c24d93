//! Layers of systems of pairs of morphogens: weaves, mazes, stripes with tips, stucco.

mod describe;
pub mod grow;
pub mod grown;
mod kind;
pub mod plan;
pub mod report;
mod stripes_of_threads;

pub use grown::GrownPairs;
pub use kind::Pairs;
pub(in crate::synth) use kind::{UPDATE_SECONDS, timed};
