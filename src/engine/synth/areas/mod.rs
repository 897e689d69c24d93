//! Areas: patches of scattered points, and cells of one pair of morphogens side by side.

pub mod cells;
mod describe;
pub mod grown;
mod kind;
mod measured;
pub mod patches;
pub mod plan;
pub mod report;

pub use grown::{GrownAreas, OwnCells};
pub use kind::Areas;
