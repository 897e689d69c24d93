//! Triangle surfaces: meshes made fit to grow on, and places, frames, ways and distances on them.
//!
//! ```text
//!  Mesh ─▶ prepare (welded, oriented, a manifold) ─▶ remesh (even triangles) ─▶ Surface, a Domain
//! ```

mod adjacency;
mod bounding_tree;
mod mesh;
mod morton;
mod prepare;
mod remesh;
#[cfg(test)]
pub mod test_meshes;
mod vector;

pub use mesh::Mesh;
pub use prepare::{Repairs, SurfaceError, prepare};
pub use remesh::remesh;
