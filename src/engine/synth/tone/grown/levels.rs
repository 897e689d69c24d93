//! A threshold for each px, with which the share of ink around the px equals the wanted tone, whatever has grown.
//!
//! ```text
//! F(x, t) = G_σ * [u ≥ t]           the local share of ink at the level t
//! l(x):  F(x, l) = c(x),  c = the tone
//! twice: c += GAIN · (G_σ * tone − G_σ * [u ≥ l])
//! ```
//!
//! F varies over σ and is stored on coarse cells. The tone is read at each px, so that its edges remain as sharp as the pattern.

use rayon::prelude::*;

use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// Number of thresholds at which F is computed.
const THRESHOLDS: usize = 40;
/// Rounds of feedback (`facts.md` V).
const ROUNDS: usize = 2;
/// The share of an error that a round of feedback removes (`facts.md` V).
const GAIN: f32 = 0.8;
/// σ in coarse cells: large enough for a smooth Gaussian.
const COARSE: f64 = 2.0;
/// Stride of the px that are sorted for the quantiles: a prime, so that no stripe is always missed.
const STRIDE: usize = 7;
/// Least distance of the share of ink from 0 and 1 for which thresholds lie within the grown heights.
const LEAST: f32 = 0.004;

/// Values on blocks of px.
struct Blocks {
    /// px along a side of a block.
    side: usize,
    /// Width and height, px.
    size: [usize; 2],
    /// Blocks along x and y.
    coarse: [usize; 2],
    /// σ in blocks.
    sigma: f64,
    edges: Edges,
}

impl Blocks {
    fn new(size: [usize; 2], sigma: f64, edges: Edges) -> Self {
        let side = ((sigma / COARSE).round() as usize).max(1);
        let coarse = size.map(|px| px.div_ceil(side));
        Self { side, size, coarse, sigma: sigma / side as f64, edges }
    }

    /// The means over blocks of the `value` of each px, blurred.
    fn blurred(&self, value: impl Fn(usize) -> f32 + Sync) -> Vec<f32> {
        let ([width, height], side) = (self.size, self.side);
        let mut means = vec![0.0; self.coarse[0] * self.coarse[1]];
        means.par_chunks_mut(self.coarse[0]).enumerate().for_each(|(row, out)| {
            let rows = row * side..height.min((row + 1) * side);
            for y in rows.clone() {
                for (column, out) in out.iter_mut().enumerate() {
                    let px = y * width + column * side..y * width + width.min((column + 1) * side);
                    *out += px.map(&value).sum::<f32>();
                }
            }
            for (column, out) in out.iter_mut().enumerate() {
                let across = width.min((column + 1) * side) - column * side;
                *out /= (across * rows.len()) as f32;
            }
        });
        gaussian(&means, self.coarse, self.sigma, self.edges)
    }

    /// The two blocks of an axis between whose centres px `at` lies, and its position between them, 0..1.
    fn between(&self, axis: usize, at: usize) -> (usize, usize, f32) {
        let place = (at as f32 + 0.5) / self.side as f32 - 0.5;
        let first = place.floor();
        let block = |k: isize| self.edges.index(k, self.coarse[axis]);
        (block(first as isize), block(first as isize + 1), place - first)
    }
}

/// The threshold of each px of `u` (on `size` px), for the share of ink `wanted` there. Ink is where `u` is not below the
/// threshold, and shares are means over a Gaussian of `sigma` px.
#[must_use]
pub fn levels(u: &[f32], size: [usize; 2], wanted: &[f32], sigma: f64, edges: Edges) -> Vec<f32> {
    let blocks = Blocks::new(size, sigma, edges);
    let thresholds = thresholds(u);
    let shares: Vec<Vec<f32>> = thresholds
        .iter()
        .map(|threshold| blocks.blurred(|px| if u[px] >= *threshold { 1.0 } else { 0.0 }))
        .collect();
    let asked = blocks.blurred(|px| wanted[px]);
    let mut shift = vec![0.0_f32; asked.len()];
    let mut levels = Vec::new();
    for round in 0..=ROUNDS {
        levels = solved(&blocks, &thresholds, &shares, wanted, &shift);
        if round < ROUNDS {
            let found = blocks.blurred(|px| if u[px] >= levels[px] { 1.0 } else { 0.0 });
            for ((shift, asked), found) in shift.iter_mut().zip(&asked).zip(found) {
                *shift += GAIN * (asked - found);
            }
        }
    }
    levels
}

/// Thresholds between the lowest and the highest of `u`, denser near both ends, where thin lines and thin gaps are decided.
fn thresholds(u: &[f32]) -> Vec<f32> {
    let mut sorted: Vec<f32> = u.iter().copied().step_by(STRIDE).collect();
    sorted.sort_unstable_by(f32::total_cmp);
    let last = sorted.len().saturating_sub(1);
    let quantile = |k: usize| {
        let share = 0.5 - 0.5 * libm::cos(std::f64::consts::PI * k as f64 / (THRESHOLDS - 1) as f64);
        sorted.get((share * last as f64).round() as usize).copied().unwrap_or(0.5)
    };
    (0..THRESHOLDS).map(quantile).collect()
}

/// The threshold of each px at which the share of ink is `wanted` + `shift` there.
fn solved(
    blocks: &Blocks,
    thresholds: &[f32],
    shares: &[Vec<f32>],
    wanted: &[f32],
    shift: &[f32],
) -> Vec<f32> {
    let [width, height] = blocks.size;
    let columns: Vec<(usize, usize, f32)> = (0..width).map(|x| blocks.between(0, x)).collect();
    let mut levels = vec![0.0; width * height];
    let across = blocks.coarse[0];
    levels.par_chunks_mut(width).enumerate().for_each_init(Vec::new, |blended, (y, out)| {
        let (upper, lower, v) = blocks.between(1, y);
        let row = |of: &[f32], column: usize| {
            of[upper * across + column] + v * (of[lower * across + column] - of[upper * across + column])
        };
        blended.clear();
        for of in shares.iter().map(Vec::as_slice).chain([shift]) {
            blended.extend((0..across).map(|column| row(of, column)));
        }
        let share = |k: usize, (left, right, u): (usize, usize, f32)| {
            let of = &blended[k * across..(k + 1) * across];
            of[left] + u * (of[right] - of[left])
        };
        for ((level, column), wanted) in out.iter_mut().zip(&columns).zip(&wanted[y * width..]) {
            let asked = (wanted + share(shares.len(), *column)).clamp(LEAST, 1.0 - LEAST);
            // Shares fall from the first threshold to the last.
            let (mut low, mut high) = (0, thresholds.len() - 1);
            while high - low > 1 {
                let middle = (low + high) / 2;
                if share(middle, *column) >= asked { low = middle } else { high = middle }
            }
            let [from, to] = [low, high].map(|k| share(k, *column));
            let way = if from > to { ((from - asked) / (from - to)).clamp(0.0, 1.0) } else { 0.5 };
            *level = thresholds[low] + way * (thresholds[high] - thresholds[low]);
        }
    });
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Waves of 16 px with varying height and mean.
    fn waves(size: [usize; 2]) -> Vec<f32> {
        let at = |px: usize| {
            let [x, y] = [px % size[0], px / size[0]].map(|k| k as f64);
            let (height, mean) = (0.5 + 0.4 * x / size[0] as f64, 0.3 * y / size[1] as f64);
            (mean + height * libm::sin(TAU * (x + 0.3 * y) / 16.0)) as f32
        };
        (0..size[0] * size[1]).map(at).collect()
    }

    #[test]
    fn the_local_share_of_ink_is_the_tone_whatever_the_waves_are() {
        let size = [320, 240];
        let (u, sigma) = (waves(size), 0.45 * 16.0);
        let tone = |px: usize| 0.1 + 0.8 * (px % size[0]) as f32 / size[0] as f32;
        let wanted: Vec<f32> = (0..size[0] * size[1]).map(tone).collect();
        let levels = levels(&u, size, &wanted, sigma, Edges::Closed);
        let ink: Vec<f32> = u.iter().zip(&levels).map(|(u, l)| if u >= l { 1.0 } else { 0.0 }).collect();
        let [found, asked] = [&ink, &wanted].map(|values| gaussian(values, size, 16.0, Edges::Closed));
        let errors: Vec<f32> = found.iter().zip(&asked).map(|(found, asked)| (found - asked).abs()).collect();
        let mean = errors.iter().sum::<f32>() / errors.len() as f32;
        assert!(mean < 0.006, "{mean}");
        // A single threshold leaves most of the error: the test would notice it.
        let plain: Vec<f32> = u.iter().map(|u| if *u >= 0.15 { 1.0 } else { 0.0 }).collect();
        let plain = gaussian(&plain, size, 16.0, Edges::Closed);
        assert!(plain.iter().zip(&asked).map(|(a, b)| (a - b).abs()).sum::<f32>() / plain.len() as f32 > 0.1);
    }

    #[test]
    fn darker_places_never_have_higher_levels() {
        let size = [160, 120];
        let u = waves(size);
        let solve = |tone: f32| levels(&u, size, &vec![tone; u.len()], 7.0, Edges::Closed);
        let [light, dark] = [0.3, 0.6].map(solve);
        assert!(light.iter().zip(&dark).all(|(light, dark)| light >= dark));
    }
}
