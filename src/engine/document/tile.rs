//! Seamless canvases that are too narrow to grow on.

use crate::document::Problem;
use crate::document::limits::MAX_TILE_RATIO;
use crate::grid::Edges;

/// Whether a canvas of `size` px is seamless, and narrower than [`MAX_TILE_RATIO`] allows.
#[must_use]
pub fn is_too_narrow(size: [f64; 2], edges: Edges) -> bool {
    edges == Edges::Wrap && size[0].max(size[1]) > MAX_TILE_RATIO * size[0].min(size[1])
}

/// Refuses a seamless canvas of `size` px that is too narrow.
///
/// # Errors
/// The size, and what is allowed.
pub fn check(size: [f64; 2], edges: Edges) -> Result<(), Problem> {
    if !is_too_narrow(size, edges) {
        return Ok(());
    }
    let found = format!("a seamless canvas of {} × {} px", size[0], size[1]);
    let allowed =
        format!("a longer side of at most {MAX_TILE_RATIO} times the shorter one, or \"edges\": \"closed\"");
    Err(Problem::new("size", found, allowed))
}
