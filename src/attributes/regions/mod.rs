//! Regions of the canvas, and attributes at any point between them.

mod layout;
mod blend;
mod map;

pub use layout::Layout;
pub use map::{Region, RegionMap, RegionsError};
