//! Spacing: the weighted mean length of the Delaunay edges between the centres of spots.
//!
//! An edge has the weight clamp(cos α ÷ 0.2, 0, 1) × clamp((3.5 s − length) ÷ s, 0, 1), where α is the larger of the
//! angles opposite to it and s the distance of marks to their nearest. An edge that a small move of a mark can replace
//! by another (α = 90° and more) has the weight 0, so that readings are continuous. The two nearest marks always have
//! the weight 1: nothing is divided by 0.

mod delaunay;
mod groups;

use super::moments;

pub use delaunay::{Edge, edges};
pub use groups::grouped_neighbours;

/// Cosine of the opposite angle from which on an edge has its full weight: 78°.
const FULL_COS: f64 = 0.2;

/// Edges of so many times the distance to the nearest mark have the weight 0; by 1 shorter ones the full weight.
const REACH: f64 = 3.5;

/// A Delaunay edge between two marks with its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedEdge {
    /// Indices of the marks it joins; equal where a mark on a tile neighbours its own copy.
    pub ends: [usize; 2],
    /// Length of the edge, px.
    pub length: f64,
    /// The point halfway, px; inside the tile where there is one.
    pub midpoint: [f64; 2],
    /// 0..1, above 0.
    pub weight: f64,
}

impl Edge {
    /// Its weight, 0..1, where marks are `nearest` px from their nearest.
    #[must_use]
    pub fn weight(&self, nearest: f64) -> f64 {
        let by_angle = (self.cos_opposite / FULL_COS).clamp(0.0, 1.0);
        by_angle * (REACH - self.length / nearest).clamp(0.0, 1.0)
    }

    /// With its weight; `None` if that is 0.
    #[must_use]
    pub fn weighted(&self, nearest: f64) -> Option<WeightedEdge> {
        let Self { ends, length, midpoint, .. } = *self;
        Some(WeightedEdge { ends, length, midpoint, weight: self.weight(nearest) })
            .filter(|edge| edge.weight > 0.0)
    }
}

/// The Delaunay edges of `points` (px; on a tile of `wrap` px those across its border too) that have a weight, where
/// `nearest` returns the distance of marks to their nearest, px, about a midpoint of an edge.
#[must_use]
pub fn weighted_edges(
    points: &[[f64; 2]],
    wrap: Option<[f64; 2]>,
    nearest: impl Fn([f64; 2]) -> f64,
) -> Vec<WeightedEdge> {
    edges(points, wrap).iter().filter_map(|edge| edge.weighted(nearest(edge.midpoint))).collect()
}

/// The edges that the spacing of `points` is the mean of: those that have a weight, s being the median of the points'
/// distances to their nearest.
#[must_use]
pub fn neighbours(points: &[[f64; 2]], wrap: Option<[f64; 2]>) -> Vec<WeightedEdge> {
    let all = edges(points, wrap);
    let Some(nearest) = median(nearest(&all, points.len())) else { return Vec::new() };
    all.iter().filter_map(|edge| edge.weighted(nearest)).collect()
}

/// Mean distance between neighbours, px, of [`neighbours`] on a plane.
///
/// Two points: their distance. Points in a row: from one to the next. Fewer, or all in one place: `None`. Points that
/// coincide count once.
///
/// ```
/// use dapple_engine::attributes::spacing::mean_spacing;
///
/// assert_eq!(mean_spacing(&[[10.0, 10.0], [40.0, 50.0]]), Some(50.0));
/// assert_eq!(mean_spacing(&[[10.0, 10.0]]), None);
/// ```
#[must_use]
pub fn mean_spacing(points: &[[f64; 2]]) -> Option<f64> {
    mean_length(&neighbours(points, None))
}

/// Mean length of weighted edges, px; `None` of none.
#[must_use]
pub fn mean_length(edges: &[WeightedEdge]) -> Option<f64> {
    moments::weighted_mean(edges.iter().map(|edge| (edge.length, edge.weight)))
}

/// Distance of each of `count` points to its nearest, px, by the Delaunay edges between them; `None` of a point
/// that no edge joins: a lone one, or one that coincides with another.
#[must_use]
pub fn nearest(edges: &[Edge], count: usize) -> Vec<Option<f64>> {
    let mut nearest: Vec<Option<f64>> = vec![None; count];
    for edge in edges {
        for end in edge.ends {
            nearest[end] = Some(nearest[end].map_or(edge.length, |length| length.min(edge.length)));
        }
    }
    nearest
}

/// Median of the distances that there are; `None` of none.
#[must_use]
pub fn median(distances: impl IntoIterator<Item = Option<f64>>) -> Option<f64> {
    let mut sorted: Vec<f64> = distances.into_iter().flatten().collect();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    (n > 0).then(|| 0.5 * (sorted[n / 2] + sorted[(n - 1) / 2]))
}

#[cfg(test)]
mod tests;
