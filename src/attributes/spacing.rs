//! Spacing: Delaunay edges between the centres of spots (spade).

/// Mean distance between neighbours, px.
///
/// Delaunay edges of `points`; hull edges are left out where at least three inner ones remain, then edges
/// over twice the median. Two points: their distance. Fewer: `None`.
#[must_use]
pub fn mean_spacing(points: &[[f64; 2]]) -> Option<f64> {
    let _ = points;
    None
}
