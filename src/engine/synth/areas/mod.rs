//! Areas: patches of scattered points, and cells of one pair of morphogens side by side.

mod describe;
pub mod grown;
mod kind;
mod measured;
pub mod patches;
pub mod plan;
pub mod polygons;
pub mod report;

pub use grown::{GrownAreas, OwnPolygons};
pub use kind::Areas;
