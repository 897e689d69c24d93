//! Clusters that claim points in turn: each claims the best of the free points beside it (the paper's figures 24 and 25).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::points::graph::PointGraph;

/// The rules of [`round_robin`].
pub trait Claim {
    /// The cost, positive, at which a cluster claims a point at `displacement`, px, from its centre, in the frame there. The cluster claims the
    /// cheapest point. `None` if it must not claim the point.
    fn cost(&self, cluster: usize, point: usize, displacement: [f64; 2]) -> Option<f64>;

    /// Whether a cluster that has claimed the `area`, px², should also claim a point of the area `next`, px².
    fn wants(&self, cluster: usize, area: f64, next: f64) -> bool;

    /// The clearance below which an edge is ignored, if clusters are to stay apart. They grow only along the other edges, and none
    /// claims a point that is a neighbour of another cluster's point, or opposite to one across an ignored edge. With a clearance
    /// above 0, points are connected in the interpolated field exactly where they are connected in the graph. `None`: clusters may
    /// touch.
    fn clearance(&self) -> Option<f64>;
}

/// A growing cluster.
#[derive(Default)]
struct Front {
    area: f64,
    /// Free points beside it by cost, each with its displacement from the centre.
    open: BinaryHeap<Reverse<(u64, u32)>>,
    ways: Vec<(u32, [f64; 2])>,
    done: bool,
}

/// The cluster of each claimed point, and the area claimed by each cluster, px². `centers` are indices of points. `taken` points
/// are not claimed; if clusters are to stay apart, they keep a distance from these points too.
pub fn round_robin(
    graph: &impl PointGraph,
    centers: &[usize],
    taken: &[bool],
    claim: &impl Claim,
) -> (Vec<Option<u32>>, Vec<f64>) {
    let mut owner: Vec<Option<u32>> = vec![None; graph.count()];
    let is_taken = |point: usize| taken.get(point).copied().unwrap_or(false);
    let mut fronts: Vec<Front> = centers.iter().map(|_| Front::default()).collect();
    for (cluster, center) in centers.iter().enumerate() {
        fronts[cluster].offer(claim, cluster, *center, [0.0; 2]);
    }
    let mut left = fronts.len();
    while left > 0 {
        for (cluster, front) in fronts.iter_mut().enumerate().filter(|(_, front)| !front.done) {
            let free = |point: usize| {
                let beside =
                    |other: usize| is_taken(other) || owner[other].is_some_and(|o| o != cluster as u32);
                let crowded = |least: f64| {
                    let mut across = graph.opposite(point).filter(|(_, clearance)| *clearance < least);
                    graph.neighbours(point).any(beside) || across.any(|(other, _)| beside(other))
                };
                owner[point].is_none() && !is_taken(point) && !claim.clearance().is_some_and(crowded)
            };
            let next = front.next(free);
            let next = next.filter(|(point, _)| claim.wants(cluster, front.area, graph.area(*point)));
            let Some((point, displacement)) = next else {
                front.done = true;
                left -= 1;
                continue;
            };
            owner[point] = Some(cluster as u32);
            front.area += graph.area(point);
            let least = claim.clearance().unwrap_or(f64::NEG_INFINITY);
            for axis in graph.axes(point).iter().filter(|axis| axis.clearance >= least) {
                if let Some(to) = axis.to.filter(|to| owner[*to as usize].is_none()) {
                    let there = graph.onward(centers[cluster], point, displacement, axis);
                    front.offer(claim, cluster, to as usize, there);
                }
            }
        }
    }
    (owner, fronts.into_iter().map(|front| front.area).collect())
}

impl Front {
    fn offer(&mut self, claim: &impl Claim, cluster: usize, point: usize, displacement: [f64; 2]) {
        if let Some(cost) = claim.cost(cluster, point, displacement) {
            // The bits of positive floating-point numbers are ordered like the numbers.
            self.open.push(Reverse((cost.max(0.0).to_bits(), self.ways.len() as u32)));
            self.ways.push((point as u32, displacement));
        }
    }

    fn next(&mut self, free: impl Fn(usize) -> bool) -> Option<(usize, [f64; 2])> {
        while let Some(Reverse((_, index))) = self.open.pop() {
            let (point, displacement) = self.ways[index as usize];
            if free(point as usize) {
                return Some((point as usize, displacement));
            }
        }
        None
    }
}

/// Whether each point is inside its cluster: it and all its neighbours have the same owner. The other points, and `rings` rings of
/// their neighbours, are border (the paper: one ring for thick borders).
#[must_use]
pub fn bordered(graph: &impl PointGraph, owner: &[Option<u32>], rings: usize) -> Vec<bool> {
    let inside = |point: usize| graph.neighbours(point).all(|other| owner[other] == owner[point]);
    let mut dark: Vec<bool> = (0..owner.len()).map(|point| owner[point].is_some() && inside(point)).collect();
    for _ in 0..rings {
        let before = dark.clone();
        let stays = |point: usize| before[point] && graph.neighbours(point).all(|other| before[other]);
        dark = (0..dark.len()).map(stays).collect();
    }
    dark
}
