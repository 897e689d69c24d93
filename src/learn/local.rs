//! Locally weighted linear regression.
//!
//! At a question q the neighbours xᵢ with their answers yᵢ have the weights
//!
//! ```text
//! wᵢ = exp(−(1.5 dᵢ/h)²)      dᵢ = |xᵢ − q| in standardised features, h = distance of the k-th neighbour
//! ```
//!
//! and the answer is β₀ of the line that minimises Σ wᵢ |yᵢ − β₀ − Bᵀ(xᵢ − q)/h|² + λ|B|².
//! (Atkeson, Moore & Schaal, Artificial Intelligence Review 11, 1997, §4–5.)

use nalgebra::{DMatrix, DVector};

/// λ ÷ Σw: keeps a feature that hardly varies among the neighbours from tilting the answer; too small to
/// be seen where it does vary (a line is recovered to 1e-6).
const RIDGE: f64 = 1e-6;

/// A known point of the map: features → outputs.
pub(super) struct Sample {
    /// The features, in their own units.
    pub at: Vec<f64>,
    /// The outputs.
    pub gives: Vec<f64>,
    /// The row it comes from; the mirror images of a row share it.
    pub row: usize,
}

/// The known points, standardised, ready to be asked.
pub(super) struct Local {
    /// Features a sample.
    dims: usize,
    /// Standard deviation of each feature.
    scale: Vec<f64>,
    /// Features ÷ scale, sample by sample.
    x: Vec<f64>,
    samples: Vec<Sample>,
    /// Lowest and highest of each output.
    span: Vec<[f64; 2]>,
    /// k of the bandwidth.
    neighbours: usize,
}

/// An answer of the local line.
pub(super) struct Fit {
    /// The outputs, clamped to the span that the samples have.
    pub value: Vec<f64>,
    /// Standard deviation of a new measurement about each output: scatter and the line's own uncertainty.
    pub deviation: Vec<f64>,
    /// How one-sided the neighbours lie about the question, Σkᵢ²·(Σw)²/Σw² with the line's equivalent
    /// kernel k: 1 in their middle, 1 + (their mean's distance ÷ their spread)² elsewhere. On the face of a
    /// box about 3, at the corner of four faces about 8.
    pub one_sided: f64,
}

/// The double-angle vector in the last two numbers, its components times ±1: a mirror image.
pub(super) fn mirrored(numbers: &[f64], [c, s]: [f64; 2]) -> Vec<f64> {
    let mut numbers = numbers.to_vec();
    if let [.., x, y] = numbers.as_mut_slice() {
        (*x, *y) = (*x * c, *y * s);
    }
    numbers
}

/// Does a parameter vary among the rows, by a factor (or a share) of 2 % at least? Less is no feature.
pub(super) fn varies(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    high - low > 0.02
}

impl Local {
    /// Standardises `samples`, whose last two features are a vector: its components share one scale, so that
    /// distance does not depend on direction. There are `neighbours` a feature.
    pub fn new(samples: Vec<Sample>, neighbours: usize) -> Self {
        let dims = samples.first().map_or(0, |sample| sample.at.len());
        let n = samples.len().max(1) as f64;
        let mut variance: Vec<f64> = (0..dims)
            .map(|j| {
                let mean = samples.iter().map(|s| s.at[j]).sum::<f64>() / n;
                samples.iter().map(|s| (s.at[j] - mean) * (s.at[j] - mean)).sum::<f64>() / n
            })
            .collect();
        let vector = &mut variance[dims.saturating_sub(2)..];
        let shared = vector.iter().sum::<f64>() / 2.0;
        vector.fill(shared);
        // A feature that does not vary at all must not divide by zero; 1 leaves it without weight.
        let scale: Vec<f64> = variance.iter().map(|v| if *v > 1e-18 { v.sqrt() } else { 1.0 }).collect();
        let x = samples.iter().flat_map(|s| s.at.iter().zip(&scale).map(|(x, scale)| x / scale)).collect();
        let outputs = samples.first().map_or(0, |sample| sample.gives.len());
        let span = (0..outputs)
            .map(|m| {
                let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
                samples.iter().fold([low, high], |[l, h], s| [l.min(s.gives[m]), h.max(s.gives[m])])
            })
            .collect();
        Self { dims, scale, x, samples, span, neighbours: neighbours * dims }
    }

    /// The samples.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// Squared standardised distance of `q` to each sample, without those of the row `without`.
    fn distances(&self, q: &[f64], without: Option<usize>) -> Vec<(f64, usize)> {
        let q: Vec<f64> = q.iter().zip(&self.scale).map(|(q, scale)| q / scale).collect();
        let squared = |x: &[f64]| x.iter().zip(&q).map(|(x, q)| (x - q) * (x - q)).sum::<f64>();
        self.x
            .chunks_exact(self.dims)
            .enumerate()
            .filter(|(i, _)| without.is_none_or(|row| self.samples[*i].row != row))
            .map(|(i, x)| (squared(x), i))
            .collect()
    }

    /// The features of the sample nearest to `q`.
    pub fn nearest(&self, q: &[f64]) -> &[f64] {
        let nearest = self.distances(q, None).into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.map_or(&[], |(_, i)| &self.samples[i].at)
    }

    /// The answer at `q`, as if the row `without` were not there.
    pub fn fit(&self, q: &[f64], without: Option<usize>) -> Fit {
        let mut near = self.distances(q, without);
        let k = self.neighbours.min(near.len());
        let order = |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        if k < near.len() {
            near.select_nth_unstable_by(k, order);
            near.truncate(k);
        }
        near.sort_unstable_by(order);
        // All neighbours at one place: any h gives them weight 1.
        let h = near.last().map_or(1.0, |last| last.0.sqrt()).max(1e-9);
        let design = Design::new(self, &near, q, h);
        self.solve(&design, &near)
    }

    fn solve(&self, design: &Design, near: &[(f64, usize)]) -> Fit {
        let p = self.dims + 1;
        let total = design.weight.sum();
        let mut normal = design.weighted.tr_mul(&design.x);
        for j in 1..p {
            normal[(j, j)] += RIDGE * total;
        }
        // β₀ = Σ kᵢ yᵢ, the equivalent kernel; one solve serves every output.
        let mut first = DVector::zeros(p);
        first[0] = 1.0;
        let solved = normal.clone().cholesky().map(|cholesky| cholesky.solve(&first));
        let column = solved.unwrap_or_else(|| {
            // Not positive definite in rounding: the mean instead of the line.
            first / normal[(0, 0)].max(f64::MIN_POSITIVE)
        });
        let kernel = &design.weighted * &column;
        let y = DMatrix::from_fn(near.len(), self.span.len(), |i, m| self.samples[near[i].1].gives[m]);
        let value = y.tr_mul(&kernel);
        let slopes = normal
            .cholesky()
            .map_or_else(|| DMatrix::zeros(p, self.span.len()), |c| c.solve(&design.weighted.tr_mul(&y)));
        let residual = &y - &design.x * slopes;
        let effective = total * total / design.weight.norm_squared();
        let freedom = effective / (effective - p as f64).max(1.0);
        let leverage = kernel.norm_squared();
        let deviation = |m: usize| {
            let r = residual.column(m);
            let scatter: f64 = design.weight.iter().zip(r.iter()).map(|(w, r)| w * r * r).sum();
            (scatter / total * freedom * (1.0 + leverage)).sqrt()
        };
        Fit {
            value: value.iter().zip(&self.span).map(|(v, [low, high])| v.clamp(*low, *high)).collect(),
            deviation: (0..self.span.len()).map(deviation).collect(),
            one_sided: leverage * effective,
        }
    }
}

/// The neighbours of a question as the rows of a regression.
struct Design {
    /// (1, (xᵢ − q)/h).
    x: DMatrix<f64>,
    /// The same times wᵢ.
    weighted: DMatrix<f64>,
    weight: DVector<f64>,
}

impl Design {
    fn new(local: &Local, near: &[(f64, usize)], q: &[f64], h: f64) -> Self {
        let dims = local.dims;
        let x = DMatrix::from_fn(near.len(), dims + 1, |i, j| match j {
            0 => 1.0,
            _ => (local.x[near[i].1 * dims + j - 1] - q[j - 1] / local.scale[j - 1]) / h,
        });
        let weight = DVector::from_iterator(
            near.len(),
            near.iter().map(|(squared, _)| {
                let d = 1.5 * squared.sqrt() / h;
                libm::exp(-d * d)
            }),
        );
        let mut weighted = x.clone();
        for (mut row, w) in weighted.row_iter_mut().zip(weight.iter()) {
            row *= *w;
        }
        Self { x, weighted, weight }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a 3-D box that fill it evenly without a generator (R₃ sequence), and `f` there.
    fn box_of(n: usize, f: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Sample> {
        (0..n)
            .map(|i| {
                let at: Vec<f64> =
                    [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|a| (0.5 + a * i as f64).fract()).into();
                Sample { gives: f(&at), at, row: i }
            })
            .collect()
    }

    #[test]
    fn a_plane_is_recovered_exactly() {
        let plane = |x: &[f64]| vec![1.0 + 2.0 * x[0] - 3.0 * x[1] + 40.0 * x[2], 7.0];
        let local = Local::new(box_of(200, plane), 12);
        for q in [[0.5, 0.5, 0.5], [0.1, 0.9, 0.3], [0.02, 0.02, 0.02]] {
            let fit = local.fit(&q, None);
            assert!((fit.value[0] - plane(&q)[0]).abs() < 5e-4, "{q:?}: {}", fit.value[0]);
            assert_eq!(fit.value[1], 7.0);
            assert!(fit.deviation[0] < 1e-3 && fit.deviation[1] < 1e-12);
        }
    }

    #[test]
    fn an_answer_stays_within_what_was_seen() {
        let local = Local::new(box_of(200, |x| vec![100.0 * x[0]]), 12);
        let high = local.samples().iter().map(|s| s.gives[0]).fold(0.0, f64::max);
        assert_eq!(local.fit(&[9.0, 0.5, 0.5], None).value[0], high);
    }

    #[test]
    fn a_row_left_out_has_no_say() {
        let mut samples = box_of(100, |x| vec![x[0]]);
        let (q, told) = (samples[40].at.clone(), samples[40].at[0]);
        samples[40].gives[0] = 50.0;
        let local = Local::new(samples, 7);
        assert!((local.fit(&q, Some(40)).value[0] - told).abs() < 1e-4);
        assert!(local.fit(&q, None).value[0] > told + 1.0);
    }

    #[test]
    fn scatter_is_measured() {
        // ±0.1 by turns about a plane: standard deviation 0.1.
        let samples = box_of(400, |x| vec![x[0]])
            .into_iter()
            .map(|mut s| {
                s.gives[0] += if s.row % 2 == 0 { 0.1 } else { -0.1 };
                s
            })
            .collect();
        let deviation = Local::new(samples, 20).fit(&[0.5, 0.5, 0.5], None).deviation[0];
        assert!((0.09..0.13).contains(&deviation), "{deviation}");
    }

    #[test]
    fn samples_at_one_place_give_their_mean() {
        let samples = (0..30)
            .map(|row| Sample { at: vec![2.0, 0.0, 0.0], gives: vec![(row % 3) as f64], row })
            .collect();
        let value = Local::new(samples, 4).fit(&[2.0, 0.0, 0.0], None).value[0];
        assert!((value - 1.0).abs() < 0.2, "{value}");
    }

    #[test]
    fn the_nearest_sample_is_found() {
        let local = Local::new(box_of(50, |x| vec![x[0]]), 4);
        let at = local.samples()[17].at.clone();
        assert_eq!(local.nearest(&[at[0] + 1e-3, at[1], at[2] - 1e-3]), at);
    }
}
