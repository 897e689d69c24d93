//! Spots whose sizes form two clear groups that stand among each other: two layers keep each size and each spacing.

use super::{Problem, Remedy, SketchNote};
use crate::marks::{Ellipse, Mark};

/// The fewest spots among which groups are sought, and the fewest spots of a group. Fewer are outliers.
const FEWEST: [usize; 2] = [6, 2];
/// The least ratio of area between the smallest spot of one group and the largest of the other.
const GAP: f64 = 2.0;
/// The least distance of the means ÷ the root mean square of the two standard deviations, of ln area. Above 2 two groups are
/// cleanly apart (Ashman, Bird, Zepf, "Detecting bimodality in astronomical datasets", Astron. J. 108 (1994)).
const APART: f64 = 4.0;
/// The least share of the smaller group whose nearest neighbour is of the other group. Groups in two parts of the canvas are a
/// change of size across the canvas, not a mixture.
const MIXED: f64 = 0.25;

pub(super) fn note(marks: &[Option<Mark>]) -> Option<SketchNote> {
    let [small, large] = size_groups(marks)?;
    let ellipse = |index: &usize| marks.get(*index)?.as_ref()?.ellipse();
    let mean = |group: &[usize]| {
        group.iter().filter_map(ellipse).map(|ellipse| ellipse.area()).sum::<f64>() / group.len() as f64
    };
    let sizes = Problem::TwoSizes([(small.len(), mean(&small)), (large.len(), mean(&large))]);
    let told = if large.len() <= small.len() { large } else { small };
    let places = told.iter().filter_map(ellipse).map(|ellipse| ellipse.center).collect();
    Some(SketchNote { remedies: vec![Remedy::TwoLayers], ..SketchNote::new(told, places, sizes) })
}

/// The indices of the small and of the large ellipses among the `marks` of a layer, where there are two clear groups.
#[must_use]
pub fn size_groups(marks: &[Option<Mark>]) -> Option<[Vec<usize>; 2]> {
    let ellipses =
        marks.iter().enumerate().filter_map(|(index, mark)| Some((index, mark.as_ref()?.ellipse()?)));
    let mut ellipses: Vec<(usize, Ellipse)> = ellipses.collect();
    ellipses.sort_by(|(_, a), (_, b)| a.area().total_cmp(&b.area()));
    let sizes: Vec<f64> = ellipses.iter().map(|(_, ellipse)| libm::log(ellipse.area())).collect();
    let [fewest, of_a_group] = FEWEST;
    if sizes.len() < fewest {
        return None;
    }
    let splits = of_a_group..=sizes.len() - of_a_group;
    let gap = |at: &usize| sizes[*at] - sizes[at - 1];
    let at = splits.max_by(|a, b| gap(a).total_cmp(&gap(b)))?;
    let [(low, low_variance), (high, high_variance)] = [&sizes[..at], &sizes[at..]].map(mean_and_variance);
    let apart = (high - low) / (0.5 * (low_variance + high_variance)).sqrt().max(1e-9);
    if gap(&at) < libm::log(GAP) || apart < APART || !is_mixed(&ellipses, at) {
        return None;
    }
    let indices = |group: &[(usize, Ellipse)]| {
        let mut indices: Vec<usize> = group.iter().map(|(index, _)| *index).collect();
        indices.sort_unstable();
        indices
    };
    Some([indices(&ellipses[..at]), indices(&ellipses[at..])])
}

fn mean_and_variance(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (mean, values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n)
}

/// Whether the ellipses before index `at` are mixed with the others on the canvas.
fn is_mixed(ellipses: &[(usize, Ellipse)], at: usize) -> bool {
    let squared = |a: &Ellipse, b: &Ellipse| {
        let [x, y] = [a.center[0] - b.center[0], a.center[1] - b.center[1]];
        x * x + y * y
    };
    let smaller = if 2 * at <= ellipses.len() { 0..at } else { at..ellipses.len() };
    let n = smaller.len();
    let beside_another = smaller.clone().filter(|i| {
        let own = &ellipses[*i].1;
        let others = (0..ellipses.len()).filter(|j| j != i);
        let nearest =
            others.min_by(|a, b| squared(own, &ellipses[*a].1).total_cmp(&squared(own, &ellipses[*b].1)));
        nearest.is_some_and(|nearest| !smaller.contains(&nearest))
    });
    beside_another.count() as f64 >= MIXED * n as f64
}
