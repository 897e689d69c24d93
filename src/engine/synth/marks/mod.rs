//! Spots and stripes of one system with training rows.

mod describe;
pub mod grow;
mod grown;
mod kind;
pub mod plan;
pub mod report;

pub use grown::GrownMarks;
pub use kind::{Marks, MarksPlan};
pub(in crate::synth) use kind::{share_needed, stepped};
