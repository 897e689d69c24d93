//! Regular grids of cells: where cells are, which are near each other, numbers on them, and reading between them.
//!
//! [`Grid`] holds size, cell, edges and neighbourhood; [`Domain`] is the part of it that a triangle surface has as well; [`Field`] is numbers on a grid.

mod arc_tangent;
pub mod averages;
pub mod blur;
mod borderless;
mod box_tiles;
mod cells;
mod cutout;
pub mod distance;
mod domain;
mod edges;
mod exponential;
mod field;
mod flat;
mod framed;
pub mod marching_squares;
mod point_buckets;
#[cfg(test)]
pub mod relabelled;
pub mod resample;
mod space;
#[cfg(test)]
pub mod sphere;
pub mod triangulation;
mod union_find;

pub use arc_tangent::{atan2, sin_cos_degrees};
pub use borderless::{Borderless, CellBuckets};
pub use box_tiles::BoxTiles;
pub use cells::Grid;
pub use cutout::Cutout;
pub use domain::{Domain, turned};
pub use edges::{Bounds, Edges};
pub use exponential::{exp, ln};
pub use field::{Field, to_u16};
pub use point_buckets::{IN_A_BUCKET, PointBuckets};
pub use space::{Buckets, Space, Wall};
pub use union_find::UnionFind;
