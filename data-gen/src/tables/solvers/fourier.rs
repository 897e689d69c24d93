//! Their equations 11 and 12 in Fourier space, where a blur by a uniform tensor is a product.
//!
//! λ(q) = qᵀAq + b, b = 1. With R held over a step (eq. 11) Ĉ ← e^(−λΔt) Ĉ + (1 − e^(−λΔt))/λ · R̂; with R as an impulse at its
//! beginning (eq. 12) Ĉ ← e^(−λΔt) (Ĉ + (e^(bΔt) − 1)/b · R̂).

use std::sync::Arc;

use dapple_engine::rd::pairs::PairModel;
use rustfft::num_complex::Complex32;
use rustfft::{Fft, FftPlanner, FftPlannerScalar};

use super::case::Case;
use super::{Run, SIDE};
use crate::cpu::Stopwatch;

/// What is taken for the reaction during a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// The reaction at the beginning of the step, all along: eq. 11.
    Exponential,
    /// An impulse at its beginning: eq. 12, whose Gaussian convolution is exact here.
    Impulse,
}

impl Rule {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exponential => "eq. 11",
            Self::Impulse => "eq. 12",
        }
    }
}

/// Transforms of the whole grid; spectra are transposed.
struct Transform {
    there: Arc<dyn Fft<f32>>,
    back: Arc<dyn Fft<f32>>,
    scratch: Vec<Complex32>,
    turned: Vec<Complex32>,
}

impl Transform {
    fn new(fast: bool) -> Self {
        let [there, back] = if fast {
            let mut planner = FftPlanner::new();
            [planner.plan_fft_forward(SIDE), planner.plan_fft_inverse(SIDE)]
        } else {
            let mut planner = FftPlannerScalar::new();
            [planner.plan_fft_forward(SIDE), planner.plan_fft_inverse(SIDE)]
        };
        let zero = Complex32::new(0.0, 0.0);
        let scratch = vec![zero; there.get_inplace_scratch_len().max(back.get_inplace_scratch_len())];
        Self { there, back, scratch, turned: vec![zero; SIDE * SIDE] }
    }

    fn run(&mut self, cells: &mut Vec<Complex32>, back: bool) {
        let plan = Arc::clone(if back { &self.back } else { &self.there });
        plan.process_with_scratch(cells, &mut self.scratch);
        // In squares that a cache holds.
        const BLOCK: usize = 16;
        for (top, left) in
            (0..SIDE).step_by(BLOCK).flat_map(|y| (0..SIDE).step_by(BLOCK).map(move |x| (y, x)))
        {
            for y in top..top + BLOCK {
                for x in left..left + BLOCK {
                    self.turned[x * SIDE + y] = cells[y * SIDE + x];
                }
            }
        }
        std::mem::swap(cells, &mut self.turned);
        plan.process_with_scratch(cells, &mut self.scratch);
    }
}

/// Factors of one morphogen at each frequency, transposed: of what is there and of the reaction.
fn factors(lengths: [f64; 2], angle: f64, rule: Rule, step: f64) -> Vec<[f32; 2]> {
    let (s, c) = libm::sincos(angle.to_radians());
    let frequency = |k: usize| {
        let k = if k < SIDE / 2 { k as f64 } else { k as f64 - SIDE as f64 };
        std::f64::consts::TAU * k / SIDE as f64
    };
    let at = |index: usize| {
        let [y, x] = [index % SIDE, index / SIDE].map(frequency);
        let [along, across] = [x * c + y * s, y * c - x * s];
        let lambda = 1.0 + (lengths[0] * along).powi(2) + (lengths[1] * across).powi(2);
        let kept = libm::exp(-lambda * step);
        let added = match rule {
            Rule::Exponential => (1.0 - kept) / lambda,
            Rule::Impulse => kept * (libm::exp(step) - 1.0),
        };
        [kept as f32, added as f32]
    };
    (0..SIDE * SIDE).map(at).collect()
}

/// The reaction where the largest difference is `x`.
fn reaction(model: &PairModel, x: f32, time: f64) -> f32 {
    let threshold = model.peak_gain() * model.threshold.at(time);
    let half_width = model.peak_gain() * model.softness;
    (0.5 + (x - threshold) / (2.0 * half_width)).clamp(0.0, 1.0)
}

/// Grows a pattern by steps of `step` in 1/b.
pub fn run(case: &Case, seed: u64, rule: Rule, step: f64, fast: bool) -> Result<Run, String> {
    let model = case.model(1);
    let noise = case.noise(seed)?;
    let mut transform = Transform::new(fast);
    let complex = |values: &Vec<f32>| values.iter().map(|value| Complex32::new(*value, 0.0)).collect();
    let mut spectra: Vec<Vec<Complex32>> = noise.iter().map(complex).collect();
    spectra.iter_mut().for_each(|spectrum| transform.run(spectrum, false));
    let factors: Vec<Vec<[f32; 2]>> = case
        .angles
        .iter()
        .flat_map(|angle| case.lengths().map(|lengths| factors(lengths, *angle, rule, step)))
        .collect();
    let mut differences: Vec<Vec<f32>> =
        noise.chunks(2).map(|pair| pair[0].iter().zip(&pair[1]).map(|(a, b)| a - b).collect()).collect();
    let steps = (case.time / step).round() as u64;
    let scale = 1.0 / (SIDE * SIDE) as f32;
    let mut cells = vec![Complex32::new(0.0, 0.0); SIDE * SIDE];
    let watch = Stopwatch::start();
    for taken in 0..steps {
        let time = taken as f64 * step;
        for (index, cell) in cells.iter_mut().enumerate() {
            let largest = differences.iter().map(|of| of[index]).fold(f32::MIN, f32::max);
            *cell = Complex32::new(reaction(&model, largest, time), 0.0);
        }
        transform.run(&mut cells, false);
        for (spectrum, factors) in spectra.iter_mut().zip(&factors) {
            for ((value, [kept, added]), reaction) in spectrum.iter_mut().zip(factors).zip(&cells) {
                *value = *value * *kept + *reaction * *added;
            }
        }
        // Two real fields in one complex one.
        for (pair, two) in differences.chunks_mut(2).enumerate() {
            let [a, b] = [4 * pair, 4 * pair + 1];
            for (index, cell) in cells.iter_mut().enumerate() {
                *cell = spectra[a][index] - spectra[b][index];
                if two.len() == 2 {
                    let other = spectra[a + 2][index] - spectra[b + 2][index];
                    *cell += Complex32::new(-other.im, other.re);
                }
            }
            transform.run(&mut cells, true);
            for (index, cell) in cells.iter().enumerate() {
                two[0][index] = scale * cell.re;
                if let Some(second) = two.get_mut(1) {
                    second[index] = scale * cell.im;
                }
            }
        }
    }
    Ok(Run { steps, seconds: watch.seconds(), differences, level: case.level() })
}
