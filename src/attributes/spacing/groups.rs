//! The edges of each of several groups of points that together are one pattern: the marks of each region of a layer.

use super::{WeightedEdge, edges, median, nearest};

/// By group, the edges that its spacing is the mean of; `group` returns the group of the point with an index.
///
/// They are the edges of the whole pattern that join two points of one group: where the border of a group cuts the pattern,
/// an edge along the border has angles opposite to it on both sides. As far as their weights add up to less than 1
/// (points of other groups lie between those of the group), the edges of the group alone make up the rest.
#[must_use]
pub fn grouped_neighbours(
    points: &[[f64; 2]],
    groups: usize,
    group: impl Fn(usize) -> usize,
) -> Vec<Vec<WeightedEdge>> {
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); groups];
    for index in 0..points.len() {
        members[group(index)].push(index);
    }
    let whole = edges(points, None);
    let of_group = |(index, members): (usize, &Vec<usize>)| {
        let places: Vec<[f64; 2]> = members.iter().map(|member| points[*member]).collect();
        let own = edges(&places, None);
        let Some(distance) = median(nearest(&own, places.len())) else { return Vec::new() };
        let joins = |ends: [usize; 2]| ends.iter().all(|end| group(*end) == index);
        let shared = whole.iter().filter(|edge| joins(edge.ends)).filter_map(|edge| edge.weighted(distance));
        let mut found: Vec<WeightedEdge> = shared.collect();
        let missing = 1.0 - total(&found);
        if missing > 0.0 {
            let own: Vec<WeightedEdge> = own.iter().filter_map(|edge| edge.weighted(distance)).collect();
            let share = missing / total(&own);
            found.extend(own.iter().map(|edge| WeightedEdge {
                ends: edge.ends.map(|end| members[end]),
                weight: share * edge.weight,
                ..*edge
            }));
        }
        found
    };
    members.iter().enumerate().map(of_group).collect()
}

fn total(edges: &[WeightedEdge]) -> f64 {
    edges.iter().map(|edge| edge.weight).sum()
}
