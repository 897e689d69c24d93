//! Values between points, as weighted sums over the points around: a way to colour a surface directly from the points.

use super::near::Near;
use super::relaxed::RelaxedPoints;
use crate::surface::{Surface, SurfacePoint};

/// The radius s of the weights, in radii of repulsion: s = 2r.
const REACH: f64 = 2.0;

/// Turk's weighted sums v′(P) = Σ v(Q) w(|P − Q|/s) ÷ Σ w(|P − Q|/s) over the points Q near P, with w(d) = 2d³ − 3d² + 1.
pub struct WeightedSum<'a> {
    near: Near<'a>,
    points: &'a RelaxedPoints,
}

impl<'a> WeightedSum<'a> {
    /// Sums over these points.
    #[must_use]
    pub fn new(surface: &'a Surface, points: &'a RelaxedPoints) -> Self {
        Self { near: Near::new(surface, &points.places), points }
    }

    /// The value at a place, from those at the points; `None` if no point is near.
    #[must_use]
    pub fn at(&self, place: SurfacePoint, values: &[f32]) -> Option<f32> {
        let reach = REACH * self.points.radius;
        let (mut sum, mut total) = (0.0, 0.0);
        for (index, distance) in self.near.distances(place, reach) {
            let weight = weight(distance / reach);
            sum += weight * f64::from(values[index]);
            total += weight;
        }
        (total > 0.0).then(|| (sum / total) as f32)
    }

    /// The point nearest to a place, and its distance; `None` if none is near.
    #[must_use]
    pub fn nearest(&self, place: SurfacePoint) -> Option<(usize, f64)> {
        let around = self.near.distances(place, REACH * self.points.radius);
        around.into_iter().min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// w(d) = 2d³ − 3d² + 1 within a distance of 1.
fn weight(distance: f64) -> f64 {
    let d = distance.clamp(0.0, 1.0);
    (2.0 * d - 3.0) * d * d + 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_fall_from_1_to_0_and_are_level_at_both_ends() {
        assert_eq!([0.0, 0.5, 1.0, 2.0].map(weight), [1.0, 0.5, 0.0, 0.0]);
        assert!(1.0 - weight(0.01) < 4e-4 && weight(0.99) < 4e-4);
    }
}
