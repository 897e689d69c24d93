//! Changes of the thresholds of all regions together. Thresholds are interpolated between regions, so that the threshold of one
//! region also changes the sizes in the regions around it.

use crate::attributes::regions::RegionGrid;

/// Richardson iterations: regions with neighbours of the opposite sign step at most three times the wanted change.
const ITERATIONS: usize = 4;

/// Changes (ln) of the thresholds, by region of `layout`, whose means within each region are nearly the `wanted` ones; 0 where
/// nothing is wanted.
#[must_use]
pub fn level_steps(layout: &RegionGrid, wanted: &[Option<f64>]) -> Vec<f64> {
    let mut steps: Vec<f64> = wanted.iter().map(|wanted| wanted.unwrap_or(0.0)).collect();
    for _ in 0..ITERATIONS {
        let means = within_regions(layout, &steps);
        for ((step, wanted), mean) in steps.iter_mut().zip(wanted).zip(means) {
            *step += wanted.map_or(0.0, |wanted| wanted - mean);
        }
    }
    steps
}

/// The means of `values` within each region after interpolation between regions. In a quarter of a region the interpolation is
/// bilinear, and its mean is its value at the centre.
#[must_use]
pub fn within_regions(layout: &RegionGrid, values: &[f64]) -> Vec<f64> {
    let mean = |index: usize| {
        let place = layout.place(index);
        let quarter = |k: usize| {
            let share = [k % 2, k / 2].map(|half| 0.25 + 0.5 * half as f64);
            let along = |axis: usize| {
                (place[axis] as f64 + share[axis]) * layout.size[axis] / layout.grid[axis] as f64
            };
            let corners = layout.corners([along(0), along(1)]);
            corners.iter().map(|(index, weight)| weight * values[*index]).sum::<f64>()
        };
        (0..4).map(quarter).sum::<f64>() / 4.0
    };
    (0..layout.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    const VALUES: [f64; 12] = [0.3, -0.1, 0.2, 0.0, -0.4, 0.1, 0.25, -0.3, 0.05, 0.4, -0.2, 0.15];

    fn layouts() -> [RegionGrid; 3] {
        let layout = |grid: [usize; 2], edges: Edges| RegionGrid { size: [90.0, 70.0], grid, edges };
        [layout([4, 3], Edges::Closed), layout([4, 3], Edges::Wrap), layout([12, 1], Edges::Closed)]
    }

    #[test]
    fn means_within_regions_are_those_of_many_points() {
        const SIDE: usize = 40;
        for layout in layouts() {
            let means = within_regions(&layout, &VALUES);
            for (index, mean) in means.into_iter().enumerate() {
                let place = layout.place(index);
                let point = |k: usize| [k % SIDE, k / SIDE].map(|at| (at as f64 + 0.5) / SIDE as f64);
                let at = |k: usize| {
                    let share = point(k);
                    let along = |axis: usize| {
                        (place[axis] as f64 + share[axis]) * layout.size[axis] / layout.grid[axis] as f64
                    };
                    let corners = layout.corners([along(0), along(1)]);
                    corners.iter().map(|(index, weight)| weight * VALUES[*index]).sum::<f64>()
                };
                let sampled = (0..SIDE * SIDE).map(at).sum::<f64>() / (SIDE * SIDE) as f64;
                assert!((mean - sampled).abs() < 1e-12, "{layout:?} {index}: {mean} {sampled}");
            }
        }
    }

    #[test]
    fn steps_come_nearer_to_what_is_wanted_than_those_of_each_region_alone() {
        for layout in layouts() {
            let wanted: Vec<Option<f64>> = VALUES.into_iter().map(Some).collect();
            let error = |steps: &[f64]| -> f64 {
                let means = within_regions(&layout, steps);
                means.iter().zip(VALUES).map(|(mean, wanted)| (mean - wanted) * (mean - wanted)).sum()
            };
            let (together, alone) = (error(&level_steps(&layout, &wanted)), error(&VALUES));
            assert!(together < 0.2 * alone, "{layout:?}: {together} {alone}");
        }
    }

    #[test]
    fn one_region_steps_as_wanted_and_one_that_wants_nothing_stays() {
        let one = RegionGrid { size: [90.0, 70.0], grid: [1, 1], edges: Edges::Closed };
        assert_eq!(level_steps(&one, &[Some(0.3)]), [0.3]);
        for layout in layouts() {
            let mut wanted: Vec<Option<f64>> = VALUES.into_iter().map(Some).collect();
            wanted[5] = None;
            assert_eq!(level_steps(&layout, &wanted)[5], 0.0);
        }
    }
}
