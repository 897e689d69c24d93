//! Groups of neighbours that share one value: cells of several points (the paper's figure 9b).

use rand::Rng;

use super::clusters::shuffle;
use crate::points::graph::PointGraph;

/// The group of each point: `size` neighbours each, the nearest to the first one; fewer if no more are free.
pub fn groups(graph: &impl PointGraph, size: usize, rng: &mut impl Rng) -> Vec<u32> {
    let mut group: Vec<Option<u32>> = vec![None; graph.count()];
    let mut starts: Vec<usize> = (0..graph.count()).collect();
    shuffle(&mut starts, rng);
    let mut count = 0;
    for start in starts {
        if group[start].is_some() {
            continue;
        }
        let mut taken = vec![start];
        group[start] = Some(count);
        while taken.len() < size {
            let beside = taken.iter().flat_map(|point| graph.neighbours(*point));
            let free = beside.filter(|point| group[*point].is_none());
            let away = |point: usize| {
                let displacement = graph.way(start, point);
                displacement[0] * displacement[0] + displacement[1] * displacement[1]
            };
            let Some(next) = free.min_by(|a, b| away(*a).total_cmp(&away(*b)).then(a.cmp(b))) else { break };
            group[next] = Some(count);
            taken.push(next);
        }
        count += 1;
    }
    group.into_iter().map(|group| group.unwrap_or(0)).collect()
}
