//! Delaunay triangulations of points in the plane, along whose axes the plane may wrap (spade).
//!
//! Along an axis that wraps copies of the points stand beyond the border, within a margin. The margin is wide enough for a triangle whose
//! empty circle does not reach beyond it.

use spade::{DelaunayTriangulation, HasPosition, Point2};

/// A corner of a triangulation.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    position: Point2<f64>,
    /// The point that it is, or is a copy of; `None` for a corner that stands for no point.
    pub point: Option<u32>,
    /// Whether it is the point itself, not a copy.
    pub own: bool,
}

impl Corner {
    /// A corner that stands for no point.
    #[must_use]
    pub fn guard([x, y]: [f64; 2]) -> Self {
        Self { position: Point2::new(x, y), point: None, own: false }
    }
}

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// The triangulation.
pub type Mesh = DelaunayTriangulation<Corner>;

/// The triangulation of these corners.
#[must_use]
pub fn triangulated(corners: Vec<Corner>) -> Mesh {
    Mesh::bulk_load_stable(corners).unwrap_or_default()
}

/// A place as spade takes it: no coordinate is closer to 0 than 2⁻¹⁴², but 0 itself.
#[must_use]
pub fn tame(at: [f64; 2]) -> [f64; 2] {
    at.map(|x| if x.abs() < 1e-30 { 0.0 } else { x })
}

/// The indices of the places that are triangulated, ascending: the first of those that coincide, and none that is not finite.
#[must_use]
pub fn distinct(places: &[[f64; 2]]) -> Vec<u32> {
    // spade takes none over 2²⁰¹; px are nowhere near that.
    let finite = |index: &u32| places[*index as usize].iter().all(|x| x.abs() < 1e30);
    let mut kept: Vec<u32> = (0..places.len() as u32).filter(finite).collect();
    let order = |i: &u32, j: &u32| {
        let [a, b] = [places[*i as usize], places[*j as usize]];
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(i.cmp(j))
    };
    kept.sort_by(order);
    kept.dedup_by(|later, first| places[*later as usize] == places[*first as usize]);
    kept.sort_unstable();
    kept
}

/// A rectangle from (0, 0) with a margin beyond the sides that wrap.
#[derive(Clone, Copy, Debug)]
pub struct Margin {
    /// Width and height.
    pub size: [f64; 2],
    /// Whether x and y wrap.
    pub wrap: [bool; 2],
    /// How far the margin reaches.
    pub width: f64,
}

impl Margin {
    /// The places with these indices, and their copies in the margin; along an axis that wraps they lie in the rectangle.
    #[must_use]
    pub fn corners(&self, places: &[[f64; 2]], indices: &[u32]) -> Vec<Corner> {
        let count =
            |axis: usize| if self.wrap[axis] { (self.width / self.size[axis]).ceil() as i32 + 1 } else { 0 };
        let mut corners = Vec::with_capacity(2 * indices.len());
        for down in -count(1)..=count(1) {
            for across in -count(0)..=count(0) {
                let shift = [f64::from(across) * self.size[0], f64::from(down) * self.size[1]];
                for index in indices {
                    let [x, y] = places[*index as usize];
                    let at = [x + shift[0], y + shift[1]];
                    if (0..2).all(|axis| self.holds(axis, at[axis])) {
                        let own = [across, down] == [0, 0];
                        let position = Point2::new(at[0], at[1]);
                        corners.push(Corner { position, point: Some(*index), own });
                    }
                }
            }
        }
        corners
    }

    fn holds(&self, axis: usize, at: f64) -> bool {
        !self.wrap[axis] || at >= -self.width && at <= self.size[axis] + self.width
    }

    /// Whether a circle with this centre and squared radius reaches nowhere beyond the margin.
    #[must_use]
    pub fn holds_circle(&self, (center, square): (Point2<f64>, f64)) -> bool {
        let radius = square.sqrt();
        let ends = |axis: usize, at: f64| self.holds(axis, at - radius) && self.holds(axis, at + radius);
        ends(0, center.x) && ends(1, center.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_points_that_coincide_stands_for_them_and_others_are_left_out() {
        let places = [[3.0, 1.0], [f64::NAN, 0.0], [2.0, 5.0], [3.0, 1.0], [1e31, 0.0]];
        assert_eq!(distinct(&places), [0, 2]);
        assert_eq!(tame([1e-31, -2.0]), [0.0, -2.0]);
    }

    #[test]
    fn copies_stand_beyond_the_sides_that_wrap() {
        let margin = Margin { size: [10.0, 6.0], wrap: [true, false], width: 3.0 };
        let corners = margin.corners(&[[1.0, 2.0], [5.0, 9.0]], &[0, 1]);
        let at: Vec<([f64; 2], bool)> =
            corners.iter().map(|corner| ([corner.position.x, corner.position.y], corner.own)).collect();
        assert_eq!(at, [([1.0, 2.0], true), ([5.0, 9.0], true), ([11.0, 2.0], false)]);
        assert!(margin.holds_circle((Point2::new(0.0, 90.0), 9.0)));
        assert!(!margin.holds_circle((Point2::new(11.0, 0.0), 9.0)));
    }
}
