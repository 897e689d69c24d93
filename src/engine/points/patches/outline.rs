//! A drawn closed outline, and the distance of places from it, inside and outside.

use crate::marks::{Moments, distance_to_segment};
use crate::points::extent::Extent;

/// A closed polygon, px, with properties that are computed once.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    points: Vec<[f64; 2]>,
    center: [f64; 2],
    area: f64,
    /// Low and high corner of its bounding box.
    bounds: [[f64; 2]; 2],
}

impl Outline {
    /// The outline with these corners; `None` for fewer than three, or if they enclose no area. The last one is joined to the
    /// first.
    #[must_use]
    pub fn new(points: Vec<[f64; 2]>) -> Option<Self> {
        let moments = Moments::polygon(&points);
        let area = moments.area.abs();
        if points.len() < 3 || !(area > 0.0 && area.is_finite()) {
            return None;
        }
        let (center, _) = moments.central();
        let bounds = points.iter().fold([points[0]; 2], |[low, high], at| {
            [[0, 1].map(|axis| low[axis].min(at[axis])), [0, 1].map(|axis| high[axis].max(at[axis]))]
        });
        Some(Self { points, center, area, bounds })
    }

    /// Its corners, px.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Low and high corner of its bounding box, px.
    #[must_use]
    pub fn corners(&self) -> [[f64; 2]; 2] {
        self.bounds
    }

    /// The largest distance of its points from its centroid, px.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let off = |at: &[f64; 2]| libm::hypot(at[0] - self.center[0], at[1] - self.center[1]);
        self.points.iter().map(off).fold(0.0, f64::max)
    }

    /// Its centroid, px.
    #[must_use]
    pub fn center(&self) -> [f64; 2] {
        self.center
    }

    /// Its area, px².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Distance, px, of a place from the bounding box of the outline or of its nearest image: a lower bound of the distance from
    /// the outline.
    #[must_use]
    pub fn away(&self, at: [f64; 2], extent: &Extent) -> f64 {
        self.distance_to_box(self.beside(at, extent))
    }

    /// The image of a place that is nearest to the centroid.
    fn beside(&self, at: [f64; 2], extent: &Extent) -> [f64; 2] {
        let displacement = extent.shortest([at[0] - self.center[0], at[1] - self.center[1]]);
        [self.center[0] + displacement[0], self.center[1] + displacement[1]]
    }

    fn distance_to_box(&self, at: [f64; 2]) -> f64 {
        let [low, high] = self.bounds;
        let beyond = [0, 1].map(|axis| (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0));
        libm::hypot(beyond[0], beyond[1])
    }

    /// Depth of a place inside the outline or its nearest image, px; negative outside. Far outside it is the negative distance from
    /// the bounding box.
    #[must_use]
    pub fn depth(&self, at: [f64; 2], extent: &Extent) -> f64 {
        let at = self.beside(at, extent);
        let away = self.distance_to_box(at);
        if away > self.area.sqrt() {
            return -away;
        }
        let sides = || self.points.iter().zip(self.points.iter().cycle().skip(1));
        let nearest = sides().map(|(a, b)| distance_to_segment(at, [*a, *b])).fold(f64::INFINITY, f64::min);
        let crossed = sides().filter(|(a, b)| {
            (a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        });
        if crossed.count() % 2 == 1 { nearest } else { -nearest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_depth_of_a_place_is_the_distance_from_the_nearest_side() {
        let outline =
            Outline::new(vec![[10.0, 10.0], [30.0, 10.0], [30.0, 20.0], [10.0, 20.0]]).expect("an area");
        let card = Extent { size: [100.0, 60.0], wrap: [false; 2] };
        let is = |found: f64, expected: f64| (found - expected).abs() < 1e-9;
        assert!(is(outline.area(), 200.0) && is(outline.center()[0], 20.0) && is(outline.center()[1], 15.0));
        assert!(is(outline.depth([20.0, 14.0], &card), 4.0));
        assert!(is(outline.depth([33.0, 24.0], &card), -5.0));
        assert!(is(outline.depth([90.0, 15.0], &card), -60.0));
        let tile = Extent { wrap: [true; 2], ..card };
        assert!(is(outline.depth([112.0, 74.0], &tile), 2.0));
        assert!(is(outline.depth([90.0, 15.0], &tile), -20.0));
    }

    #[test]
    fn points_that_enclose_no_area_are_no_outline() {
        assert_eq!(Outline::new(vec![[0.0, 0.0], [5.0, 5.0]]), None);
        assert_eq!(Outline::new(vec![[0.0, 0.0], [5.0, 5.0], [10.0, 10.0]]), None);
        assert_eq!(Outline::new(vec![[0.0, 0.0], [f64::NAN, 5.0], [10.0, 0.0]]), None);
    }
}
