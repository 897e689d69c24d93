//! Poisson discs: random points, none in the disc of another, with no room for a further one.
//!
//! After M. S. Ebeida, S. A. Mitchell, A. Patney, A. A. Davidson, J. D. Owens, "A simple algorithm for maximal Poisson-disk
//! sampling in high dimensions", Computer Graphics Forum 31 (2012): darts are thrown at the cells that no disc covers; after each
//! round each cell is divided into four. A disc is an ellipse of the metric at its centre, which may vary over the plane.
//!
//! Every place then lies in a disc: with 2,000 round discs on a tile, the largest empty circle had .9993–1.0000 of the radius, and
//! a square whose side is the radius held .693–.700 points on average (eight seeds).

use rand::{Rng, RngExt};
use rayon::prelude::*;
use smallvec::SmallVec;

use super::extent::Extent;
use super::metric::Metric;

/// Points in a square whose side is the radius of a disc, when no room is left.
pub const POINTS_A_SQUARE: f64 = 0.7;
/// Darts thrown at each uncovered cell in a round; with 1 or 1.5 the computing time is the same within 10 %.
const DARTS: f64 = 0.6;
/// Rounds: the cells are then 2⁻¹⁴ of a radius wide, and uncovered remainders are invisible.
const ROUNDS: u32 = 14;

/// Number of discs that a bucket holds without allocation. A bucket as wide as the radius r of round discs meets (1 + 4 + π)·r²,
/// 5.7 discs on average.
const IN_PLACE: usize = 12;

/// A disc: its centre and the form of its metric.
#[derive(Clone, Copy)]
struct Disc {
    at: [f64; 2],
    form: [f64; 3],
}

impl Disc {
    fn covers(&self, at: [f64; 2]) -> bool {
        let [x, y] = [at[0] - self.at[0], at[1] - self.at[1]];
        self.form[0] * x * x + 2.0 * self.form[1] * x * y + self.form[2] * y * y < 1.0
    }
}

/// Discs, searched by place.
struct Placed<'a> {
    extent: &'a Extent,
    window: [[f64; 2]; 2],
    bucket: [f64; 2],
    size: [usize; 2],
    /// Discs and images of discs.
    discs: Vec<Disc>,
    /// For each bucket, the indices of the discs that meet it.
    buckets: Vec<SmallVec<[u32; IN_PLACE]>>,
    points: Vec<[f64; 2]>,
}

impl Placed<'_> {
    fn bucket_of(&self, at: [f64; 2], axis: usize) -> usize {
        (((at[axis] - self.window[0][axis]) / self.bucket[axis]).max(0.0) as usize).min(self.size[axis] - 1)
    }

    fn near(&self, at: [f64; 2]) -> impl Iterator<Item = &Disc> {
        let bucket = &self.buckets[self.bucket_of(at, 1) * self.size[0] + self.bucket_of(at, 0)];
        bucket.iter().map(|index| &self.discs[*index as usize])
    }

    fn is_free(&self, at: [f64; 2]) -> bool {
        !self.near(at).any(|disc| disc.covers(at))
    }

    /// The quarters of a cell that no single disc covers, by their column and row; `half` are their sides.
    ///
    /// The middle of the cell is a corner of each quarter, so only discs that cover it can cover a quarter.
    fn open_quarters(&self, [column, row]: [u32; 2], half: [f64; 2]) -> impl Iterator<Item = [u32; 2]> {
        let from = [2 * column, 2 * row];
        let lines =
            |axis: usize| [0, 1, 2].map(|k| self.window[0][axis] + f64::from(from[axis] + k) * half[axis]);
        let [xs, ys] = [lines(0), lines(1)];
        let mut covered = [false; 4];
        for disc in self.near([xs[1], ys[1]]).filter(|disc| disc.covers([xs[1], ys[1]])) {
            let [left, right] = [xs[0], xs[2]].map(|x| disc.covers([x, ys[1]]));
            let [above, below] = [ys[0], ys[2]].map(|y| disc.covers([xs[1], y]));
            covered[0] |= left && above && disc.covers([xs[0], ys[0]]);
            covered[1] |= right && above && disc.covers([xs[2], ys[0]]);
            covered[2] |= left && below && disc.covers([xs[0], ys[2]]);
            covered[3] |= right && below && disc.covers([xs[2], ys[2]]);
        }
        let quarters = [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().zip(covered);
        quarters.filter(|(_, covered)| !covered).map(move |([x, y], _)| [from[0] + x, from[1] + y])
    }

    fn insert(&mut self, at: [f64; 2], metric: Metric) {
        self.points.push(at);
        let [low, high] = [-1.0, 1.0].map(|sign| [0, 1].map(|axis| at[axis] + sign * metric.half[axis]));
        for shift in self.images(at, &metric, [low, high]) {
            let image = |at: [f64; 2]| [at[0] + shift[0], at[1] + shift[1]];
            let [from, to] = [image(low), image(high)];
            let index = self.discs.len() as u32;
            self.discs.push(Disc { at: image(at), form: metric.form });
            for row in self.bucket_of(from, 1)..=self.bucket_of(to, 1) {
                for column in self.bucket_of(from, 0)..=self.bucket_of(to, 0) {
                    self.buckets[row * self.size[0] + column].push(index);
                }
            }
        }
    }

    /// The shifts by which the disc at a point, within the box from `low` to `high`, meets the window. If one image covers the
    /// whole window, it alone is returned: a disc much larger than a tile has very many images.
    fn images(&self, at: [f64; 2], metric: &Metric, [low, high]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
        let [first, last] = self.window;
        let middle = [0, 1].map(|axis| 0.5 * (first[axis] + last[axis]));
        let displacement = [0, 1].map(|axis| middle[axis] - at[axis]);
        let nearest = self.extent.shortest(displacement);
        let shift = [0, 1].map(|axis| displacement[axis] - nearest[axis]);
        let disc = Disc { at: [0, 1].map(|axis| at[axis] + shift[axis]), form: metric.form };
        let corners = [first, [first[0], last[1]], [last[0], first[1]], last];
        if corners.iter().all(|corner| disc.covers(*corner)) {
            return vec![shift];
        }
        self.extent.images(low, high, self.window)
    }
}

/// The cost of laying discs of given radii.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Laying {
    /// Upper estimate of the number of points: large discs keep small ones farther away.
    pub points: f64,
    /// Number of buckets.
    pub buckets: f64,
    /// Number of places tried, in units of the trials for discs of one radius: where radii differ, the discs of each octave of
    /// radii cover the place.
    pub tries: f64,
    /// Density of points around a point ÷ mean density around a place; 1 for discs of one radius.
    pub crowding: f64,
}

impl Laying {
    /// The cost for discs of `metric` at each place over `extent` and a `margin`, px, as [`poisson_discs`] lays them.
    #[must_use]
    pub fn new(extent: &Extent, margin: f64, metric: &dyn Fn([f64; 2]) -> Metric) -> Self {
        let window = extent.framed(margin);
        let sides = [0, 1].map(|axis| window[1][axis] - window[0][axis]);
        let least = smallest(window, sides, metric);
        let radii = || places(window, sides).map(|at| metric(at).radius.max(least));
        let [smallest, largest] = radii()
            .fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], radius| [low.min(radius), high.max(radius)]);
        let densities = radii().map(|radius| radius.powi(-2));
        let [mean, square] = densities.fold([0.0; 2], |[mean, square], density| {
            [mean + density / PLACES, square + density * density / PLACES]
        });
        let points = (POINTS_A_SQUARE * mean * sides[0] * sides[1]).max(1.0);
        Self {
            points,
            tries: points * (1.0 + libm::log2(largest / smallest)),
            buckets: (sides[0] / least).ceil() * (sides[1] / least).ceil(),
            crowding: square / (mean * mean),
        }
    }

    /// The cost of laying these discs and then the `other` ones. All points are kept, but the buckets only while they are used.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            points: self.points + other.points,
            tries: self.tries + other.tries,
            buckets: self.buckets.max(other.buckets),
            crowding: self.crowding.max(other.crowding),
        }
    }
}

/// Poisson discs of `metric` at each place, px, over `extent` and, along the axes that do not wrap, a `margin`, px. The points
/// `first` are taken unchanged and come first.
///
/// Of any two points, at least one lies on the border or outside of the disc of the other. Discs are not smaller than 1/2,000 of
/// the longer side.
pub fn poisson_discs(
    extent: &Extent,
    margin: f64,
    metric: &dyn Fn([f64; 2]) -> Metric,
    first: &[[f64; 2]],
    rng: &mut impl Rng,
) -> Vec<[f64; 2]> {
    let window = extent.framed(margin);
    let sides = [0, 1].map(|axis| window[1][axis] - window[0][axis]);
    let least = smallest(window, sides, metric);
    // Cells whose diagonal is the radius of the smallest disc hold at most one point.
    let size = sides.map(|side| ((side * std::f64::consts::SQRT_2 / least).ceil() as usize).max(1));
    let buckets = sides.map(|side| ((side / least).ceil() as usize).max(1));
    let mut placed = Placed {
        extent,
        window,
        bucket: [sides[0] / buckets[0] as f64, sides[1] / buckets[1] as f64],
        size: buckets,
        discs: Vec::new(),
        buckets: vec![SmallVec::new(); buckets[0] * buckets[1]],
        points: Vec::new(),
    };
    first.iter().for_each(|at| placed.insert(*at, metric(*at)));
    let mut cells: Vec<[u32; 2]> =
        (0..size[1] as u32).flat_map(|row| (0..size[0] as u32).map(move |column| [column, row])).collect();
    let mut side = [sides[0] / size[0] as f64, sides[1] / size[1] as f64];
    for _ in 0..ROUNDS {
        let corner = |cell: [u32; 2]| [0, 1].map(|axis| window[0][axis] + f64::from(cell[axis]) * side[axis]);
        for _ in 0..(DARTS * cells.len() as f64).ceil() as usize {
            let index = ((rng.random::<f64>() * cells.len() as f64) as usize).min(cells.len() - 1);
            let low = corner(cells[index]);
            let at = [low[0] + rng.random::<f64>() * side[0], low[1] + rng.random::<f64>() * side[1]];
            if placed.is_free(at) {
                placed.insert(at, metric(at));
            }
        }
        let half = side.map(|side| 0.5 * side);
        cells = cells.into_par_iter().flat_map_iter(|cell| placed.open_quarters(cell, half)).collect();
        side = half;
    }
    placed.points
}

/// Number of places along each side at which the metric is sampled for its smallest radius.
const SAMPLES: usize = 48;
/// Number of all sampled places.
const PLACES: f64 = (SAMPLES * SAMPLES) as f64;
/// Largest number of buckets along a side: no picture shows finer points, and the memory grows with the square.
const MOST_BUCKETS: f64 = 2_000.0;

/// The smallest half axis of the discs, px.
fn smallest(window: [[f64; 2]; 2], sides: [f64; 2], metric: &dyn Fn([f64; 2]) -> Metric) -> f64 {
    let sample = |at: [f64; 2]| {
        let metric = metric(at);
        metric.radius * metric.radius / metric.half[0].max(metric.half[1])
    };
    let least = places(window, sides).map(sample).fold(f64::INFINITY, f64::min);
    least.max(sides[0].max(sides[1]) / MOST_BUCKETS)
}

/// Places spread evenly over a window, px.
fn places(window: [[f64; 2]; 2], sides: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let share = |n: usize| (n as f64 + 0.5) / SAMPLES as f64;
    let at = move |index: usize| {
        let [x, y] = [share(index % SAMPLES), share(index / SAMPLES)];
        [window[0][0] + x * sides[0], window[0][1] + y * sides[1]]
    };
    (0..SAMPLES * SAMPLES).map(at)
}

#[cfg(test)]
mod tests;
