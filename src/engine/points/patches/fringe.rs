//! The noise that makes patches ragged, at the scale of the wanted detail for any density of points.

use rand::Rng;

use crate::points::graph::PointGraph;
use crate::points::labels::normal;
use crate::points::ways::ways;

/// Weights of the noise of the nearest coarse point and of a point's own noise; the squares add up to 1. With the common noise
/// alone, edges would show the coarse cells.
const COMMON: [f64; 2] = [0.8, 0.6];

/// Standard normal noise of each point of `graph`. The first `coarse` points are as far apart as the wanted detail; the other
/// points share most of their noise with the nearest of these along the graph.
pub fn fringe(graph: &impl PointGraph, coarse: usize, rng: &mut impl Rng) -> Vec<f64> {
    let own: Vec<f64> = (0..graph.count()).map(|_| normal(rng)).collect();
    let nearest = ways(graph, 0..coarse, |_| true).from;
    let mixed = |point: usize| {
        let of = nearest[point] as usize;
        if of == point { own[point] } else { COMMON[0] * own[of] + COMMON[1] * own[point] }
    };
    (0..own.len()).map(mixed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::delaunay::Delaunay;
    use crate::points::extent::Extent;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn points_share_the_noise_of_the_nearest_coarse_point() {
        let extent = Extent { size: [40.0, 10.0], wrap: [false; 2] };
        let row: Vec<[f64; 2]> = [5.0, 35.0, 10.0, 15.0, 25.0, 30.0].map(|x| [x, 5.0 + 0.01 * x]).to_vec();
        let graph = Delaunay::new(&row, extent);
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let many: Vec<f64> = (0..400).flat_map(|_| fringe(&graph, 2, &mut rng)).collect();
        let mean = |each: &dyn Fn(&[f64]) -> f64| many.chunks(6).map(each).sum::<f64>() / 400.0;
        assert!((mean(&|noise| noise[2] * noise[2]) - 1.0).abs() < 0.2);
        assert!((mean(&|noise| noise[0] * noise[2]) - 0.8).abs() < 0.15);
        assert!(mean(&|noise| noise[0] * noise[4]).abs() < 0.15);
    }
}
