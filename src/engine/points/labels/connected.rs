//! Connected labels: some points, and the points on short paths between them (the paper's figures 19 and 20).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rand::{Rng, RngExt};

use crate::points::delaunay::Delaunay;
use crate::points::graph::PointGraph;

/// Whether each point is in the connected group: the points drawn with the probability `start`, all points on the shortest paths
/// along the graph between neighbouring drawn points, and `rings` rings of neighbours round these.
///
/// A start of 3–4 % gives a cracked net, with a third to a half of the points in it; from 40 % on nearly every point is in it.
///
/// `sparse` makes the graph of some of the points.
pub fn connected<G: PointGraph, S: PointGraph>(
    graph: &G,
    sparse: impl FnOnce(&[usize]) -> S,
    start: f64,
    rings: usize,
    rng: &mut impl Rng,
) -> Vec<bool> {
    let ends: Vec<usize> = (0..graph.count()).filter(|_| rng.random::<f64>() < start).collect();
    let joined = net_along(graph, &ends, &sparse(&ends), f64::NEG_INFINITY);
    ringed(graph, joined, rings)
}

/// The points that are `joined`, with so many rings of their neighbours.
#[must_use]
pub fn ringed(graph: &impl PointGraph, mut joined: Vec<bool>, rings: usize) -> Vec<bool> {
    for _ in 0..rings {
        let before = joined.clone();
        let ringed = |point: usize| before[point] || graph.neighbours(point).any(|other| before[other]);
        joined = (0..joined.len()).map(ringed).collect();
    }
    joined
}

/// Whether each point is one of the `ends`, or on a shortest path along the graph between two ends that are neighbours by an edge
/// of at least this `clearance`. The higher the clearance, the fewer the paths, and the larger the holes between them. If it is
/// finite, paths use only edges of a clearance of at least 0.2, so that they are connected in the interpolated field too.
#[must_use]
pub fn net(graph: &Delaunay, ends: &[usize], clearance: f64) -> Vec<bool> {
    net_along(graph, ends, &sparse(graph, ends), clearance)
}

/// The graph of some points of another.
#[must_use]
pub fn sparse(graph: &Delaunay, points: &[usize]) -> Delaunay {
    let places: Vec<[f64; 2]> = points.iter().map(|point| graph.points[*point]).collect();
    Delaunay::new(&places, graph.extent)
}

/// The [`net`] between the `ends` that are neighbours in their own graph, `sparse`.
#[must_use]
pub fn net_along(
    graph: &impl PointGraph,
    ends: &[usize],
    sparse: &impl PointGraph,
    clearance: f64,
) -> Vec<bool> {
    let mut joined = vec![false; graph.count()];
    ends.iter().for_each(|point| joined[*point] = true);
    let least = if clearance > f64::NEG_INFINITY { WIDE } else { clearance };
    let mut search = Search::new(graph.count(), least);
    for (index, from) in ends.iter().enumerate() {
        for axis in sparse.axes(index).iter().filter(|axis| axis.clearance >= clearance) {
            let Some(to) = axis.to.map(|to| to as usize).filter(|to| *to > index) else { continue };
            let limit = DETOUR * libm::hypot(axis.displacement[0], axis.displacement[1]);
            search.path(graph, *from, ends[to], limit, |point| joined[point] = true);
        }
    }
    joined
}

/// Largest length of a path along the graph ÷ straight distance: 1.998 is proven for Delaunay graphs (G. Xia, SIAM Journal on
/// Computing 42, 2013). On a tile, the path the other way round may be shorter still.
const DETOUR: f64 = 2.0;
/// Least clearance of the edges of paths. Edges of less clearance pass between two points that are nearer to them than their ends:
/// if these points are light, the line breaks.
const WIDE: f64 = 0.2;

/// Shortest paths by Dijkstra's algorithm. After a search, only the touched entries are reset, so the cost of a search depends only
/// on them.
struct Search {
    /// The least clearance of the edges of paths.
    least: f64,
    length: Vec<f64>,
    before: Vec<u32>,
    touched: Vec<usize>,
}

impl Search {
    fn new(points: usize, least: f64) -> Self {
        Self {
            least,
            length: vec![f64::INFINITY; points],
            before: vec![u32::MAX; points],
            touched: Vec::new(),
        }
    }

    fn path(
        &mut self,
        graph: &impl PointGraph,
        from: usize,
        to: usize,
        limit: f64,
        mut each: impl FnMut(usize),
    ) {
        let mut open = BinaryHeap::from([(Reverse(0u64), from)]);
        self.reach(from, 0.0, from);
        let least = self.least;
        while let Some((Reverse(bits), point)) = open.pop() {
            let length = f64::from_bits(bits);
            if point == to {
                break;
            }
            if length > self.length[point] {
                continue;
            }
            for axis in graph.axes(point).iter().filter(|axis| axis.clearance >= least) {
                let Some(next) = axis.to.map(|next| next as usize) else { continue };
                let total = length + libm::hypot(axis.displacement[0], axis.displacement[1]);
                if total < self.length[next] && total <= limit {
                    self.reach(next, total, point);
                    // The bits of positive floating-point numbers are ordered like the numbers.
                    open.push((Reverse(total.to_bits()), next));
                }
            }
        }
        let mut at = to;
        if self.length[to].is_finite() {
            while at != from {
                each(at);
                at = self.before[at] as usize;
            }
        }
        for point in self.touched.drain(..) {
            self.length[point] = f64::INFINITY;
        }
    }

    fn reach(&mut self, point: usize, length: f64, before: usize) {
        if self.length[point].is_infinite() {
            self.touched.push(point);
        }
        self.length[point] = length;
        self.before[point] = before as u32;
    }
}
