//! Values anywhere on the canvas from values at scattered places: local linear kernel regression.
//!
//! Several bandwidths, from a few neighbours to all of them, are combined with weights that follow from their errors at
//! places left out (exponentially weighted aggregation: Rigollet and Tsybakov, "Sparse estimation by exponential
//! weighting", Statistical Science 2012). Unlike a choice of one bandwidth this is continuous in the places and values.
//! Odd values are given less weight, as in robust locally weighted regression (Cleveland, "Robust locally weighted
//! regression and smoothing scatterplots", Journal of the American Statistical Association 1979).

use crate::grid::{Bounds, Edges};

/// A way to estimate: how many neighbours the kernel reaches, and the ridge on the slope.
struct Estimator {
    /// The weights of the kernel add up to about this many values.
    neighbours: f64,
    /// Share of the variance of the places that is added to it; infinite: no slope.
    ridge: f64,
    /// Its weight where errors do not tell.
    prior: f64,
}

const fn estimator(neighbours: f64, ridge: f64, prior: f64) -> Estimator {
    Estimator { neighbours, ridge, prior }
}

/// The estimators that are combined.
const ESTIMATORS: [Estimator; 6] = [
    estimator(3.0, 0.02, 1.0),
    estimator(5.0, 0.02, 1.0),
    estimator(8.0, 0.02, 1.0),
    estimator(16.0, 0.02, 1.0),
    estimator(f64::INFINITY, 0.02, 1.0),
    estimator(f64::INFINITY, f64::INFINITY, 1.0),
];

const COUNT: usize = ESTIMATORS.len();

/// Radius of the kernel (1 − d²/R²)⁴ ÷ distance to the k-th neighbour: its weights then add up to k at an even density.
const REACH: f64 = 2.236;

/// Radius of the kernel that reaches all marks alike, in half perimeters of a closed canvas.
const EVERYWHERE: f64 = 10.0;

/// Weight of values beyond the kernel: without values that count within it, the mean of all is taken.
const FAR: f64 = 1e-9;

/// Times that robust weights are found from residuals.
const ROUNDS: usize = 3;

/// Fewer values than this have no odd one among them.
const FEWEST_WITH_ODD: usize = 5;

/// Residuals of this many times their median absolute value have half the weight.
const ODD: f64 = 6.0;

/// At most this many values decide between the estimators.
const MOST_DECISIVE: f64 = 24.0;

/// A value at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Observation<const N: usize> {
    /// px.
    pub place: [f64; 2],
    /// What is regressed.
    pub value: [f64; N],
    /// 0 and more.
    pub weight: f64,
    /// The marks that it was found from; equal of a single one.
    pub marks: [usize; 2],
}

/// Estimates of a value anywhere.
#[derive(Clone, Debug)]
pub(super) struct Regression<const N: usize> {
    bounds: Bounds,
    /// Centres of the marks, whose distances set the bandwidths.
    centers: Vec<[f64; 2]>,
    observations: Vec<Observation<N>>,
    /// Robust weights of the observations, 0..1.
    robust: Vec<f64>,
    /// Weights of the estimators, sum 1.
    shares: [f64; COUNT],
}

impl<const N: usize> Regression<N> {
    /// The regression of `observations`; differences below `floor` do not matter.
    pub fn new(bounds: Bounds, centers: &[[f64; 2]], observations: Vec<Observation<N>>, floor: f64) -> Self {
        let robust = vec![1.0; observations.len()];
        let shares = [1.0 / COUNT as f64; COUNT];
        let mut regression = Self { bounds, centers: centers.to_vec(), observations, robust, shares };
        for round in 0..=ROUNDS {
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
        let all = self.estimates(point, None);
        combined(&all, &self.shares)
    }

    /// The observations with their robust weights, 0..1.
    pub fn observations(&self) -> impl Iterator<Item = (&Observation<N>, f64)> {
        self.observations.iter().zip(self.robust.iter().copied())
    }

    /// The error of every estimator at each observation, had its marks not been drawn.
    fn errors_left_out(&self) -> Vec<[[f64; N]; COUNT]> {
        let error = |one: &Observation<N>| {
            self.estimates(one.place, Some(one.marks)).map(|estimate| minus(estimate, one.value))
        };
        self.observations.iter().map(error).collect()
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
        for ((log, sum), estimator) in logs.iter_mut().zip(squares).zip(&ESTIMATORS) {
            let mean = if total > 0.0 { sum / total } else { 0.0 };
            *log = libm::log(estimator.prior) - power * libm::log(mean + floor * floor);
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

    /// What every estimator says at a point, px, without the marks `left_out`.
    fn estimates(&self, point: [f64; 2], left_out: Option<[usize; 2]>) -> [[f64; N]; COUNT] {
        let radii = self.radii(point, left_out);
        let stays = |one: &Observation<N>| {
            left_out.is_none_or(|out| !one.marks.iter().any(|mark| out.contains(mark)))
        };
        let mut sums = [Sums::<N>::default(); COUNT];
        for (one, robust) in self.observations().filter(|(one, _)| stays(one)) {
            let weight = one.weight * robust;
            if weight <= 0.0 {
                continue;
            }
            let way = self.bounds.shortest([one.place[0] - point[0], one.place[1] - point[1]]);
            for (sums, radius) in sums.iter_mut().zip(radii) {
                sums.add_images(&self.bounds, way, radius, weight, &one.value);
            }
        }
        if sums[COUNT - 1].weight <= 0.0 {
            // No other mark: the value does not vary.
            let mut all = Sums::default();
            for (one, robust) in self.observations() {
                all.add([0.0; 2], one.weight * robust, &one.value);
            }
            // Directions of round marks have no weight.
            return [if all.weight > 0.0 { all.mean() } else { [0.0; N] }; COUNT];
        }
        let mut estimates = [[0.0; N]; COUNT];
        for ((estimate, sums), estimator) in estimates.iter_mut().zip(&sums).zip(&ESTIMATORS) {
            *estimate = sums.solved(estimator.ridge);
        }
        estimates
    }

    /// Kernel radius of every estimator at a point, px.
    fn radii(&self, point: [f64; 2], left_out: Option<[usize; 2]>) -> [f64; COUNT] {
        let stays = |mark: usize| left_out.is_none_or(|out| !out.contains(&mark));
        let mut squares: Vec<f64> = (self.centers.iter().enumerate())
            .filter(|(mark, _)| stays(*mark))
            .map(|(_, center)| {
                let [x, y] = self.bounds.shortest([center[0] - point[0], center[1] - point[1]]);
                x * x + y * y
            })
            .collect();
        squares.sort_by(f64::total_cmp);
        let widest = match self.bounds.edges {
            Edges::Closed => f64::INFINITY,
            Edges::Wrap => self.bounds.size[0].max(self.bounds.size[1]),
        };
        let reach = |estimator: &Estimator| {
            let k = estimator.neighbours;
            let n = squares.len();
            if k.is_infinite() && widest.is_finite() {
                return widest;
            }
            if k.is_infinite() || n == 0 {
                return EVERYWHERE * (self.bounds.size[0] + self.bounds.size[1]);
            }
            let nearest = squares[(k as usize).min(n) - 1];
            // Fewer marks than that: as far as so many would reach at the same density.
            let square = nearest * (k / n as f64).max(1.0);
            let [w, h] = self.bounds.size;
            (REACH * square.sqrt()).clamp(1e-9 * (w + h), widest)
        };
        let mut radii = [0.0; COUNT];
        for (radius, estimator) in radii.iter_mut().zip(&ESTIMATORS) {
            *radius = reach(estimator);
        }
        radii
    }
}

/// Weighted moments of places (relative to the point of the estimate) and values.
#[derive(Clone, Copy, Debug)]
struct Sums<const N: usize> {
    weight: f64,
    place: [f64; 2],
    /// xx, xy, yy.
    places: [f64; 3],
    value: [f64; N],
    /// x·value, y·value.
    products: [[f64; N]; 2],
}

impl<const N: usize> Default for Sums<N> {
    fn default() -> Self {
        Self { weight: 0.0, place: [0.0; 2], places: [0.0; 3], value: [0.0; N], products: [[0.0; N]; 2] }
    }
}

impl<const N: usize> Sums<N> {
    /// Adds a value at `way` from the point, and on a tile its images within the radius.
    fn add_images(&mut self, bounds: &Bounds, way: [f64; 2], radius: f64, weight: f64, value: &[f64; N]) {
        let kernel = |[x, y]: [f64; 2]| {
            let t = 1.0 - (x * x + y * y) / (radius * radius);
            if t > 0.0 { t * t * t * t } else { 0.0 }
        };
        if bounds.edges == Edges::Closed {
            self.add(way, weight * (kernel(way) + FAR), value);
            return;
        }
        let images = bounds.size.map(|side| (radius / side + 0.5).ceil() as i32);
        for down in -images[1]..=images[1] {
            for across in -images[0]..=images[0] {
                let image =
                    [way[0] + f64::from(across) * bounds.size[0], way[1] + f64::from(down) * bounds.size[1]];
                let weight = weight * kernel(image);
                if weight > 0.0 {
                    self.add(image, weight, value);
                }
            }
        }
        // Without a place: it does not jump where another image becomes the nearest.
        self.add([0.0; 2], weight * FAR, value);
    }

    fn add(&mut self, [x, y]: [f64; 2], weight: f64, value: &[f64; N]) {
        self.weight += weight;
        self.place[0] += weight * x;
        self.place[1] += weight * y;
        self.places[0] += weight * x * x;
        self.places[1] += weight * x * y;
        self.places[2] += weight * y * y;
        for (i, value) in value.iter().enumerate() {
            self.value[i] += weight * value;
            self.products[0][i] += weight * x * value;
            self.products[1][i] += weight * y * value;
        }
    }

    fn mean(&self) -> [f64; N] {
        self.value.map(|value| value / self.weight)
    }

    /// The value at the point itself of the plane fitted with this ridge on its slope.
    fn solved(&self, ridge: f64) -> [f64; N] {
        let mean = self.mean();
        if ridge.is_infinite() {
            return mean;
        }
        let [x, y] = self.place.map(|sum| sum / self.weight);
        let [xx, xy, yy] = self.places.map(|sum| sum / self.weight);
        let [xx, xy, yy] = [(xx - x * x).max(0.0), xy - x * y, (yy - y * y).max(0.0)];
        // Above rounding where all marks are in one place.
        let ridge = 0.5 * ridge * (xx + yy) + 1e-2;
        let [xx, yy] = [xx + ridge, yy + ridge];
        let determinant = xx * yy - xy * xy;
        let mut at = mean;
        for (i, at) in at.iter_mut().enumerate() {
            let xv = self.products[0][i] / self.weight - x * mean[i];
            let yv = self.products[1][i] / self.weight - y * mean[i];
            *at -= (x * (yy * xv - xy * yv) + y * (xx * yv - xy * xv)) / determinant;
        }
        at
    }
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
fn weighted_median(values: impl Iterator<Item = (f64, f64)>) -> f64 {
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
