//! Growth on a surface: the reactions of the flat systems, with the Laplacian of a mesh in place of the stencils of a grid.
//!
//! ```text
//!  mesh, parameters ─▶ Operators (sparse rows, and slices of them) ─┐
//!  initial concentrations ──────────────────────────────────────────┴─▶ SurfaceGrowth ─▶ marks by vertex
//! ```
//!
//! Lengths are in units of √(mean cell area), as those of a grid are in cells: the same parameters grow the same spots.

mod growth;
mod operators;
mod pair;
mod problem;
#[cfg(test)]
mod tests;

pub use growth::SurfaceGrowth;
pub use pair::{SurfacePair, SurfacePairField};
