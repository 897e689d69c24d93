//! Voronoi diagrams on a grid: which point each cell belongs to, by a metric of its own for each point.
//!
//! A cell belongs to the point of the least form d² = xx·x² + 2·xy·x·y + yy·y² ([`Metric`]). Points are found by buckets, into
//! which each is put as far as it can matter.

use rayon::prelude::*;

use super::extent::Extent;
use super::metric::Metric;
use crate::grid::{Domain, Grid};

/// How far a point can own cells, in the radii of its metric: with a metric as large as the distance of neighbours, no place is that
/// far from its nearest point. Cells that no bucket answers for are compared with all points.
const REACH: f64 = 1.5;

/// Of each cell of `grid`, row by row, the number of the point that it belongs to; all 0 where there are none.
///
/// The `metric` of a point is asked at its place; its radius is the distance of neighbours there, px.
///
/// ```
/// use dapple_engine::grid::{Edges, Grid};
/// use dapple_engine::points::{extent::Extent, metric::Metric, voronoi::owners};
///
/// let extent = Extent { size: [4.0, 1.0], wrap: [false, false] };
/// let grid = Grid::unit([4, 1], Edges::Closed);
/// let points = [[0.5, 0.5], [3.5, 0.5]];
/// assert_eq!(owners(&points, &|_| Metric::circle(3.0), &extent, &grid), [0, 0, 1, 1]);
/// ```
#[must_use]
pub fn owners(
    points: &[[f64; 2]],
    metric: &(dyn Fn([f64; 2]) -> Metric + Sync),
    extent: &Extent,
    grid: &Grid,
) -> Vec<u32> {
    let metrics: Vec<Metric> = points.iter().map(|at| metric(*at)).collect();
    let radii = metrics.iter().map(|metric| metric.radius);
    let side = radii.sum::<f64>() / metrics.len().max(1) as f64;
    let buckets = Buckets::new(points, &metrics, extent, side);
    let square = |point: u32, at: [f64; 2]| {
        let [x, y] = points[point as usize];
        metrics[point as usize].square(extent.shortest([at[0] - x, at[1] - y]))
    };
    let owner = |cell: usize| {
        let at = grid.center_px(cell);
        let least = |near: &mut dyn Iterator<Item = u32>| {
            near.map(|point| (square(point, at), point)).fold(None, |least: Option<(f64, u32)>, found| {
                Some(least.filter(|least| least.0 <= found.0).unwrap_or(found))
            })
        };
        let near = least(&mut buckets.at(at).iter().copied());
        let sure = near.filter(|(square, _)| *square <= REACH * REACH);
        sure.or_else(|| least(&mut (0..points.len() as u32))).map_or(0, |(_, point)| point)
    };
    (0..grid.cells()).into_par_iter().map(owner).collect()
}

/// Squares over the canvas with the points that can own cells there, in the order of their numbers.
struct Buckets {
    side: [f64; 2],
    size: [usize; 2],
    points: Vec<Vec<u32>>,
}

impl Buckets {
    fn new(points: &[[f64; 2]], metrics: &[Metric], extent: &Extent, side: f64) -> Self {
        let size =
            extent.size.map(|whole| (whole / side.max(f64::MIN_POSITIVE)).clamp(1.0, 1_000.0) as usize);
        let side = [0, 1].map(|axis| extent.size[axis] / size[axis] as f64);
        let mut buckets = Self { side, size, points: vec![Vec::new(); size[0] * size[1]] };
        let window = [[0.0; 2], extent.size];
        for (index, (at, metric)) in points.iter().zip(metrics).enumerate() {
            let [low, high] =
                [-REACH, REACH].map(|reach| [0, 1].map(|axis| at[axis] + reach * metric.half[axis]));
            let [low, high] = extent.within_a_side(low, high);
            for shift in extent.images(low, high, window) {
                let [from, to] = [low, high].map(|at| buckets.place([at[0] + shift[0], at[1] + shift[1]]));
                for row in from[1]..=to[1] {
                    for column in from[0]..=to[0] {
                        let own = &mut buckets.points[row * size[0] + column];
                        if own.last() != Some(&(index as u32)) {
                            own.push(index as u32);
                        }
                    }
                }
            }
        }
        buckets
    }

    fn place(&self, at: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| ((at[axis] / self.side[axis]).max(0.0) as usize).min(self.size[axis] - 1))
    }

    fn at(&self, at: [f64; 2]) -> &[u32] {
        let [column, row] = self.place(at);
        &self.points[row * self.size[0] + column]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn each_cell_belongs_to_its_nearest_point() {
        for edges in [Edges::Wrap, Edges::Closed] {
            let grid = Grid { size: [90, 60], cell: [1.5, 1.5], edges };
            let extent = Extent::from(grid.bounds_px());
            let mut rng = Pcg64Mcg::seed_from_u64(5);
            let points: Vec<[f64; 2]> =
                (0..40).map(|_| [135.0 * rng.random::<f64>(), 90.0 * rng.random::<f64>()]).collect();
            // Small metrics too, so that some cells are answered by all points.
            for radius in [4.0, 20.0] {
                let metric = |at: [f64; 2]| Metric::ellipse(radius + 0.02 * at[0], 0.6, at[1]);
                let found = owners(&points, &metric, &extent, &grid);
                for (cell, owner) in found.iter().enumerate() {
                    let square = |point: usize| {
                        let [x, y] = grid.center_px(cell);
                        metric(points[point])
                            .square(extent.shortest([x - points[point][0], y - points[point][1]]))
                    };
                    let least = (0..points.len()).map(square).fold(f64::INFINITY, f64::min);
                    assert!(square(*owner as usize) <= least, "{edges:?} {radius} {cell}");
                }
            }
        }
        assert_eq!(
            owners(
                &[],
                &|_| Metric::circle(1.0),
                &Extent { size: [2.0, 2.0], wrap: [true; 2] },
                &Grid::unit([2, 2], Edges::Wrap)
            ),
            [0; 4]
        );
    }

    #[test]
    fn metrics_far_larger_than_a_tile_are_compared_without_their_images() {
        let grid = Grid { size: [12, 8], cell: [0.5, 0.5], edges: Edges::Wrap };
        let extent = Extent::from(grid.bounds_px());
        let of = |radius: f64| owners(&[[1.0, 1.0], [4.0, 3.0]], &|_| Metric::circle(radius), &extent, &grid);
        assert_eq!(of(1e9), of(20.0));
    }
}
