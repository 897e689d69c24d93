//! Numbers on a regular grid of cells, and reading them between the cells.

pub mod distance;
mod field;
pub mod resample;

pub use field::{Edges, Field, to_u16};
