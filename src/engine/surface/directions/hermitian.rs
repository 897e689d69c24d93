//! Sparse systems of equations between directions, and conjugate gradients.

use rayon::prelude::*;

/// A direction as exp(2iθ), times any length: [real, imaginary].
pub type Complex = [f64; 2];

pub fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

pub fn conjugate([a, b]: Complex) -> Complex {
    [a, -b]
}

pub fn plus([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a + c, b + d]
}

/// A direction scaled to length 1; the first axis if it is 0.
pub fn unit([a, b]: Complex) -> Complex {
    let length = (a * a + b * b).sqrt();
    if length > 0.0 { [a / length, b / length] } else { [1.0, 0.0] }
}

/// The equations diagonal · z − Σ coupling · z of the others = right, in every row; the coupling from i to j is the conjugate of
/// that from j to i.
#[derive(Clone, Debug, Default)]
pub struct Hermitian {
    /// Start and number of the couplings of each row.
    pub starts: Vec<u32>,
    pub columns: Vec<u32>,
    pub couplings: Vec<Complex>,
    pub diagonal: Vec<f64>,
    pub right: Vec<Complex>,
}

/// Rows that one thread works on at a time. Not tuned.
const PART: usize = 1 << 10;
/// Largest residual, as a share of the right side.
const LEFT: f64 = 1e-7;
/// Most steps.
const STEPS: usize = 2_000;

impl Hermitian {
    /// The couplings of a row with their columns.
    pub fn row(&self, row: usize) -> impl Iterator<Item = (usize, Complex)> {
        let range = self.starts[row] as usize..self.starts[row + 1] as usize;
        let columns = self.columns[range.clone()].iter().map(|column| *column as usize);
        columns.zip(self.couplings[range].iter().copied())
    }

    /// Adds a condition that holds a row at a value, with a weight.
    pub fn hold(&mut self, row: usize, to: Complex, weight: f64) {
        self.diagonal[row] += weight;
        self.right[row] = plus(self.right[row], to.map(|part| weight * part));
    }

    fn by_row(&self, of: impl Fn(usize) -> Complex + Send + Sync) -> Vec<Complex> {
        (0..self.diagonal.len()).into_par_iter().with_min_len(PART).map(of).collect()
    }

    fn neighbours(&self, values: &[Complex], row: usize) -> Complex {
        self.row(row).fold([0.0; 2], |sum, (column, coupling)| plus(sum, times(coupling, values[column])))
    }

    /// Half of each value plus half of the mean of its neighbours, transported to its row.
    pub fn averages(&self, values: &[Complex]) -> Vec<Complex> {
        self.by_row(|row| {
            let total: f64 = self.row(row).map(|(_, [a, b])| (a * a + b * b).sqrt()).sum();
            let mean = self.neighbours(values, row);
            let share = if total > 0.0 { 0.5 / total } else { 0.0 };
            [0, 1].map(|k| (if total > 0.0 { 0.5 } else { 1.0 }) * values[row][k] + share * mean[k])
        })
    }

    /// The solution, from a first guess: conjugate gradients with the diagonal as preconditioner.
    pub fn solve(&self, mut values: Vec<Complex>) -> Vec<Complex> {
        let inverse: Vec<f64> =
            self.diagonal.iter().map(|diagonal| if *diagonal > 0.0 { 1.0 / diagonal } else { 0.0 }).collect();
        let product = |values: &[Complex]| {
            self.by_row(|row| {
                let around = self.neighbours(values, row);
                [0, 1].map(|k| self.diagonal[row] * values[row][k] - around[k])
            })
        };
        let dot = |a: &[Complex], b: &[Complex]| -> f64 {
            a.iter().zip(b).map(|(a, b)| a[0] * b[0] + a[1] * b[1]).sum()
        };
        let scaled = |left: &[Complex]| -> Vec<Complex> {
            left.iter().zip(&inverse).map(|(left, inverse)| left.map(|part| part * inverse)).collect()
        };
        let start = product(&values);
        let mut left: Vec<Complex> =
            self.right.iter().zip(&start).map(|(b, a)| [b[0] - a[0], b[1] - a[1]]).collect();
        let enough = LEFT * LEFT * dot(&self.right, &scaled(&self.right));
        let mut step = scaled(&left);
        let mut rest = dot(&left, &step);
        let mut direction = step;
        for _ in 0..STEPS {
            if rest.is_nan() || rest <= enough {
                break;
            }
            let image = product(&direction);
            let far = rest / dot(&direction, &image);
            for (row, (direction, image)) in direction.iter().zip(&image).enumerate() {
                for k in 0..2 {
                    values[row][k] += far * direction[k];
                    left[row][k] -= far * image[k];
                }
            }
            step = scaled(&left);
            let now = dot(&left, &step);
            let more = now / rest;
            rest = now;
            for (direction, step) in direction.iter_mut().zip(&step) {
                *direction = [0, 1].map(|k| step[k] + more * direction[k]);
            }
        }
        values
    }
}
