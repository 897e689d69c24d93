//! Reaction and diffusion of points whose neighbours are listed one by one, such as the vertices of a mesh: a plain solver, row by
//! row, and a fast one by slices of rows.

mod chemicals;
mod layout;
mod operators;
mod plain;
mod problem;
mod slices;
mod sparse_rows;
mod step;

pub use chemicals::{ReactingByRows, SparseChemicals, reacting_by_rows};
pub use operators::Operators;
pub use problem::SparseProblem;
pub use slices::ROWS;
