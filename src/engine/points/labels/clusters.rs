//! Clusters of a known size one by one, breadth or depth first (the paper's figures 21–23).

use std::collections::VecDeque;

use rand::{Rng, RngExt};

use crate::points::graph::PointGraph;

/// The order in which a cluster takes points.
#[derive(Clone, Copy)]
pub enum Order {
    /// Points with the fewest edges to the start first: compact clusters, a giraffe or jaguar (figure 22).
    BreadthFirst,
    /// Neighbours of the last point first, in random order: clumps with thin links between them (figure 23).
    DepthFirst,
}

/// The cluster of each point, `None` for light ones. A cluster has `size` points, or fewer if no more are free; then all their free
/// neighbours are light (figure 21).
pub fn clusters(graph: &impl PointGraph, size: usize, order: Order, rng: &mut impl Rng) -> Vec<Option<u32>> {
    let mut state = vec![State::Free; graph.count()];
    let mut starts: Vec<usize> = (0..graph.count()).collect();
    shuffle(&mut starts, rng);
    let mut cluster = 0;
    for start in starts {
        if state[start] != State::Free {
            continue;
        }
        let taken = grow(graph, &mut state, start, cluster, size.max(1), order, rng);
        for point in taken {
            for other in graph.neighbours(point) {
                if state[other] == State::Free {
                    state[other] = State::Light;
                }
            }
        }
        cluster += 1;
    }
    let owner = |state| if let State::Dark(cluster) = state { Some(cluster) } else { None };
    state.into_iter().map(owner).collect()
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    Free,
    Light,
    Dark(u32),
}

fn grow(
    graph: &impl PointGraph,
    state: &mut [State],
    start: usize,
    cluster: u32,
    size: usize,
    order: Order,
    rng: &mut impl Rng,
) -> Vec<usize> {
    let mut open = VecDeque::from([start]);
    let mut taken = Vec::new();
    while taken.len() < size {
        let next = if matches!(order, Order::BreadthFirst) { open.pop_front() } else { open.pop_back() };
        let Some(point) = next else { break };
        if state[point] != State::Free {
            continue;
        }
        state[point] = State::Dark(cluster);
        taken.push(point);
        let free = graph.neighbours(point).filter(|other| state[*other] == State::Free);
        let mut next: Vec<(f64, usize)> = free.map(|other| (rng.random(), other)).collect();
        // The last is taken first.
        next.sort_by(|a, b| a.0.total_cmp(&b.0));
        open.extend(next.into_iter().map(|(_, to)| to));
    }
    taken
}

/// Shuffles items (Fisher and Yates).
pub(crate) fn shuffle(items: &mut [usize], rng: &mut impl Rng) {
    for last in (1..items.len()).rev() {
        let other = ((rng.random::<f64>() * (last + 1) as f64) as usize).min(last);
        items.swap(last, other);
    }
}
