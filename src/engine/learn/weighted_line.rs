//! The weighted line through the neighbours of a question, solved on the stack.

use nalgebra::{SMatrix, SVector};

use crate::learn::local::Local;
use crate::learn::small_vector::{MOST, SmallVector};
use crate::learn::tree::{Near, Place};

/// λ ÷ Σw: limits the slope along a feature that hardly varies among the neighbours; negligible where it does vary (a line
/// is recovered to 1e-6).
const RIDGE: f64 = 1e-6;

/// Unknowns of a line: β₀ and a slope for each feature. A system with fewer features has zeros there; the ridge keeps the
/// matrix regular.
const UNKNOWNS: usize = MOST + 1;

/// An answer of the local line.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    /// The outputs.
    pub value: SmallVector,
    /// Standard deviation of a new measurement about each output: scatter and the line's own uncertainty.
    pub deviation: Place,
}

/// A neighbour as a row of the regression.
struct Equation {
    /// (1, (xᵢ − q)/h).
    x: [f64; UNKNOWNS],
    /// yᵢ.
    y: Place,
    /// wᵢ.
    weight: f64,
}

/// The line through the neighbours of a question.
pub(super) struct Line {
    features: usize,
    outputs: usize,
    equations: Vec<Equation>,
    /// β₀ and slopes of each output.
    slopes: SMatrix<f64, UNKNOWNS, MOST>,
    /// First column of the inverse normal matrix: kᵢ = wᵢ (1, (xᵢ − q)/h) · this.
    column: SVector<f64, UNKNOWNS>,
    /// Σw.
    total: f64,
    /// Σw².
    squares: f64,
}

/// Σ wᵢ xᵢ xᵢᵀ with the ridge, its lower triangle, and Σ wᵢ xᵢ yᵢᵀ of the first `outputs` of yᵢ, column by column; the others are 0.
fn normal(
    equations: &[Equation],
    outputs: usize,
    total: f64,
) -> (SMatrix<f64, UNKNOWNS, UNKNOWNS>, SMatrix<f64, UNKNOWNS, MOST>) {
    let mut normal = [[0.0; UNKNOWNS]; UNKNOWNS];
    let mut right = [[0.0; UNKNOWNS]; MOST];
    for Equation { x, y, weight } in equations {
        let mut weighted = *x;
        weighted.iter_mut().for_each(|x| *x *= weight);
        for (j, (column, x)) in normal.iter_mut().zip(x).enumerate() {
            column[j..].iter_mut().zip(&weighted[j..]).for_each(|(sum, weighted)| *sum += weighted * x);
        }
        for (column, y) in right.iter_mut().zip(y).take(outputs) {
            column.iter_mut().zip(&weighted).for_each(|(sum, weighted)| *sum += weighted * y);
        }
    }
    for (j, column) in normal.iter_mut().enumerate().skip(1) {
        column[j] += RIDGE * total;
    }
    (normal.into(), right.into())
}

impl Line {
    /// The line at `q` through the samples `near`, the nearest first, of which the last gives the bandwidth.
    pub fn through(local: &Local, q: &Place, near: &[Near]) -> Self {
        // If all neighbours are at one place, any h gives them weight 1.
        let h = near.last().map_or(1.0, |last| last.squared().sqrt()).max(1e-9);
        let equation = |near: &Near| {
            let [place, y] = local.known(*near);
            let mut x = [1.0; UNKNOWNS];
            for (x, (place, q)) in x[1..].iter_mut().zip(place.iter().zip(q)) {
                *x = (place - q) / h;
            }
            let d = 1.5 * near.squared().sqrt() / h;
            Equation { x, y, weight: libm::exp(-d * d) }
        };
        let equations: Vec<Equation> = near.iter().map(equation).collect();
        let total = equations.iter().map(|equation| equation.weight).sum::<f64>();
        let squares = equations.iter().map(|equation| equation.weight * equation.weight).sum();
        let (normal, right) = normal(&equations, local.outputs(), total);
        let mut first = SVector::<f64, UNKNOWNS>::zeros();
        first[0] = 1.0;
        let (slopes, column) = match normal.cholesky() {
            Some(cholesky) => (cholesky.solve(&right), cholesky.solve(&first)),
            None => {
                // Not positive definite because of rounding: the mean instead of the line.
                let share = 1.0 / total.max(f64::MIN_POSITIVE);
                let mut mean = SMatrix::<f64, UNKNOWNS, MOST>::zeros();
                mean.row_mut(0).copy_from(&(right.row(0) * share));
                (mean, first * share)
            }
        };
        Self { features: local.dims(), outputs: local.outputs(), equations, slopes, column, total, squares }
    }

    /// The outputs at the question.
    pub fn value(&self) -> SmallVector {
        SmallVector::new((0..self.outputs).map(|m| self.slopes[(0, m)]))
    }

    /// Σkᵢ², the variance of the answer for neighbours of variance 1.
    fn leverage(&self) -> f64 {
        let kernel = |Equation { x, weight, .. }: &Equation| {
            weight * x.iter().zip(self.column.iter()).map(|(x, c)| x * c).sum::<f64>()
        };
        self.equations.iter().map(kernel).map(|kernel| kernel * kernel).sum()
    }

    /// (Σw)²/Σw², the effective number of neighbours.
    fn effective(&self) -> f64 {
        self.total * self.total / self.squares
    }

    /// One-sidedness of the neighbours around the question: Σkᵢ²·(Σw)²/Σw² with the line's equivalent kernel k: 1 at their
    /// mean, 1 + (distance from their mean ÷ their spread)² elsewhere. About 3 on the face of a box, about 8 at the corner
    /// of four faces.
    pub fn one_sided(&self) -> f64 {
        self.leverage() * self.effective()
    }

    /// The answer with its uncertainty.
    pub fn fit(&self) -> Fit {
        let value = self.value();
        let mut scatter = [0.0; MOST];
        for Equation { x, y, weight } in &self.equations {
            for (m, (scatter, y)) in scatter.iter_mut().zip(y).enumerate().take(self.outputs) {
                let line: f64 = x.iter().zip(self.slopes.column(m).iter()).map(|(x, slope)| x * slope).sum();
                *scatter += weight * (y - line) * (y - line);
            }
        }
        let (effective, leverage) = (self.effective(), self.leverage());
        // A slope for each feature in use.
        let unknowns = 1.0 + self.features as f64;
        let freedom = effective / (effective - unknowns).max(1.0);
        let deviation = scatter.map(|scatter| (scatter / self.total * freedom * (1.0 + leverage)).sqrt());
        Fit { value, deviation }
    }
}

impl Local {
    /// The line at `q`, computed without the row `without`.
    pub fn line(&self, q: &SmallVector, without: Option<usize>) -> Line {
        let q = self.standardised(q);
        Line::through(self, &q, &self.near(&q, self.neighbours(), without))
    }

    /// The answer at `q`, computed without the row `without`; clamped to the range of the rows.
    pub fn fit(&self, q: &SmallVector, without: Option<usize>) -> Fit {
        let fit = self.line(q, without).fit();
        Fit { value: self.clamped(fit.value), ..fit }
    }
}
