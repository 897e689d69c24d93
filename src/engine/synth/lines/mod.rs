//! Lines of scattered points: streaks and cracks.

mod describe;
pub mod grow;
pub mod grown;
mod kind;
pub mod plan;
pub mod report;

pub use grown::GrownLines;
pub use kind::Lines;
