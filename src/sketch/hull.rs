//! The convex hull of a stroke, and its measures.

use crate::marks::{Ellipse, fit};

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

    pub(super) fn area(&self) -> f64 {
        self.sides().map(|(a, b)| 0.5 * self.cross(a, b)).sum()
    }

    pub(super) fn perimeter(&self) -> f64 {
        self.sides().map(|(a, b)| distance(a, b)).sum()
    }

    /// The ellipse with the hull's second moments; `None` of a hull without area.
    ///
    /// With w = x₁y₂ − x₂y₁ of each side: A = Σ w/2, x̄ = Σ w·(x₁ + x₂)/6A,
    /// ∫x² = Σ w·(x₁² + x₁x₂ + x₂²)/12, ∫xy = Σ w·(2x₁y₁ + x₁y₂ + x₂y₁ + 2x₂y₂)/24.
    pub(super) fn ellipse(&self) -> Option<Ellipse> {
        let origin = self.corners[0];
        let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
        for (a, b) in self.sides() {
            let w = self.cross(a, b);
            let [x1, y1] = [a[0] - origin[0], a[1] - origin[1]];
            let [x2, y2] = [b[0] - origin[0], b[1] - origin[1]];
            area += 0.5 * w;
            first[0] += w * (x1 + x2) / 6.0;
            first[1] += w * (y1 + y2) / 6.0;
            second[0] += w * (x1 * x1 + x1 * x2 + x2 * x2) / 12.0;
            second[1] += w * (2.0 * x1 * y1 + x1 * y2 + x2 * y1 + 2.0 * x2 * y2) / 24.0;
            second[2] += w * (y1 * y1 + y1 * y2 + y2 * y2) / 12.0;
        }
        let [x, y] = first.map(|sum| sum / area);
        let [xx, xy, yy] = second.map(|sum| sum / area);
        fit::ellipse_from_moments([origin[0] + x, origin[1] + y], [xx - x * x, xy - x * y, yy - y * y])
    }

    fn sides(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().copied().zip(next.copied())
    }

    /// Cross product of two corners, seen from the first one: small numbers keep their digits.
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
    fn points_without_extent_or_meaning_have_no_hull() {
        assert!(Hull::new(&[]).is_none());
        assert!(Hull::new(&[[1.0, 2.0]; 5]).is_none());
        assert!(Hull::new(&[[1.0, 2.0], [f64::NAN, 0.0]]).is_none());
        assert!(Hull::new(&[[1.0, 2.0], [f64::INFINITY, 0.0]]).is_none());
        let flat = Hull::new(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).unwrap();
        assert_eq!((flat.area(), flat.ellipse()), (0.0, None));
    }
}
