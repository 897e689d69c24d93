//! Triangle surfaces in space: models, read from files or made by formula.
//!
//! [`read_obj`] and [`built_in`] give a [`Model`]; [`Model::mesh`] is the part of it on which something grows.

pub mod bodies;
mod mesh;
pub mod model;

pub use bodies::{BODIES, built_in};
pub use mesh::Mesh;
pub use model::{Model, ModelError, read_obj};
