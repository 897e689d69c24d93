//! The convex hull of a stroke, and its measures.

use crate::marks::{Ellipse, Moments, fit};

/// A convex polygon, corners in turn.
#[derive(Clone, Debug)]
pub(super) struct Hull {
    corners: Vec<[f64; 2]>,
}

impl Hull {
    /// The convex hull of points; `None` where they have no extent or are not finite.
    ///
    /// Andrew, "Another efficient algorithm for convex hulls in two dimensions", Inf. Proc. Letters 9 (1979).
    pub(super) fn new(points: &[[f64; 2]]) -> Option<Self> {
        // Squares of larger numbers would overflow; no canvas has them.
        if points.iter().flatten().any(|x| x.is_nan() || x.abs() > 1e100) {
            return None;
        }
        let mut sorted = points.to_vec();
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let mut corners = chain(sorted.iter());
        corners.extend(chain(sorted.iter().rev()));
        let hull = Self { corners };
        // Squares of smaller numbers would vanish.
        (hull.diameter() > 1e-100).then_some(hull)
    }

    /// Largest distance between two corners.
    pub(super) fn diameter(&self) -> f64 {
        let from = |a: &[f64; 2]| self.corners.iter().map(|b| distance(*a, *b)).fold(0.0, f64::max);
        self.corners.iter().map(from).fold(0.0, f64::max)
    }

    /// Its corners in turn.
    pub(super) fn corners(&self) -> &[[f64; 2]] {
        &self.corners
    }

    pub(super) fn area(&self) -> f64 {
        self.sides().map(|(a, b)| 0.5 * self.cross(a, b)).sum()
    }

    pub(super) fn perimeter(&self) -> f64 {
        self.sides().map(|(a, b)| distance(a, b)).sum()
    }

    /// The ellipse with the hull's second moments; `None` of a hull without area.
    pub(super) fn ellipse(&self) -> Option<Ellipse> {
        // Coordinates relative to a corner keep the precision of small hulls.
        let origin = self.corners[0];
        let relative: Vec<[f64; 2]> =
            self.corners.iter().map(|[x, y]| [x - origin[0], y - origin[1]]).collect();
        let ([x, y], covariance) = Moments::polygon(&relative).central();
        fit::ellipse_from_moments([origin[0] + x, origin[1] + y], covariance)
    }

    fn sides(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().copied().zip(next.copied())
    }

    /// Cross product of two corners relative to the first one, which keeps the precision of small hulls.
    fn cross(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        cross(self.corners[0], a, b)
    }
}

/// The half of the hull that turns left along sorted points, without its last corner.
fn chain<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for &point in points {
        while let [.., a, b] = chain[..]
            && cross(a, b, point) <= 0.0
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain
}

/// (a − o) × (b − o).
fn cross(o: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_with_points_inside_is_its_four_corners() {
        let hull =
            Hull::new(&[[4.0, 4.0], [1.0, 2.0], [0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [0.0, 4.0], [3.0, 3.0]])
                .unwrap();
        assert_eq!(hull.corners.len(), 4);
        assert_eq!(hull.area(), 16.0);
        assert_eq!(hull.perimeter(), 16.0);
        assert_eq!(hull.diameter(), 32f64.sqrt());
    }

    #[test]
    fn a_rectangle_has_the_second_moments_of_one() {
        // Variance side²/12, so radii 2·side/√12.
        let hull = Hull::new(&[[100.0, 50.0], [112.0, 50.0], [112.0, 56.0], [100.0, 56.0]]).unwrap();
        let ellipse = hull.ellipse().unwrap();
        assert!((ellipse.radii[0] - 24.0 / 12f64.sqrt()).abs() < 1e-9);
        assert!((ellipse.radii[1] - 12.0 / 12f64.sqrt()).abs() < 1e-9);
        assert!((ellipse.center[0] - 106.0).abs() < 1e-9 && (ellipse.center[1] - 53.0).abs() < 1e-9);
        assert_eq!(ellipse.angle, 0.0);
    }

    #[test]
    fn points_without_extent_or_not_finite_have_no_hull() {
        assert!(Hull::new(&[]).is_none());
        assert!(Hull::new(&[[1.0, 2.0]; 5]).is_none());
        assert!(Hull::new(&[[1.0, 2.0], [f64::NAN, 0.0]]).is_none());
        assert!(Hull::new(&[[1.0, 2.0], [f64::INFINITY, 0.0]]).is_none());
        let flat = Hull::new(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).unwrap();
        assert_eq!((flat.area(), flat.ellipse()), (0.0, None));
    }
}
