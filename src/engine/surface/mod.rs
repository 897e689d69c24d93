//! Triangle surfaces that patterns grow on.

mod intrinsic_delaunay;
mod laplacian;
mod mesh;
mod metric;
#[cfg(test)]
pub mod test_meshes;
mod vector;

pub use intrinsic_delaunay::{Triangulation, edges};
pub use laplacian::{Laplacian, laplacian, laplacian_of_lengths};
pub use mesh::Mesh;
pub use metric::Stretch;
