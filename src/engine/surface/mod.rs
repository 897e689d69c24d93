//! Triangle surfaces: models from files or made by formula, preparation of their meshes, and places, frames, displacements and
//! distances on them.
//!
//! ```text
//!  Model (read_model, built_in) ─▶ Mesh ─▶ prepare (welded, oriented, a manifold) ─▶ remesh (even triangles) ─▶ Surface, a Domain
//! ```

mod adjacency;
mod block_boxes;
pub mod bodies;
mod border;
mod bounding_tree;
mod buckets;
mod directions;
mod domain;
mod geodesic;
mod height_field;
mod intrinsic_delaunay;
mod laplacian;
mod local_map;
mod marching;
mod mesh;
mod metric;
pub mod model;
mod morton;
mod point;
mod prepare;
mod remesh;
#[cfg(test)]
mod surface_tests;
mod tangent;
#[cfg(test)]
pub mod test_meshes;
mod triangle_surface;
pub(crate) mod vector;
pub mod voronoi;
mod walk;

pub use bodies::{BODIES, built_in};
pub use bounding_tree::BoundingTree;
pub use directions::{Directions, Singularity, directions};
pub use geodesic::distances;
pub use height_field::HeightField;
pub use intrinsic_delaunay::{Triangulation, edges};
pub use laplacian::{Laplacian, laplacian, laplacian_of_lengths};
pub use local_map::LocalMap;
pub use mesh::{Mesh, area_vector};
pub use metric::Stretch;
pub use model::{Face, Model, ModelError, read_model};
pub use point::SurfacePoint;
pub use prepare::{Repairs, SurfaceError, prepare};
pub use remesh::{Remeshing, remesh};
pub use triangle_surface::Surface;
