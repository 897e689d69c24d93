//! Points that repel each other on a surface, and their planar Voronoi cells: the mesh on which Turk's textures grow.
//!
//! G. Turk, "Generating textures on arbitrary surfaces using reaction-diffusion", SIGGRAPH 1991, the section on mesh generation and its
//! figure 7. It is the reference that the cotangent [`Laplacian`](super::Laplacian) of a remeshed surface is compared with, for small
//! meshes: `docs/turk.md` shows where it fails and why.
//!
//! ```text
//!  Surface ─▶ RelaxedPoints ─▶ voronoi_laplacian ─▶ growth ─▶ weighted_sum ─▶ values anywhere on the surface
//! ```

mod cells;
mod near;
mod relaxed;
mod weighted_sum;

pub use cells::voronoi_laplacian;
pub use relaxed::{RelaxedPoints, random_points};
pub use weighted_sum::WeightedSum;

#[cfg(test)]
mod tests;
