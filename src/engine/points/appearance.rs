//! The order in which dark points appear in a film: along the graph, from their starts.

use super::delaunay::Delaunay;
use super::ways::ways;

/// Time at which each point appears, 0..1.
pub struct Appearance(Vec<f64>);

/// Share of the film during which the value of a point rises to its final value. At 0 single points would pop up; edges would not
/// move.
const FADE: f64 = 0.12;

impl Appearance {
    /// Points with a value above 0 appear from the nearest of `starts` on, at constant speed along the paths between such points,
    /// the farthest of all at time 1. In a group of dark points without a start, the first point is the start.
    #[must_use]
    pub fn along(graph: &Delaunay, values: &[f32], starts: &[usize]) -> Self {
        let is_dark = |point: usize| values[point] > 0.0;
        let starts = with_one_in_each_group(graph, is_dark, starts);
        let found = ways(graph, starts, is_dark);
        let farthest = found.length.iter().copied().filter(|length| length.is_finite()).fold(0.0, f64::max);
        let moment = |length: f64| if length.is_finite() && farthest > 0.0 { length / farthest } else { 0.0 };
        Self(found.length.into_iter().map(moment).collect())
    }

    /// The `values` at the time `share`, 0..1, of the film: at 0 the starts begin to appear, at 1 all points are shown.
    #[must_use]
    pub fn at(&self, values: &[f32], share: f64) -> Vec<f32> {
        let shown = |(value, moment): (&f32, &f64)| {
            if *value <= 0.0 {
                return *value;
            }
            value * ((share * (1.0 + FADE) - moment) / FADE).clamp(0.0, 1.0) as f32
        };
        values.iter().zip(&self.0).map(shown).collect()
    }
}

/// The `starts`, and the first point of each group of dark points that has no start.
fn with_one_in_each_group(graph: &Delaunay, is_dark: impl Fn(usize) -> bool, starts: &[usize]) -> Vec<usize> {
    let given = starts.len();
    let mut starts = starts.to_vec();
    let mut seen = vec![false; graph.points.len()];
    let in_order = starts.clone().into_iter().chain(0..graph.points.len());
    for (order, point) in in_order.enumerate().filter(|(_, point)| is_dark(*point)) {
        if seen[point] {
            continue;
        }
        if order >= given {
            starts.push(point);
        }
        let mut group = vec![point];
        seen[point] = true;
        while let Some(at) = group.pop() {
            for other in graph.neighbours(at).filter(|other| is_dark(*other)) {
                if !seen[other] {
                    seen[other] = true;
                    group.push(other);
                }
            }
        }
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::extent::Extent;

    #[test]
    fn points_appear_from_their_starts_outward_until_all_are_shown() {
        let extent = Extent { size: [100.0, 10.0], wrap: [false; 2] };
        let row: Vec<[f64; 2]> = (0..10).map(|k| [5.0 + 10.0 * f64::from(k), 5.0]).collect();
        let graph = Delaunay::new(&row, extent);
        // Point 7 is light; 8 and 9 have no start of their own.
        let values = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -0.2, 0.5, 1.0];
        let appearance = Appearance::along(&graph, &values, &[0]);
        assert_eq!(appearance.at(&values, 1.0), values);
        let count = |share: f64| appearance.at(&values, share).iter().filter(|value| **value > 0.0).count();
        let counts = [0.0, 0.2, 0.5, 0.8, 1.0].map(count);
        assert!(counts.is_sorted() && counts[0] == 0 && counts[2] < 8 && counts[4] == 9, "{counts:?}");
        let half = appearance.at(&values, 0.5);
        assert!(half[8] > 0.0 && half[6] == 0.0 && half[7] == -0.2, "{half:?}");
    }
}
