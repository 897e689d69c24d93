//! The number of regions that a photograph needs: as few as explain the variation of its marks.
//!
//! For each number of columns and rows the mean attributes of four fifths of the marks, by region, predict those of the last
//! fifth, as the region map of a document does (bilinear between the regions' centres). Of all that predict nearly as well as
//! the best, the fewest are taken.

/// Most columns and most rows.
const MOST: usize = 4;
/// Fewest marks a region.
const MARKS: usize = 4;
/// Parts into which the marks are divided.
const FOLDS: usize = 5;
/// A mean square error within this factor of the least one counts as nearly as good,
const NEARLY: f64 = 1.1;
/// and so does one that is larger by this: 6 % of the area, or 2° of the direction of stripes, which are the errors of a growth.
const EXACT: f64 = 0.004;

/// A mark, or a piece of stripes: its position, as a share of width and height, and numbers whose differences are errors of a
/// prediction. For spots: ln area, and −ln aspect times (cos 2θ, sin 2θ); for stripes: ln width, cos 2θ, sin 2θ.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// 0..1 along x and y.
    pub place: [f64; 2],
    /// Numbers that can be averaged.
    pub value: [f64; 3],
}

/// The fewest columns and rows.
#[must_use]
pub fn fewest(samples: &[Sample]) -> [usize; 2] {
    let mut layouts: Vec<([usize; 2], f64)> = Vec::new();
    for rows in 1..=MOST {
        for columns in 1..=MOST {
            let layout = [columns, rows];
            if layout == [1, 1] || counts(samples, layout).iter().all(|count| *count >= MARKS) {
                layouts.push((layout, error(samples, layout)));
            }
        }
    }
    let best = layouts.iter().map(|(_, error)| *error).fold(f64::INFINITY, f64::min);
    let good = layouts.iter().filter(|(_, error)| *error <= NEARLY * best + EXACT);
    let order = |(layout, error): &&([usize; 2], f64)| (layout[0] * layout[1], *error);
    let fewest = good.min_by(|a, b| order(a).0.cmp(&order(b).0).then(a.1.total_cmp(&b.1)));
    fewest.map_or([1, 1], |(layout, _)| *layout)
}

/// The region of a place, row by row.
#[must_use]
pub fn region_of(place: [f64; 2], [columns, rows]: [usize; 2]) -> usize {
    let index = |place: f64, count: usize| ((place * count as f64).max(0.0) as usize).min(count - 1);
    index(place[1], rows) * columns + index(place[0], columns)
}

fn counts(samples: &[Sample], layout: [usize; 2]) -> Vec<usize> {
    let mut counts = vec![0; layout[0] * layout[1]];
    samples.iter().for_each(|sample| counts[region_of(sample.place, layout)] += 1);
    counts
}

/// Mean square error of the predictions.
fn error(samples: &[Sample], layout: [usize; 2]) -> f64 {
    let mut sum = 0.0;
    for fold in 0..FOLDS {
        let means = means(
            samples.iter().enumerate().filter(|(k, _)| k % FOLDS != fold).map(|(_, sample)| sample),
            layout,
        );
        for sample in samples.iter().skip(fold).step_by(FOLDS) {
            let predicted = predicted(&means, layout, sample.place);
            sum += (0..3)
                .map(|k| (predicted[k] - sample.value[k]) * (predicted[k] - sample.value[k]))
                .sum::<f64>();
        }
    }
    sum / samples.len().max(1) as f64
}

/// The mean of each region; for a region without samples that of all.
fn means<'a>(samples: impl Iterator<Item = &'a Sample>, layout: [usize; 2]) -> Vec<[f64; 3]> {
    let mut sums = vec![([0.0; 3], 0.0); layout[0] * layout[1]];
    let mut all = ([0.0; 3], 0.0_f64);
    for sample in samples {
        for (sum, count) in [&mut sums[region_of(sample.place, layout)], &mut all] {
            (0..3).for_each(|k| sum[k] += sample.value[k]);
            *count += 1.0;
        }
    }
    let mean = |(sum, count): &([f64; 3], f64)| sum.map(|sum| sum / count.max(1.0));
    sums.iter().map(|sum| if sum.1 > 0.0 { mean(sum) } else { mean(&all) }).collect()
}

/// Bilinear interpolation between the centres of the regions; constant beyond the outer ones.
fn predicted(means: &[[f64; 3]], [columns, rows]: [usize; 2], place: [f64; 2]) -> [f64; 3] {
    let between = |place: f64, count: usize| {
        let at = (place * count as f64 - 0.5).clamp(0.0, count as f64 - 1.0);
        let low = (at as usize).min(count - 1);
        (low, (low + 1).min(count - 1), at - low as f64)
    };
    let ((left, right, u), (top, bottom, v)) = (between(place[0], columns), between(place[1], rows));
    let mean = |x: usize, y: usize, k: usize| means[y * columns + x][k];
    [0, 1, 2].map(|k| {
        let above = mean(left, top, k) * (1.0 - u) + mean(right, top, k) * u;
        let below = mean(left, bottom, k) * (1.0 - u) + mean(right, bottom, k) * u;
        above * (1.0 - v) + below * v
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 12 × 12 marks with this ln area at their place, with some noise.
    fn marks(area: impl Fn([f64; 2]) -> f64) -> Vec<Sample> {
        let noise = |k: usize| 0.1 * ((12.9898 * k as f64).sin() * 43758.5453).rem_euclid(1.0) - 0.05;
        let place = |k: usize| [(k % 12) as f64 / 12.0 + 0.04, (k / 12) as f64 / 12.0 + 0.04];
        (0..144).map(|k| Sample { place: place(k), value: [area(place(k)) + noise(k), 0.0, 0.0] }).collect()
    }

    #[test]
    fn marks_that_are_alike_need_one_region() {
        assert_eq!(fewest(&marks(|_| 5.0)), [1, 1]);
    }

    #[test]
    fn marks_that_get_larger_to_the_right_need_columns_alone() {
        let [columns, rows] = fewest(&marks(|[x, _]| 5.0 + x));
        assert!(columns > 1 && rows == 1, "{columns} {rows}");
    }

    #[test]
    fn a_few_marks_are_not_divided() {
        let few: Vec<Sample> = marks(|[x, _]| 5.0 + x).into_iter().step_by(24).collect();
        assert_eq!(fewest(&few), [1, 1]);
    }
}
