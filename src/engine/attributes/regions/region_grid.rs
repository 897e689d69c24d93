//! The grid of regions: columns × rows equal rectangles of the canvas.

use crate::grid::{Bounds, Edges};

/// A canvas cut into columns × rows equal rectangles.
///
/// Regions are numbered row by row: region [column, row] has the index row · columns + column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionGrid {
    /// Width and height of the canvas, px; both positive.
    pub size: [f64; 2],
    /// Columns and rows; both at least 1.
    pub grid: [usize; 2],
    /// What lies beyond the border of the canvas.
    pub edges: Edges,
}

impl RegionGrid {
    /// The canvas, px, with its edges.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds { size: self.size, edges: self.edges }
    }

    /// Number of regions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.grid[0] * self.grid[1]
    }

    /// Whether there is no region at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// [column, row] of the region with this index.
    #[must_use]
    pub fn place(&self, index: usize) -> [usize; 2] {
        [index % self.grid[0], index / self.grid[0]]
    }

    /// Index of the region at [column, row].
    #[must_use]
    pub fn index(&self, [column, row]: [usize; 2]) -> usize {
        row * self.grid[0] + column
    }

    /// Centre of a region, px.
    #[must_use]
    pub fn center(&self, place: [usize; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (place[axis] as f64 + 0.5) * self.size[axis] / self.grid[axis] as f64)
    }

    /// [column, row] of the region that a point (px) lies in; on an inner border the right or lower one.
    ///
    /// On the right or lower border of the canvas it is the last one. Beyond the canvas it is the nearest
    /// one (`Closed`) or the one that the point comes to lie in on the tile (`Wrap`).
    #[must_use]
    pub fn region_of(&self, point: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| {
            let (n, size, mut x) = (self.grid[axis], self.size[axis], point[axis]);
            if self.edges == Edges::Wrap && !(0.0..=size).contains(&x) {
                x = x.rem_euclid(size);
            }
            // The cast takes negative numbers to 0.
            ((x * n as f64 / size) as usize).min(n - 1)
        })
    }

    /// Squared distance between two regions, in regions; across the border on `Wrap`.
    #[must_use]
    pub fn distance_squared(&self, a: [usize; 2], b: [usize; 2]) -> usize {
        let step = |axis: usize| {
            let straight = a[axis].abs_diff(b[axis]);
            match self.edges {
                Edges::Closed => straight,
                Edges::Wrap => straight.min(self.grid[axis] - straight),
            }
        };
        step(0) * step(0) + step(1) * step(1)
    }

    /// Of the regions for which `holds` is true, the one nearest to `place`; ties go to the smaller row, then the
    /// smaller column.
    pub fn nearest(&self, place: [usize; 2], mut holds: impl FnMut(usize) -> bool) -> Option<usize> {
        // Squared distance and index.
        let mut nearest: Option<(usize, usize)> = None;
        // Regions `ring` columns or rows away are at least that far.
        for ring in 0..=self.grid[0].max(self.grid[1]) as isize {
            if nearest.is_some_and(|(squared, _)| squared < (ring * ring) as usize) {
                break;
            }
            for down in -ring..=ring {
                let every = if down.abs() == ring { 1 } else { 2 * ring.max(1) as usize };
                for right in (-ring..=ring).step_by(every) {
                    let Some(at) = self.stepped(place, [right, down]) else { continue };
                    let found = (self.distance_squared(place, at), self.index(at));
                    if nearest.is_none_or(|nearest| found < nearest) && holds(found.1) {
                        nearest = Some(found);
                    }
                }
            }
        }
        nearest.map(|(_, index)| index)
    }

    /// The region so many columns and rows from `place`, across the border on `Wrap`; `None` outside.
    fn stepped(&self, place: [usize; 2], by: [isize; 2]) -> Option<[usize; 2]> {
        let step = |axis: usize| {
            let to = place[axis] as isize + by[axis];
            let n = self.grid[axis] as isize;
            match self.edges {
                Edges::Closed => (0..n).contains(&to).then_some(to as usize),
                Edges::Wrap => Some(to.rem_euclid(n) as usize),
            }
        };
        Some([step(0)?, step(1)?])
    }

    /// The regions between whose centres a point (px) lies, by index, with their bilinear weights (sum 1).
    ///
    /// Beyond the outer centres the point is clamped (`Closed`) or the other side follows (`Wrap`). One
    /// region may be listed several times. Any quantity known at region centres is interpolated with these weights.
    #[must_use]
    pub fn corners(&self, point: [f64; 2]) -> [(usize, f64); 4] {
        let [(left, right, fx), (upper, lower, fy)] = [0, 1].map(|axis| self.between(axis, point[axis]));
        let row = self.grid[0];
        [
            (upper * row + left, (1.0 - fx) * (1.0 - fy)),
            (upper * row + right, fx * (1.0 - fy)),
            (lower * row + left, (1.0 - fx) * fy),
            (lower * row + right, fx * fy),
        ]
    }

    /// The two columns (`axis` 0) or rows (1) between whose centres `x` (px) lies, and the share of the second.
    #[must_use]
    pub fn between(&self, axis: usize, x: f64) -> (usize, usize, f64) {
        let n = self.grid[axis];
        let last = (n - 1) as f64;
        let t = x * n as f64 / self.size[axis] - 0.5;
        match self.edges {
            Edges::Closed => {
                let t = t.clamp(0.0, last);
                let low = t.floor();
                (low as usize, (low as usize + 1).min(n - 1), t - low)
            }
            Edges::Wrap => {
                let low = t.floor();
                // On the canvas only the half region at the border is out of range; points beyond are rare.
                let on_tile = if (0.0..=last).contains(&low) { low } else { low.rem_euclid(n as f64) };
                let first = on_tile as usize;
                (first, if first + 1 == n { 0 } else { first + 1 }, t - low)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(grid: [usize; 2], edges: Edges) -> RegionGrid {
        RegionGrid { size: [300.0, 200.0], grid, edges }
    }

    #[test]
    fn a_point_on_an_inner_border_lies_right_and_below_and_on_the_far_border_in_the_last_region() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let layout = layout([3, 2], edges);
            assert_eq!(layout.region_of([0.0, 0.0]), [0, 0]);
            assert_eq!(layout.region_of([99.9, 99.9]), [0, 0]);
            assert_eq!(layout.region_of([100.0, 100.0]), [1, 1]);
            assert_eq!(layout.region_of([200.0, 0.0]), [2, 0]);
            assert_eq!(layout.region_of([300.0, 200.0]), [2, 1]);
        }
    }

    #[test]
    fn a_point_beyond_the_canvas_lies_in_the_nearest_region_or_comes_back_on_a_tile() {
        assert_eq!(layout([3, 2], Edges::Closed).region_of([-5.0, 900.0]), [0, 1]);
        assert_eq!(layout([3, 2], Edges::Wrap).region_of([-5.0, 210.0]), [2, 0]);
        assert_eq!(layout([3, 2], Edges::Wrap).region_of([-1e-30, -0.0]), [2, 0]);
    }

    #[test]
    fn ties_between_near_regions_go_to_the_smaller_row_and_then_column() {
        let closed = layout([3, 3], Edges::Closed);
        assert_eq!(closed.nearest([1, 1], |i| [1, 3, 5, 7].contains(&i)), Some(1));
        assert_eq!(closed.nearest([1, 1], |i| [3, 5, 7].contains(&i)), Some(3));
        assert_eq!(closed.nearest([1, 1], |i| [0, 7].contains(&i)), Some(7));
        assert_eq!(closed.nearest([1, 1], |_| false), None);
        let five = |edges| RegionGrid { size: [50.0, 10.0], grid: [5, 1], edges };
        assert_eq!(five(Edges::Closed).nearest([0, 0], |i| [2, 4].contains(&i)), Some(2));
        assert_eq!(five(Edges::Wrap).nearest([0, 0], |i| [2, 4].contains(&i)), Some(4));
    }

    #[test]
    fn the_nearest_region_is_that_of_a_full_search() {
        for (edges, grid) in [Edges::Closed, Edges::Wrap]
            .into_iter()
            .flat_map(|edges| [[1, 1], [7, 1], [2, 9], [6, 5], [8, 8]].map(|grid| (edges, grid)))
        {
            let layout = layout(grid, edges);
            for every in [1, 2, 3, 5, 11, 23, 1000] {
                let holds = |index: usize| (index * 37 + 5).is_multiple_of(every);
                for index in 0..layout.len() {
                    let place = layout.place(index);
                    let among = (0..layout.len()).filter(|other| holds(*other));
                    let full = among.min_by_key(|other| layout.distance_squared(place, layout.place(*other)));
                    assert_eq!(layout.nearest(place, holds), full, "{edges:?} {grid:?} {every} {index}");
                }
            }
        }
    }

    #[test]
    fn corners_are_the_four_centres_around_a_point() {
        let at = |edges, point| layout([3, 2], edges).corners(point);
        assert_eq!(at(Edges::Closed, [75.0, 75.0]), [(0, 0.5625), (1, 0.1875), (3, 0.1875), (4, 0.0625)]);
        assert_eq!(at(Edges::Closed, [0.0, 0.0]), [(0, 1.0), (1, 0.0), (3, 0.0), (4, 0.0)]);
        assert_eq!(at(Edges::Closed, [300.0, 200.0]), [(5, 1.0), (5, 0.0), (5, 0.0), (5, 0.0)]);
        assert_eq!(at(Edges::Wrap, [0.0, 0.0]), [(5, 0.25), (3, 0.25), (2, 0.25), (0, 0.25)]);
    }
}
