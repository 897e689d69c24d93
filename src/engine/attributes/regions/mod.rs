//! Regions of the canvas, and attributes at any point between them.

mod blend;
mod map;
mod region_grid;

pub use map::{MARKS_OF_A_SPREAD, Region, RegionMap, RegionsError};
pub use region_grid::RegionGrid;
