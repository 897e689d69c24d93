//! Kernels: how much the marks around a point count.

use crate::grid::{Bounds, Edges, PointBuckets};

/// Squared radius of a kernel ÷ squared distance to the k-th mark: at an even density its weights add up to k.
const REACH: f64 = 5.0;

/// Share of the squared distance to the nearest mark that all squared distances are lessened by.
const NEAREST: f64 = 0.65;

/// Least radius, as a share of the root of the canvas' area: values of marks nearer to each other than that are one.
const LEAST: f64 = 0.06;

/// Kernels of several radii about a point.
pub(super) struct Kernels<const K: usize> {
    bounds: Bounds,
    point: [f64; 2],
    kernels: [Kernel; K],
    /// Beyond this distance all are 0, px.
    radius: f64,
}

impl<const K: usize> Kernels<K> {
    /// The kernels that reach so many `neighbours` of the marks at `centers`; those that are not `kept` do not count.
    pub fn new(
        centers: &PointBuckets,
        point: [f64; 2],
        kept: impl Fn(usize) -> bool,
        neighbours: &[usize; K],
    ) -> Self {
        let bounds = centers.bounds();
        let most = neighbours.iter().fold(1, |most, neighbours| (3 * neighbours / 2).max(most));
        let squares = centers.nearest(point, most, kept);
        let narrowest = LEAST * (bounds.size[0] * bounds.size[1]).sqrt();
        let widest = match bounds.edges {
            Edges::Closed => f64::INFINITY,
            // Beyond that, nothing but further images of the same marks would count.
            Edges::Wrap => bounds.size[0].max(bounds.size[1]),
        };
        let kernels = neighbours.map(|neighbours| Kernel::reaching(neighbours, &squares, narrowest, widest));
        let radius = kernels.iter().map(Kernel::radius).fold(0.0, f64::max);
        Self { bounds, point, kernels, radius }
    }

    /// The `places` that may lie in one of the kernels, by index, ascending.
    pub fn covered(&self, places: &PointBuckets) -> Vec<u32> {
        places.within(self.point, self.radius)
    }

    /// Calls `add` with the index of each kernel in which `place` or, on a tile, one of its images lies, the displacement there
    /// (px) and the weight that it has.
    pub fn each(&self, place: [f64; 2], mut add: impl FnMut(usize, [f64; 2], f64)) {
        let displacement = self.bounds.shortest([place[0] - self.point[0], place[1] - self.point[1]]);
        let mut near = |displacement: [f64; 2]| {
            let square = displacement[0] * displacement[0] + displacement[1] * displacement[1];
            for (index, kernel) in self.kernels.iter().enumerate() {
                let weight = kernel.at(square);
                if weight > 0.0 {
                    add(index, displacement, weight);
                }
            }
        };
        match self.bounds.edges {
            Edges::Wrap => for_images(&self.bounds, displacement, self.radius, near),
            Edges::Closed
                if displacement[0] * displacement[0] + displacement[1] * displacement[1]
                    < self.radius * self.radius =>
            {
                near(displacement);
            }
            Edges::Closed => {}
        }
    }
}

/// Calls `near` with the displacement to each image on a tile that is within `radius`, px.
pub(super) fn for_images(
    bounds: &Bounds,
    displacement: [f64; 2],
    radius: f64,
    mut near: impl FnMut([f64; 2]),
) {
    let span = |axis: usize| {
        let side = bounds.size[axis];
        let first = ((-radius - displacement[axis]) / side).ceil() as i32;
        let last = ((radius - displacement[axis]) / side).floor() as i32;
        (first..=last).map(move |image| displacement[axis] + f64::from(image) * side)
    };
    for y in span(1) {
        span(0).filter(|x| x * x + y * y < radius * radius).for_each(|x| near([x, y]));
    }
}

/// (1 − (d² − `least`) ÷ `reach`)⁴ of the distance d, px.
#[derive(Clone, Copy, Debug)]
struct Kernel {
    least: f64,
    reach: f64,
}

impl Kernel {
    /// The kernel that reaches `neighbours` marks; `squares` are the squared distances of at least half as many more, as
    /// far as there are, ascending.
    ///
    /// Its radius follows from several of them, so that it varies less than one of them does. Far from all marks what
    /// counts is how much farther than the nearest one another is.
    fn reaching(neighbours: usize, squares: &[f64], narrowest: f64, widest: f64) -> Self {
        let [first, ..] = *squares else { return Self { least: 0.0, reach: 0.0 } };
        // Fewer marks than that: as far as so many would reach at the same density.
        let a_mark = |n: usize| {
            let n = n.min(squares.len());
            (squares[n - 1] - first) / n as f64
        };
        let range = neighbours / 2 + 1..=3 * neighbours / 2;
        let count = range.clone().count() as f64;
        let last = first + neighbours as f64 * range.map(a_mark).sum::<f64>() / count;
        let least = NEAREST * first;
        let reach = (REACH * (last - least)).max(narrowest * narrowest).min(widest * widest - least);
        Self { least, reach }
    }

    fn at(&self, square: f64) -> f64 {
        let t = 1.0 - (square - self.least).max(0.0) / self.reach;
        if t > 0.0 { t * t * t * t } else { 0.0 }
    }

    /// Distance beyond which it is 0, px.
    fn radius(&self) -> f64 {
        (self.least + self.reach).sqrt()
    }
}
