//! Scattered points, sorted by a uniform grid of buckets: those near a place are found without looking at all of them
//! (Bentley and Friedman, "Data structures for range searching", ACM Computing Surveys 11(4), 1979).

use std::ops::RangeInclusive;

use super::edges::{Bounds, Edges};

/// Points a bucket, in the mean. Not tuned.
pub const IN_A_BUCKET: f64 = 2.0;

/// Points on a canvas, or beyond its closed edges.
#[derive(Clone, Debug, PartialEq)]
pub struct PointBuckets {
    bounds: Bounds,
    at: Vec<[f64; 2]>,
    /// The corner of the first bucket, px.
    corner: [f64; 2],
    /// Sides of a bucket, px.
    sides: [f64; 2],
    /// Columns and rows of buckets.
    grid: [usize; 2],
    /// Where in `sorted` each bucket begins, and the number of points.
    starts: Vec<u32>,
    /// Indices of the points, bucket by bucket.
    sorted: Vec<u32>,
}

impl PointBuckets {
    /// The points `at`, px.
    #[must_use]
    pub fn new(bounds: Bounds, at: Vec<[f64; 2]>) -> Self {
        let (corner, extent) = match bounds.edges {
            Edges::Wrap => ([0.0; 2], bounds.size),
            Edges::Closed => box_of(&at),
        };
        let buckets = (at.len() as f64 / IN_A_BUCKET).max(1.0);
        let side = (extent[0] * extent[1] / buckets).sqrt();
        // Of places in a row the area is 0.
        let side = side.max(extent[0].max(extent[1]) / buckets).max(f64::MIN_POSITIVE);
        let grid = extent.map(|extent| (extent / side).floor().max(1.0) as usize);
        let sides = [0, 1].map(|axis| (extent[axis] / grid[axis] as f64).max(f64::MIN_POSITIVE));
        let starts = vec![0; grid[0] * grid[1] + 1];
        let mut places = Self { bounds, at, corner, sides, grid, starts, sorted: Vec::new() };
        places.sort();
        places
    }

    /// Counting sort.
    fn sort(&mut self) {
        let buckets: Vec<usize> = self.at.iter().map(|at| self.index(self.bucket_of(*at))).collect();
        buckets.iter().for_each(|bucket| self.starts[bucket + 1] += 1);
        for bucket in 1..self.starts.len() {
            self.starts[bucket] += self.starts[bucket - 1];
        }
        let mut next = self.starts.clone();
        self.sorted = vec![0; self.at.len()];
        for (index, bucket) in buckets.into_iter().enumerate() {
            self.sorted[next[bucket] as usize] = index as u32;
            next[bucket] += 1;
        }
    }

    /// The points, px.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.at
    }

    /// Where they lie.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// How far a point is from a place, squared, px²; on a tile by the shortest displacement.
    fn square(&self, index: usize, point: [f64; 2]) -> f64 {
        let [x, y] = self.bounds.shortest([self.at[index][0] - point[0], self.at[index][1] - point[1]]);
        x * x + y * y
    }

    /// The squared distances of the `count` points nearest to a place, px², ascending; those that are not `kept` do not
    /// count.
    ///
    /// ```
    /// use dapple_engine::grid::{Bounds, Edges, PointBuckets};
    ///
    /// let tile = Bounds { size: [100.0, 100.0], edges: Edges::Wrap };
    /// let points = PointBuckets::new(tile, vec![[95.0, 50.0], [40.0, 50.0]]);
    /// // Squares of the distances, px²; the nearest lies across the border.
    /// assert_eq!(points.nearest([5.0, 50.0], 1, |_| true), [100.0]);
    /// ```
    pub fn nearest(&self, point: [f64; 2], count: usize, kept: impl Fn(usize) -> bool) -> Vec<f64> {
        let from = self.bucket_of(point);
        // Along an axis with one bucket nothing lies in farther rings.
        let parted = (0..2).filter(|axis| self.grid[*axis] > 1);
        let side = parted.map(|axis| self.sides[axis]).fold(f64::INFINITY, f64::min);
        let mut squares = Vec::with_capacity(4 * count);
        for ring in 0..=self.grid[0].max(self.grid[1]) as isize {
            self.each_in_ring(from, ring, |index| {
                if kept(index) {
                    squares.push(self.square(index, point));
                }
            });
            // What lies in farther rings is at least so many sides away.
            let reached = if ring > 0 { side * ring as f64 } else { 0.0 };
            if squares.len() >= count.max(1) {
                let (_, last, _) = squares.select_nth_unstable_by(count.max(1) - 1, f64::total_cmp);
                if *last <= reached * reached {
                    break;
                }
            }
        }
        squares.sort_unstable_by(f64::total_cmp);
        squares.truncate(count);
        squares
    }

    /// The indices of all points within `radius` px of a place, and perhaps of some farther ones, ascending.
    #[must_use]
    pub fn within(&self, point: [f64; 2], radius: f64) -> Vec<u32> {
        let from = self.bucket_of(point);
        let [columns, rows] = [0, 1].map(|axis| {
            let steps = self.steps(axis, from);
            let reach = (radius / self.sides[axis]).ceil();
            // The cast takes what is too large to the bound.
            let reach = (reach as isize).min(self.grid[axis] as isize);
            -reach.min(-steps.start())..=reach.min(*steps.end())
        });
        let mut found = Vec::new();
        for down in rows {
            for right in columns.clone() {
                found.extend_from_slice(self.bucket(from, [right, down]));
            }
        }
        // A little more, for the rounding of the displacements.
        let most = radius * radius * (1.0 + 1e-9);
        found.retain(|index| self.square(*index as usize, point) <= most);
        found.sort_unstable();
        found
    }

    /// Calls `each` with the points of the buckets so many columns or rows from `from`.
    fn each_in_ring(&self, from: [usize; 2], ring: isize, mut each: impl FnMut(usize)) {
        let [columns, rows] = [0, 1].map(|axis| self.steps(axis, from));
        let [left, right] = [(-ring).max(*columns.start()), ring.min(*columns.end())];
        for down in (-ring).max(*rows.start())..=ring.min(*rows.end()) {
            let mut of = |right| {
                self.bucket(from, [right, down]).iter().for_each(|index| each(*index as usize));
            };
            if down.abs() == ring {
                (left..=right).for_each(of);
            } else {
                [-ring, ring].into_iter().filter(|right| columns.contains(right)).for_each(&mut of);
            }
        }
    }

    /// How many columns (`axis` 0) or rows (1) there are before and after a bucket; on a tile the shorter way round.
    fn steps(&self, axis: usize, from: [usize; 2]) -> RangeInclusive<isize> {
        let (n, at) = (self.grid[axis] as isize, from[axis] as isize);
        match self.bounds.edges {
            Edges::Closed => -at..=n - 1 - at,
            Edges::Wrap => -((n - 1) / 2)..=n / 2,
        }
    }

    /// The points in the bucket so many columns and rows from another one.
    fn bucket(&self, from: [usize; 2], by: [isize; 2]) -> &[u32] {
        let at = [0, 1].map(|axis| (from[axis] as isize + by[axis]).rem_euclid(self.grid[axis] as isize));
        let index = self.index(at.map(|at| at as usize));
        &self.sorted[self.starts[index] as usize..self.starts[index + 1] as usize]
    }

    /// The bucket of a place, or the one nearest to it.
    fn bucket_of(&self, point: [f64; 2]) -> [usize; 2] {
        let point = match self.bounds.edges {
            Edges::Closed => point,
            Edges::Wrap => self.bounds.folded(point),
        };
        // The cast takes negative numbers to 0.
        [0, 1].map(|axis| {
            (((point[axis] - self.corner[axis]) / self.sides[axis]) as usize).min(self.grid[axis] - 1)
        })
    }

    fn index(&self, [column, row]: [usize; 2]) -> usize {
        row * self.grid[0] + column
    }
}

/// The corner and the extent of the box around points, px.
fn box_of(at: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
    let along = |axis: usize| at.iter().map(move |at| at[axis]);
    let low = [0, 1].map(|axis| along(axis).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max));
    if at.is_empty() { ([0.0; 2], [0.0; 2]) } else { (low, [high[0] - low[0], high[1] - low[1]]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Places all over a canvas and beyond it, in a row, at one point, and none.
    fn samples() -> Vec<Vec<[f64; 2]>> {
        let mut rng = Pcg64Mcg::seed_from_u64(5);
        let mut scattered = |n: usize| -> Vec<[f64; 2]> {
            (0..n).map(|_| [80.0 * rng.random::<f64>() - 10.0, 50.0 * rng.random::<f64>() - 5.0]).collect()
        };
        let row = (0..40).map(|i| [f64::from(i), 7.0]).collect();
        vec![scattered(1), scattered(2), scattered(30), scattered(400), row, vec![[3.0, 4.0]; 9], Vec::new()]
    }

    #[test]
    fn what_is_near_is_what_a_full_search_finds() {
        for (edges, at) in [Edges::Closed, Edges::Wrap]
            .into_iter()
            .flat_map(|edges| samples().into_iter().map(move |at| (edges, at)))
        {
            let places = PointBuckets::new(Bounds { size: [60.0, 40.0], edges }, at.clone());
            for i in 0..60 {
                let point = [2.0 * f64::from(i) - 20.0, 37.0 * f64::from(i % 7) / 3.0 - 15.0];
                let kept = |index: usize| index % 5 != i as usize % 5;
                let mut all: Vec<f64> =
                    (0..at.len()).filter(|i| kept(*i)).map(|i| places.square(i, point)).collect();
                all.sort_by(f64::total_cmp);
                for count in [0, 1, 3, 24, 1000] {
                    let found = places.nearest(point, count, kept);
                    assert_eq!(found, all[..count.min(all.len())], "{edges:?} {point:?} {count}");
                }
                for radius in [0.0, 3.0, 17.0, 1e9] {
                    let found = places.within(point, radius);
                    assert!(found.is_sorted());
                    let inside = |i: &u32| places.square(*i as usize, point) <= radius * radius;
                    let all: Vec<u32> = (0..at.len() as u32).filter(inside).collect();
                    let near: Vec<u32> = found.iter().copied().filter(inside).collect();
                    assert_eq!(near, all, "{edges:?} {point:?} {radius}");
                    let far = found
                        .iter()
                        .filter(|i| places.square(**i as usize, point).sqrt() > radius + 1e-3 * radius);
                    assert_eq!(far.count(), 0);
                }
            }
        }
    }
}
