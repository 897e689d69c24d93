//! Regular grids of cells: where cells are, which are near each other, numbers on them, and reading between them.
//!
//! [`Grid`] is the word for size, cell, edges and neighbourhood, [`Domain`] what of it a triangle surface could answer as
//! well, [`Field`] numbers on a grid.

mod cells;
pub mod distance;
mod domain;
mod edges;
mod field;
pub mod resample;
mod union_find;

pub use cells::Grid;
pub use domain::Domain;
pub use edges::{Bounds, Edges};
pub use field::{Field, to_u16};
pub use union_find::UnionFind;
