//! Voronoi diagrams on a grid: the nearest point of each cell, with a metric for each point.
//!
//! A cell belongs to the point with the least form d² = xx·x² + 2·xy·x·y + yy·y² ([`Metric`]). Points are searched by the boxes
//! that contain all cells they may own.

use rayon::prelude::*;

use super::extent::Extent;
use super::metric::Metric;
use crate::grid::{BoxTiles, Domain, Grid};

/// Largest distance at which a point can own cells, in radii of its metric: if the radius is the distance of neighbours, no place
/// is farther from its nearest point. Cells in no such box are compared with all points.
const REACH: f64 = 1.5;

/// For each cell of `grid`, row by row, the index of the point that it belongs to; all 0 if there are no points.
///
/// The `metric` of a point is evaluated at its place; its radius is the distance of neighbours there, px.
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
    let around = |(at, metric): (&[f64; 2], &Metric)| {
        [-REACH, REACH].map(|reach| [0, 1].map(|axis| at[axis] + reach * metric.half[axis]))
    };
    let boxes = BoxTiles::new(extent.size, extent.wrap, side, points.iter().zip(&metrics).map(around));
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
        let near = least(&mut boxes.holding(at).iter().copied());
        let sure = near.filter(|(square, _)| *square <= REACH * REACH);
        sure.or_else(|| least(&mut (0..points.len() as u32))).map_or(0, |(_, point)| point)
    };
    (0..grid.cells()).into_par_iter().map(owner).collect()
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
            // With small metrics too, so that some cells are compared with all points.
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
