//! A pattern on a surface → the pictures of a model's texture.
//!
//! ```text
//!  Model ─▶ Atlas (its own coordinates, or automatic ones) ─▶ Texels (which triangle, with a gutter) ─▶ Baker: rows of values and normals
//! ```
//!
//! Each texel has a place on its triangle. Values are those of the pattern at the point of the surface that is closest to it. A texel
//! of the gutter lies on the plane of its triangle, beyond the edge: there the closest point is on the neighbour across the edge,
//! so that both sides of a seam show the same values.

mod atlas;
mod baker;
mod corners;
mod fields;
mod islands;
mod openness;
mod own;
mod tangents;
#[cfg(test)]
mod tests;
mod texels;
mod unwrap;

pub use atlas::Atlas;
pub use baker::{Baked, Baker};
pub use fields::Fields;
pub use openness::openness;
pub use own::{Unfit, own};
pub use texels::Texels;
pub use unwrap::automatic;
