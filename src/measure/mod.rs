//! Field → marks and stripe statistics, in the words of `docs/format.md`.
//!
//! ```text
//!  Field ─▶ nodes (a finer grid, by splines) ─▶ square (what of each square is inside, exactly)
//!                                                ├─▶ spots    areas, moments, whole or cut ─┐
//!                                                └─▶ stripes  width = 2 · area ÷ contour   ─┼─▶ errors, verdict
//!        directions (structure tensor) ─────────────────────────────────────────────────────┘
//! ```
//!
//! All results are px and degrees of the canvas, whatever the field's cell is. Nothing depends on the number
//! of threads: the finer grid is cut into the same stretches of rows for any, and sums are taken in their order.

mod directions;
mod errors;
mod marching_squares;
mod picture;
mod spots;
mod stripes;
mod supersampled_grid;
mod union_find;
mod verdict;

pub use directions::{Deviation, Directions};
pub use errors::{Canvas, SpotErrors, StripeErrors, spot_errors, stripe_errors};
pub use picture::{Picture, picture};
pub use spots::{Census, Spot, census, spots};
pub use stripes::{StripeStatistics, stripes, widths};
pub use verdict::{Reason, formed, spot_texture, stripe_texture};
