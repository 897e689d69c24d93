//! Spots and stripes of one system with training rows.

mod describe;
pub mod grow;
mod kind;
pub mod plan;
mod planned;
pub mod report;

pub use grow::GrownMarks;
pub use kind::Marks;
pub(in crate::synth) use kind::{share_needed, stepped};
pub use planned::MarksPlan;
