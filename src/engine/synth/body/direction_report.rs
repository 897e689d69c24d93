//! How far the directions of what has grown are off.

use serde::Serialize;

/// How far directions are off, degrees: those of single spots, or of stripes vertex by vertex, weighted by how clear they are. What is near
/// singularities, where directions turn within a mark, does not count.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DirectionReport {
    /// Spots or vertices that count.
    pub count: usize,
    /// The weighted median of the deviations.
    pub median: f64,
    /// What 95 % of the weight does not exceed.
    pub p95: f64,
    /// The root of the weighted mean of their squares.
    pub rms: f64,
}

impl DirectionReport {
    /// Of deviations without a sign and their weights; `None` of none.
    #[must_use]
    pub fn new(mut deviations: Vec<[f64; 2]>) -> Option<Self> {
        deviations.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let total: f64 = deviations.iter().map(|[_, weight]| weight).sum();
        let at = |share: f64| {
            let mut left = share * total;
            let found = deviations.iter().find(|[_, weight]| {
                left -= weight;
                left <= 0.0
            });
            found.or(deviations.last()).map(|[off, _]| *off)
        };
        let squares: f64 = deviations.iter().map(|[off, weight]| weight * off * off).sum();
        let rms = (squares / total).sqrt();
        Some(Self { count: deviations.len(), median: at(0.5)?, p95: at(0.95)?, rms })
    }
}
