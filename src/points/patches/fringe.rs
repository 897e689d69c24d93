//! The noise that makes patches ragged, at the scale of the wanted detail however fine the points are.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rand::Rng;

use crate::points::delaunay::Delaunay;
use crate::points::labels::normal;

/// Shares of the noise that points have in common with the nearest of the coarse ones, and that each has of its own: the squares
/// add up to 1. In common alone, edges show the coarse cells.
const COMMON: [f64; 2] = [0.8, 0.6];

/// Standard normal noise of each point of `graph`, whose first `coarse` points are as far apart as the detail wants: others share
/// most of theirs with the nearest of these along the graph.
pub fn fringe(graph: &Delaunay, coarse: usize, rng: &mut impl Rng) -> Vec<f64> {
    let own: Vec<f64> = graph.points.iter().map(|_| normal(rng)).collect();
    let nearest = nearest(graph, coarse);
    let mixed = |point: usize| {
        let of = nearest[point] as usize;
        if of == point { own[point] } else { COMMON[0] * own[of] + COMMON[1] * own[point] }
    };
    (0..own.len()).map(mixed).collect()
}

/// The nearest of the first `coarse` points along the graph; a point that no way leads to is its own.
fn nearest(graph: &Delaunay, coarse: usize) -> Vec<u32> {
    let mut found: Vec<u32> = (0..graph.points.len() as u32).collect();
    let mut length = vec![f64::INFINITY; found.len()];
    let mut open = BinaryHeap::new();
    for (point, length) in length.iter_mut().enumerate().take(coarse) {
        *length = 0.0;
        // The bits of positive numbers are in the order of the numbers.
        open.push(Reverse((0u64, point as u32, point as u32)));
    }
    while let Some(Reverse((bits, point, of))) = open.pop() {
        let here = f64::from_bits(bits);
        if here > length[point as usize] {
            continue;
        }
        found[point as usize] = of;
        for axis in graph.axes(point as usize) {
            let Some(to) = axis.to else { continue };
            let there = here + (axis.way[0] * axis.way[0] + axis.way[1] * axis.way[1]).sqrt();
            if there < length[to as usize] {
                length[to as usize] = there;
                open.push(Reverse((there.to_bits(), to, of)));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::extent::Extent;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn points_share_the_noise_of_the_coarse_point_they_are_near() {
        let extent = Extent { size: [40.0, 10.0], wrap: [false; 2] };
        let row: Vec<[f64; 2]> = [5.0, 35.0, 10.0, 15.0, 25.0, 30.0].map(|x| [x, 5.0 + 0.01 * x]).to_vec();
        let graph = Delaunay::new(&row, extent);
        assert_eq!(nearest(&graph, 2), [0, 1, 0, 0, 1, 1]);
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let many: Vec<f64> = (0..400).flat_map(|_| fringe(&graph, 2, &mut rng)).collect();
        let mean = |each: &dyn Fn(&[f64]) -> f64| many.chunks(6).map(each).sum::<f64>() / 400.0;
        assert!((mean(&|noise| noise[2] * noise[2]) - 1.0).abs() < 0.2);
        assert!((mean(&|noise| noise[0] * noise[2]) - 0.8).abs() < 0.15);
        assert!(mean(&|noise| noise[0] * noise[4]).abs() < 0.15);
    }
}
