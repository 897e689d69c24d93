//! Regions of the canvas, and attributes at any point between them.

mod blend;
mod layout;
mod map;

pub use layout::Layout;
pub use map::{Region, RegionMap, RegionsError};
