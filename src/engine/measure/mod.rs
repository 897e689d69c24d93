//! Field → marks and stripe statistics, in the words of `docs/format.md`.
//!
//! ```text
//!  Field ─▶ supersampled grid (by splines) ─▶ marching squares (exact area above the level in each square)
//!                                              ├─▶ spots    areas, moments, whole or cut   ─┐
//!                                              └─▶ stripes  width = 2 · area ÷ contour     ─┼─▶ errors, texture check
//!        directions (structure tensor) ─────────────────────────────────────────────────────┘
//! ```
//!
//! On a triangle surface `surface_spots`, `surface_neighbours` and `surface_stripes` read the same of values by vertex.
//!
//! All results are px and degrees of the canvas, whatever the field's cell size is. Results do not depend on the number of threads:
//! the supersampled grid is always cut into equal bands of rows, and sums are taken in their order.

mod blotches;
mod directions;
mod edge_directions;
mod errors;
mod half_grown;
mod marching_squares;
mod node_mask;
mod otsu;
mod picture;
mod picture_check;
mod raggedness;
mod regions;
mod spots;
mod stripes;
mod supersampled_grid;
mod surface_spacing;
mod surface_spots;
mod surface_stripes;
mod texture_check;

pub use blotches::blotch_width;
pub use directions::{Deviation, Directions};
pub use edge_directions::edge_directions;
pub use errors::{
    SpotErrors, StripeErrors, Target, is_circle_covered, spot_errors, stripe_errors, stripe_errors_of,
};
pub use half_grown::{FadedAxis, faded_axes, half_grown_spots};
pub use otsu::otsu_threshold;
pub use picture::{Picture, patches, picture, picture_of};
pub use picture_check::{NotTexture, check_picture};
pub use raggedness::{raggedness, spot_raggedness, spot_raggedness_at};
pub use regions::Regions;
pub use spots::{
    Census, Spot, census, census_of_at_least, nodes_a_cell, rough_spots_of_at_least, spots,
    spots_of_at_least, spots_on_nodes, usual_area,
};
pub use stripes::{StripeStatistics, Tally, areas, stripes, tallies, widths};
pub use surface_spacing::{SurfaceEdge, surface_edges, surface_neighbours};
pub use surface_spots::{SurfaceSpot, surface_spots};
pub use surface_stripes::{SurfaceDirection, SurfaceStripes, surface_directions, surface_stripes};
pub use texture_check::{MERGED_FILL, Reason, check_formed, check_spot_texture, check_stripe_texture};
