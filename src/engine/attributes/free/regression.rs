//! Values anywhere on the canvas from values at scattered places: local linear kernel regression.
//!
//! Several bandwidths, from a few neighbours to all of them, are combined with weights that follow from their errors at
//! places left out (exponentially weighted aggregation: Rigollet and Tsybakov, "Sparse estimation by exponential
//! weighting", Statistical Science 2012). Unlike a choice of one bandwidth this is continuous in the places and values.
//! Odd values are given less weight, as in robust locally weighted regression (Cleveland, "Robust locally weighted
//! regression and smoothing scatterplots", Journal of the American Statistical Association 1979).

use rayon::prelude::*;

use super::kernel::Kernels;
use super::plane::Plane;
use super::plane_sums::{PlaneSums, Term};
use crate::grid::{Bounds, Edges, PointBuckets};

/// The kernels of the local estimates reach so many marks.
const NEIGHBOURS: [usize; 4] = [3, 5, 8, 16];

/// The kernels about a point.
pub(super) type LocalKernels = Kernels<{ NEIGHBOURS.len() }>;

/// Estimates that are combined: a plane fitted in each kernel, a plane fitted to all values, and their mean.
const COUNT: usize = NEIGHBOURS.len() + 2;

/// Weights of the estimates where their errors are alike: a plane is likelier than a hill.
const PRIOR: [f64; COUNT] = [1.0, 1.0, 1.0, 1.0, 3.0, 1.0];

/// Weight of all values in a local estimate, for where none that counts is in the kernel.
const FAR: f64 = 1e-9;

/// Times that robust weights are found from residuals.
const ROUNDS: usize = 3;

/// Fewer values than this have no odd one among them.
const FEWEST_WITH_ODD: usize = 5;

/// Residuals of this many times their median absolute value have half the weight.
const ODD: f64 = 6.0;

/// At most this many values decide between the estimators.
const MOST_DECISIVE: f64 = 24.0;

/// Observations that are not worth handing to another thread.
const FEW: usize = 32;

/// How values are regressed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Manner {
    /// Differences below this do not matter.
    pub floor: f64,
    /// For how many standard deviations of the places a slope is followed beyond them.
    pub followed: f64,
}

/// A value at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Observation<const N: usize> {
    /// The place of the value, px.
    pub place: [f64; 2],
    /// The value.
    pub value: [f64; N],
    /// Its weight, at least 0.
    pub weight: f64,
    /// The marks that it was found from; equal of a single one.
    pub marks: [usize; 2],
}

/// Estimates of a value anywhere.
#[derive(Clone, Debug)]
pub(super) struct Regression<const N: usize> {
    bounds: Bounds,
    /// Centres of the marks, whose distances set the bandwidths.
    centers: PointBuckets,
    observations: Vec<Observation<N>>,
    /// Where the observations are.
    places: PointBuckets,
    /// By mark, the observations that were found from it, ascending.
    by_mark: Vec<Vec<usize>>,
    /// Robust weights of the observations, 0..1.
    robust: Vec<f64>,
    /// Weights of the estimates, sum 1.
    shares: [f64; COUNT],
    /// For how many standard deviations of the places a slope is followed beyond them, see [`Manner::followed`].
    followed: f64,
    /// All values, about the corner of the canvas.
    whole: PlaneSums<N>,
}

impl<const N: usize> Regression<N> {
    /// The regression of `observations`.
    pub fn new(
        bounds: Bounds,
        centers: &[[f64; 2]],
        observations: Vec<Observation<N>>,
        Manner { floor, followed }: Manner,
    ) -> Self {
        let robust = vec![1.0; observations.len()];
        let shares = [1.0 / COUNT as f64; COUNT];
        let places = PointBuckets::new(bounds, observations.iter().map(|one| one.place).collect());
        let by_mark = by_mark(centers.len(), &observations);
        let (centers, whole) = (PointBuckets::new(bounds, centers.to_vec()), PlaneSums::default());
        let mut regression =
            Self { bounds, centers, observations, places, by_mark, robust, shares, followed, whole };
        for round in 0..=ROUNDS {
            regression.whole = regression.summed();
            let errors = regression.errors_left_out();
            regression.shares = regression.shares_from(&errors, floor);
            if round < ROUNDS && regression.observations.len() >= FEWEST_WITH_ODD {
                regression.robust = regression.robust_from(&errors, floor);
            }
        }
        regression
    }

    /// The estimate at a point, px.
    pub fn at(&self, point: [f64; 2]) -> [f64; N] {
        let kernels = self.kernels(point);
        self.among(point, &kernels, &self.covered(&kernels))
    }

    /// The kernels about a point, px: the same for all regressions of what was found from the same marks.
    pub fn kernels(&self, point: [f64; 2]) -> LocalKernels {
        self.kernels_without(point, &[])
    }

    /// The observations that may lie in one of the kernels, ascending.
    pub fn covered(&self, kernels: &LocalKernels) -> Vec<u32> {
        kernels.covered(&self.places)
    }

    /// [`Self::at`] a point, px, from the observations `covered` by its kernels.
    pub fn among(&self, point: [f64; 2], kernels: &LocalKernels, covered: &[u32]) -> [f64; N] {
        combined(&self.estimates(point, kernels, covered, (self.whole.all(), &[])), &self.shares)
    }

    /// The observations with their robust weights, 0..1.
    pub fn observations(&self) -> impl Iterator<Item = (&Observation<N>, f64)> {
        self.observations.iter().zip(self.robust.iter().copied())
    }

    /// The error of every estimator at each observation, had its marks not been drawn.
    fn errors_left_out(&self) -> Vec<[[f64; N]; COUNT]> {
        let error = |one: &Observation<N>| {
            let without = self.whole.without(&self.found_from(one.marks));
            // No other mark: the value does not vary.
            let whole = if without.is_empty() { self.whole.all() } else { &without };
            let kernels = self.kernels_without(one.place, &one.marks);
            let covered = self.covered(&kernels);
            let estimates = self.estimates(one.place, &kernels, &covered, (whole, &one.marks));
            estimates.map(|estimate| minus(estimate, one.value))
        };
        self.observations.par_iter().with_min_len(FEW).map(error).collect()
    }

    /// Weights of the estimators from their errors.
    fn shares_from(&self, errors: &[[[f64; N]; COUNT]], floor: f64) -> [f64; COUNT] {
        let mut squares = [0.0; COUNT];
        let mut total = 0.0;
        for ((one, robust), errors) in self.observations().zip(errors) {
            let weight = one.weight * robust;
            total += weight;
            for (sum, error) in squares.iter_mut().zip(errors) {
                *sum += weight * squared(error);
            }
        }
        let power = 0.5 * total.min(MOST_DECISIVE);
        let mut logs = [0.0; COUNT];
        for ((log, sum), prior) in logs.iter_mut().zip(squares).zip(&PRIOR) {
            let mean = if total > 0.0 { sum / total } else { 0.0 };
            *log = libm::log(*prior) - power * libm::log(mean + floor * floor);
        }
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let weights = logs.map(|log| libm::exp(log - most));
        let sum: f64 = weights.iter().sum();
        weights.map(|weight| weight / sum)
    }

    /// Robust weights from the errors of the combined estimate.
    fn robust_from(&self, errors: &[[[f64; N]; COUNT]], floor: f64) -> Vec<f64> {
        let sizes: Vec<f64> =
            errors.iter().map(|errors| squared(&combined(errors, &self.shares)).sqrt()).collect();
        let weights = self.observations.iter().map(|one| one.weight);
        let middle = weighted_median(sizes.iter().copied().zip(weights)).max(floor);
        sizes.iter().map(|size| 1.0 / (1.0 + (size / (ODD * middle)).powi(4))).collect()
    }

    /// All values, about the corner of the canvas.
    fn summed(&self) -> PlaneSums<N> {
        let term = |(one, robust): (&Observation<N>, f64)| Term {
            place: one.place,
            weight: one.weight * robust,
            value: one.value,
        };
        PlaneSums::new(self.observations().map(term).collect())
    }

    /// The observations that were found from either of two marks, ascending.
    fn found_from(&self, [first, second]: [usize; 2]) -> Vec<usize> {
        let mut found = self.by_mark[first].clone();
        if second != first {
            found.extend(&self.by_mark[second]);
            found.sort_unstable();
            found.dedup();
        }
        found
    }

    /// The kernels about a point, px, for which the marks `left_out` do not count.
    fn kernels_without(&self, point: [f64; 2], left_out: &[usize]) -> LocalKernels {
        Kernels::new(&self.centers, point, |mark| !left_out.contains(&mark), &NEIGHBOURS)
    }

    /// All estimates at a point, px, from the observations `covered` by its kernels and the values of `whole`, those without the
    /// marks `left_out`.
    fn estimates(
        &self,
        point: [f64; 2],
        kernels: &LocalKernels,
        covered: &[u32],
        (whole, left_out): (&Plane<N>, &[usize]),
    ) -> [[f64; N]; COUNT] {
        let mean = whole.mean();
        let mut planes = [Plane::<N>::default(); COUNT];
        planes.iter_mut().for_each(|plane| plane.add([0.0; 2], FAR * whole.weight(), &mean));
        for index in covered {
            let (one, robust) = (&self.observations[*index as usize], self.robust[*index as usize]);
            if one.marks.iter().all(|mark| !left_out.contains(mark)) {
                kernels.each(one.place, |index, way, weight| {
                    planes[index].add(way, weight * one.weight * robust, &one.value);
                });
            }
        }
        let mut estimates = planes.map(|plane| plane.at_origin(self.followed));
        if self.bounds.edges == Edges::Closed {
            estimates[COUNT - 2] = whole.about(point).at_origin(self.followed);
        }
        estimates
    }
}

/// By mark, of so many, the observations that were found from it.
fn by_mark<const N: usize>(marks: usize, observations: &[Observation<N>]) -> Vec<Vec<usize>> {
    let mut found = vec![Vec::new(); marks];
    for (index, Observation { marks: [first, second], .. }) in observations.iter().enumerate() {
        found[*first].push(index);
        if second != first {
            found[*second].push(index);
        }
    }
    found
}

fn combined<const N: usize>(estimates: &[[f64; N]; COUNT], shares: &[f64; COUNT]) -> [f64; N] {
    let mut sum = [0.0; N];
    for (estimate, share) in estimates.iter().zip(shares) {
        for (sum, value) in sum.iter_mut().zip(estimate) {
            *sum += share * value;
        }
    }
    sum
}

fn minus<const N: usize>(mut a: [f64; N], b: [f64; N]) -> [f64; N] {
    for (a, b) in a.iter_mut().zip(b) {
        *a -= b;
    }
    a
}

fn squared<const N: usize>(values: &[f64; N]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

/// Median of values under weights, linear between them so that it is continuous; 0 of none.
pub(super) fn weighted_median(values: impl Iterator<Item = (f64, f64)>) -> f64 {
    let mut sorted: Vec<(f64, f64)> = values.filter(|(_, weight)| *weight > 0.0).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let half = 0.5 * sorted.iter().map(|(_, weight)| weight).sum::<f64>();
    let mut before: Option<(f64, f64)> = None;
    let mut sum = 0.0;
    for (value, weight) in sorted {
        let at = sum + 0.5 * weight;
        if at >= half {
            return before.map_or(value, |(value_before, at_before)| {
                value_before + (value - value_before) * (half - at_before) / (at - at_before)
            });
        }
        sum += weight;
        before = Some((value, at));
    }
    before.map_or(0.0, |(value, _)| value)
}
