//! Their section 5.3: for large b a step is R ← (G₊ − G₋) ∗ R above a threshold, with R of 0 and 1 and Gaussians G±.
//!
//! The sums over eight neighbouring cells of a row come from tables with 256 entries each, as they describe.

use super::case::Case;
use super::{Run, SIDE};
use crate::cpu::Stopwatch;

/// Most iterations.
const MOST: u64 = 60;
/// A pattern has settled where a smaller share of the cells changes.
const SETTLED: f64 = 1e-4;
/// Reach of the masks in standard deviations of the larger Gaussian.
const REACH: f64 = 3.0;
/// Period of the stripes of a pair ÷ the wavelength 2πs√d with the largest gain (`facts.md` T).
const PERIOD: f64 = 0.935;

/// Sums of a mask over eight cells of one of its rows, by their bits.
struct Tables {
    /// Cells from the middle of the mask to its left edge, and to its upper one.
    half: usize,
    /// By row and group of eight cells.
    sums: Vec<[f32; 256]>,
    /// Groups a row.
    groups: usize,
}

/// A Gaussian with these standard deviations along and across a direction, of sum 1.
fn gaussian(half: usize, [along, across]: [f64; 2], angle: f64) -> Vec<f64> {
    let (s, c) = libm::sincos(angle.to_radians());
    let side = 2 * half + 1;
    let value = |index: usize| {
        let [x, y] = [index % side, index / side].map(|k| k as f64 - half as f64);
        let [u, v] = [(x * c + y * s) / along, (y * c - x * s) / across];
        libm::exp(-0.5 * (u * u + v * v))
    };
    let values: Vec<f64> = (0..side * side).map(value).collect();
    let sum: f64 = values.iter().sum();
    values.into_iter().map(|value| value / sum).collect()
}

impl Tables {
    fn new(case: &Case, angle: f64) -> Self {
        let [[_, first], [_, second]] = case.lengths();
        let d = second / first;
        // Of a difference of Gaussians of σ and dσ, 2πσ √((d² − 1)/(4 ln d)) has the largest gain: as far apart as those of Euler.
        let across = PERIOD * case.size * d.sqrt() / ((d * d - 1.0) / (4.0 * libm::log(d))).sqrt();
        let along = case.elongation * across;
        let half = (REACH * along.max(d * across)).ceil() as usize;
        let [plus, minus] = [across, d * across].map(|across| gaussian(half, [along, across], angle));
        let side = 2 * half + 1;
        let groups = side.div_ceil(8);
        let weight = |row: usize, x: usize| {
            if x < side { (plus[row * side + x] - minus[row * side + x]) as f32 } else { 0.0 }
        };
        let sums = (0..side * groups).map(|index| {
            let (row, left) = (index / groups, 8 * (index % groups));
            std::array::from_fn(|bits| {
                (0..8).filter(|bit| bits >> bit & 1 == 1).map(|bit| weight(row, left + bit)).sum()
            })
        });
        Self { half, sums: sums.collect(), groups }
    }

    /// The mask's sums over `bytes`, the eight cells that begin at each cell.
    fn apply(&self, bytes: &[u8]) -> Vec<f32> {
        let row = |y: usize| {
            let mut sums = vec![0.0f32; SIDE];
            for dy in 0..=2 * self.half {
                let from = &bytes[(y + SIDE + dy - self.half) % SIDE * SIDE..][..SIDE];
                for group in 0..self.groups {
                    let table = &self.sums[dy * self.groups + group];
                    let first = SIDE + 8 * group - self.half % SIDE;
                    for (x, sum) in sums.iter_mut().enumerate() {
                        *sum += table[usize::from(from[(x + first) % SIDE])];
                    }
                }
            }
            sums
        };
        (0..SIDE).flat_map(row).collect()
    }
}

/// The eight cells that begin at each cell of a row, as the bits of a byte.
fn bytes(on: &[bool]) -> Vec<u8> {
    let byte = |index: usize| {
        let (x, row) = (index % SIDE, index / SIDE * SIDE);
        (0..8).filter(|bit| on[row + (x + bit) % SIDE]).map(|bit| 1u8 << bit).sum()
    };
    (0..SIDE * SIDE).map(byte).collect()
}

/// The largest gain of a difference of Gaussians whose widths have the ratio `d`.
fn peak_gain(d: f64) -> f64 {
    // At q = 2 √(ln d ÷ (d² − 1)) in units of 1/σ.
    let square = 4.0 * libm::log(d) / (d * d - 1.0);
    libm::exp(-0.5 * square) - libm::exp(-0.5 * d * d * square)
}

/// Iterates from the sign of the noise that the others begin from; the threshold is 0 in the first ten iterations.
pub fn run(case: &Case, seed: u64) -> Result<Run, String> {
    /// Iterations without a threshold: with it from the beginning, most of the noise dies.
    const UNRAMPED: u64 = 10;
    let tables: Vec<Tables> = case.angles.iter().map(|angle| Tables::new(case, *angle)).collect();
    let noise = case.noise(seed)?;
    let mut on: Vec<bool> = noise[0].iter().zip(&noise[1]).map(|(plus, minus)| plus > minus).collect();
    let level = case.threshold * peak_gain(case.lengths()[1][1] / case.size) as f32;
    let watch = Stopwatch::start();
    let mut steps = 0;
    loop {
        let bytes = bytes(&on);
        let differences: Vec<Vec<f32>> = tables.iter().map(|tables| tables.apply(&bytes)).collect();
        steps += 1;
        let threshold = if steps <= UNRAMPED { 0.0 } else { level };
        let mut changed = 0;
        for (index, on) in on.iter_mut().enumerate() {
            let now = differences.iter().any(|of| of[index] > threshold);
            changed += usize::from(now != *on);
            *on = now;
        }
        let settled = steps > UNRAMPED + 1 && (changed as f64) < SETTLED * on.len() as f64;
        if settled || steps == MOST {
            return Ok(Run { steps, seconds: watch.seconds(), differences, level });
        }
    }
}
