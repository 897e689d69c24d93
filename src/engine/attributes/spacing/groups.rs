//! The edges of each of several groups of points that together are one pattern: the marks of each region of a layer.

use super::{Edge, WeightedEdge, edges, median, nearest};

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
    let group: Vec<usize> = (0..points.len()).map(group).collect();
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); groups];
    group.iter().enumerate().for_each(|(index, group)| members[*group].push(index));
    let mut joining: Vec<Vec<Edge>> = vec![Vec::new(); groups];
    for edge in edges(points, None) {
        let [first, second] = edge.ends.map(|end| group[end]);
        if first == second {
            joining[first].push(edge);
        }
    }
    let of_group = |(members, joining): (&Vec<usize>, &Vec<Edge>)| {
        let places: Vec<[f64; 2]> = members.iter().map(|member| points[*member]).collect();
        let own = edges(&places, None);
        let Some(distance) = median(nearest(&own, places.len())) else { return Vec::new() };
        let mut found: Vec<WeightedEdge> =
            joining.iter().filter_map(|edge| edge.weighted(distance)).collect();
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
    members.iter().zip(&joining).map(of_group).collect()
}

fn total(edges: &[WeightedEdge]) -> f64 {
    edges.iter().map(|edge| edge.weight).sum()
}
