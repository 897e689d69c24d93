//! Shortest paths along the graph from some of its points to all others (Dijkstra's algorithm).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::graph::PointGraph;

/// The shortest path to each point.
pub struct Ways {
    /// The start of the path; a point that no path reaches has its own index.
    pub from: Vec<u32>,
    /// Length of the path, px; infinite if there is none.
    pub length: Vec<f64>,
}

/// The shortest paths along the edges of `graph` from the nearest of `starts`, only through points that are `open`.
pub fn ways(
    graph: &impl PointGraph,
    starts: impl IntoIterator<Item = usize>,
    open: impl Fn(usize) -> bool,
) -> Ways {
    let mut from: Vec<u32> = (0..graph.count() as u32).collect();
    let mut length = vec![f64::INFINITY; from.len()];
    let mut queue = BinaryHeap::new();
    for point in starts.into_iter().filter(|point| open(*point)) {
        length[point] = 0.0;
        // The bits of positive floating-point numbers are ordered like the numbers.
        queue.push(Reverse((0u64, point as u32, point as u32)));
    }
    while let Some(Reverse((bits, point, of))) = queue.pop() {
        let here = f64::from_bits(bits);
        if here > length[point as usize] {
            continue;
        }
        from[point as usize] = of;
        for axis in graph.axes(point as usize) {
            let Some(to) = axis.to.filter(|to| open(*to as usize)) else { continue };
            let there = here
                + (axis.displacement[0] * axis.displacement[0] + axis.displacement[1] * axis.displacement[1])
                    .sqrt();
            if there < length[to as usize] {
                length[to as usize] = there;
                queue.push(Reverse((there.to_bits(), to, of)));
            }
        }
    }
    Ways { from, length }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::delaunay::Delaunay;
    use crate::points::extent::Extent;

    #[test]
    fn paths_lead_from_the_nearest_start_and_round_closed_points() {
        let extent = Extent { size: [60.0, 30.0], wrap: [false; 2] };
        let rows = [5.0, 15.0, 25.0].map(|y| [5.0, 15.0, 25.0, 35.0, 45.0, 55.0].map(|x| [x + 0.01 * y, y]));
        let graph = Delaunay::new(&rows.concat(), extent);
        let all = ways(&graph, [0, 5], |_| true);
        assert_eq!(all.from[..6], [0, 0, 0, 5, 5, 5]);
        assert!((all.length[2] - 20.0).abs() < 0.1);
        // A wall between the two starts: its points are not reached.
        let walled = ways(&graph, [0], |point| point % 6 != 3);
        assert!(walled.length[2] < 21.0 && walled.length[3].is_infinite() && walled.length[5].is_infinite());
        assert_eq!(walled.from[5], 5);
    }
}
