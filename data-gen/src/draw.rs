//! The seed and the parameters of run i of a set, which do not depend on other runs.

use dapple_engine::learn::Parameters;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::plan::{Range, Scale, Set};
use crate::swept::Swept;

impl Range {
    /// Whether the range holds more than one value.
    pub fn varies(&self) -> bool {
        self.range[0] < self.range[1]
    }

    /// The value at a share of the range, 0..1.
    pub fn at(&self, share: f64) -> f64 {
        let [low, high] = self.range;
        match self.scale {
            Scale::Linear => low + (high - low) * share,
            Scale::Log => {
                let ends = [libm::log(low), libm::log(high)];
                libm::exp(ends[0] + (ends[1] - ends[0]) * share).clamp(low, high)
            }
            Scale::Reciprocal => (low * high / (high - (high - low) * share)).clamp(low, high),
        }
    }
}

impl Set {
    /// The seed of run `index`.
    pub fn seed_of(&self, index: u64) -> u64 {
        self.seed + index
    }

    /// The parameters of run `index`.
    pub fn parameters_of(&self, index: u64) -> Parameters {
        let s = &self.sweep;
        let size = s.area.as_ref().or(s.width.as_ref());
        let packing = [&s.ratio, &s.level].into_iter().flatten().any(Range::varies);
        let vary =
            [size, s.stretch.as_ref(), s.direction.as_ref()].map(|range| range.is_some_and(Range::varies));
        let vary = [vary[0], packing, vary[1], vary[2]];
        let point = point(index, vary.iter().filter(|varies| **varies).count(), self.seed);
        let mut next = point.into_iter();
        self.parameters_at(vary.map(|varies| if varies { next.next().unwrap_or(0.0) } else { 0.0 }))
    }

    /// The parameters at shares (0..1) of the ranges of size, packing, stretch and direction.
    ///
    /// Packing is one parameter: from the lowest level to the highest with the ratio at its lowest, then from the lowest
    /// ratio to the highest. If both varied independently, many pairs would give the same density, and their mean would
    /// not be a valid answer.
    pub fn parameters_at(&self, [size, packing, stretch, direction]: [f64; 4]) -> Parameters {
        let s = &self.sweep;
        let at = |range: &Option<Range>, share, usual| {
            range.as_ref().map_or(usual, |range: &Range| range.at(share))
        };
        let [stretch, direction] = [at(&s.stretch, stretch, 1.0), at(&s.direction, direction, 0.0)];
        // Scaling laws, accurate to about ten per cent. They choose what to simulate, and are not used in lookups.
        let Swept::System(system) = self.system else { unreachable!("sets of pairs draw marks") };
        let rate = system.definition().laws.rate;
        if let Some(width) = &s.width {
            let (width, ratio) = (width.at(size), s.ratio.as_ref().map(|ratio| ratio.at(packing)));
            let rate = rate(width, ratio.unwrap_or(1.0), 0.5);
            return Parameters { rate, ratio, stretch, direction, level: None };
        }
        let [ratio, level] = self.packed(packing);
        let area = s.area.as_ref().map_or(1.0, |area| area.at(size));
        Parameters {
            rate: rate(area, ratio, level),
            ratio: Some(ratio),
            stretch,
            direction,
            level: Some(level),
        }
    }

    /// Ratio and level at a share of the range from dense to sparse.
    fn packed(&self, at: f64) -> [f64; 2] {
        let (Some(ratio), Some(level)) = (&self.sweep.ratio, &self.sweep.level) else { return [1.0, 0.5] };
        match level.share.filter(|_| ratio.varies()) {
            Some(share) if at < share => [ratio.range[0], level.at(at / share)],
            Some(share) => [ratio.at((at - share) / (1.0 - share).max(f64::MIN_POSITIVE)), level.range[1]],
            None => [ratio.at(at), level.at(at)],
        }
    }
}

/// Point `index` of the R_d sequence with this number of dimensions, shifted by an offset that depends on `seed`:
///
/// xᵢ = frac(o + (i + 1)·α), αⱼ = φ^−(j+1), φ the positive root of φ^(d+1) = φ + 1
///
/// It has smaller holes than random numbers, and can be continued without end. M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences" (2018).
pub fn point(index: u64, dimensions: usize, seed: u64) -> Vec<f64> {
    let mut root = 2.0;
    for _ in 0..40 {
        root = libm::pow(1.0 + root, 1.0 / (dimensions as f64 + 1.0));
    }
    let mut offsets = Pcg64Mcg::seed_from_u64(seed);
    let mut step = 1.0;
    (0..dimensions)
        .map(|_| {
            step /= root;
            let x = offsets.random::<f64>() + (index + 1) as f64 * step;
            x - x.floor()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Plan;

    #[test]
    fn points_fill_the_range_evenly() {
        for dimensions in 1..=4 {
            let points: Vec<Vec<f64>> = (0..1_000).map(|i| point(i, dimensions, 7)).collect();
            for axis in 0..dimensions {
                let mut values: Vec<f64> = points.iter().map(|point| point[axis]).collect();
                values.sort_by(f64::total_cmp);
                let widest = values.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
                // Random numbers leave 0.007.
                let ends = values[0].max(1.0 - values[999]);
                assert!(widest.max(ends) < 0.005, "{dimensions} {axis}: {widest} {ends}");
            }
            // Every sixteenth of the cube (each axis cut in halves) holds its share of the points.
            let cell = |point: &Vec<f64>| point.iter().fold(0, |cell, x| 2 * cell + usize::from(*x > 0.5));
            let mut counts = vec![0usize; 1 << dimensions];
            points.iter().for_each(|point| counts[cell(point)] += 1);
            let even = 1_000 / counts.len();
            assert!(counts.iter().all(|count| count.abs_diff(even) <= even / 6), "{counts:?}");
        }
    }

    #[test]
    fn runs_stay_within_the_ranges_of_the_plan_and_reach_their_ends() {
        let sets = Plan::built_in().unwrap().sets.into_iter();
        for set in sets.filter(|set| matches!(set.system, Swept::System(_))) {
            let runs: Vec<Parameters> = (0..set.runs).map(|index| set.parameters_of(index)).collect();
            let check = |range: &Range, value: &dyn Fn(&Parameters) -> f64| {
                let (low, high) =
                    runs.iter().map(value).fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
                let [from, to] = range.range;
                // With few runs, larger parts of the ranges remain unused at their ends, most where 1/x is evenly
                // spread.
                let reach = (12.0 / set.runs as f64).max(0.02) * (to - from);
                assert!(
                    from <= low && low <= from + reach && to - reach <= high && high <= to,
                    "{}",
                    set.name
                );
            };
            check(set.sweep.stretch.as_ref().unwrap(), &|p| p.stretch);
            check(set.sweep.direction.as_ref().unwrap(), &|p| p.direction);
            if let (Some(ratio), Some(level)) = (&set.sweep.ratio, &set.sweep.level) {
                check(ratio, &|p| p.ratio.unwrap());
                check(level, &|p| p.level.unwrap());
                let apart =
                    |p: &Parameters| p.ratio.unwrap() > ratio.range[0] && p.level.unwrap() < level.range[1];
                assert!(!runs.iter().any(apart), "ratio and level do not vary together");
                let dense = runs.iter().filter(|p| p.level.unwrap() < level.range[1]).count() as f64;
                let share = dense / runs.len() as f64;
                assert!((share - level.share.unwrap_or(0.0)).abs() < 0.01, "{share}");
            }
        }
    }
}
