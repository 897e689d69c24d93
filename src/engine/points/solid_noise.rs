//! Noise in space, for surfaces: gradient noise on a lattice that is turned at random.
//!
//! Perlin, "Improving noise", SIGGRAPH 2002: 12 gradients, fade 6t⁵ − 15t⁴ + 10t³.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Noise in space, 0..1, spread as that of [`Noise`](super::noise::Noise).
#[derive(Clone, Debug)]
pub struct SolidNoise {
    octaves: Vec<Octave>,
    /// Makes up for the smaller spread of sums.
    spread: f64,
}

/// Noise of one size.
#[derive(Clone, Debug)]
struct Octave {
    /// Side of the lattice, in units of the points.
    side: f64,
    /// Unit vectors of the lattice, and where it begins.
    axes: [[f64; 3]; 3],
    shift: [f64; 3],
    weight: f64,
    seed: u64,
}

/// Deviation of the noise of one octave.
const DEVIATION: f64 = 0.22;
/// Deviation of gradient noise of one octave, −1..1: measured over 2·10⁶ random points.
const RAW: f64 = 0.27;
/// Seeds of octaves lie so far apart; an odd number, so that none repeats (2⁶⁴ ÷ the golden ratio).
const OCTAVE_SEED: u64 = 0x9E37_79B9_7F4A_7C15;

impl SolidNoise {
    /// Noise with `size` from a light place to the next dark one, and so many octaves, each of half the size and half the weight of the one
    /// before it.
    #[must_use]
    pub fn new(size: f64, octaves: u32, seed: u64) -> Self {
        let octave = |index: u32| {
            let weight = libm::exp2(-f64::from(index));
            let seed = seed.wrapping_add(u64::from(index).wrapping_mul(OCTAVE_SEED));
            let mut rng = Pcg64Mcg::seed_from_u64(seed);
            let axes = turned(&mut rng);
            let shift = std::array::from_fn(|_| rng.random::<f64>());
            Octave { side: size * weight, axes, shift, weight, seed }
        };
        let octaves: Vec<Octave> = (0..octaves.max(1)).map(octave).collect();
        let squares: f64 = octaves.iter().map(|octave| octave.weight * octave.weight).sum();
        Self { octaves, spread: DEVIATION / (RAW * squares.sqrt()) }
    }

    /// The noise at a point.
    #[must_use]
    pub fn at(&self, point: [f64; 3]) -> f64 {
        let sum: f64 = self.octaves.iter().map(|octave| octave.weight * octave.at(point)).sum();
        (0.5 + self.spread * sum).clamp(0.0, 1.0)
    }
}

/// A random rotation: Shoemake, "Uniform random rotations", Graphics Gems III (1992).
fn turned(rng: &mut Pcg64Mcg) -> [[f64; 3]; 3] {
    let [share, first, second] = std::array::from_fn(|_| rng.random::<f64>());
    let [a, b] = [(1.0 - share).sqrt(), share.sqrt()];
    let (sin, cos) = libm::sincos(std::f64::consts::TAU * first);
    let (sine, cosine) = libm::sincos(std::f64::consts::TAU * second);
    let [x, y, z, w] = [a * sin, a * cos, b * sine, b * cosine];
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

impl Octave {
    /// −1..1.
    fn at(&self, point: [f64; 3]) -> f64 {
        let at: [f64; 3] = std::array::from_fn(|axis| {
            (0..3).map(|i| self.axes[axis][i] * point[i]).sum::<f64>() / self.side + self.shift[axis]
        });
        let corner = at.map(f64::floor);
        let within: [f64; 3] = std::array::from_fn(|axis| at[axis] - corner[axis]);
        let fade = within.map(|t| t * t * t * (t * (6.0 * t - 15.0) + 10.0));
        let corner = corner.map(|value| value as i64);
        let mut sum = 0.0;
        for k in 0..8_usize {
            let side: [usize; 3] = std::array::from_fn(|axis| (k >> axis) & 1);
            let weight: f64 =
                (0..3).map(|axis| if side[axis] == 1 { fade[axis] } else { 1.0 - fade[axis] }).product();
            let from: [f64; 3] = std::array::from_fn(|axis| within[axis] - side[axis] as f64);
            let node = std::array::from_fn(|axis| corner[axis] + side[axis] as i64);
            sum += weight * self.slope(node, from);
        }
        sum
    }

    /// The rise along `from` by the gradient at a node.
    fn slope(&self, node: [i64; 3], [x, y, z]: [f64; 3]) -> f64 {
        let mixed = node.iter().fold(self.seed, |hash, part| {
            let hash = (hash ^ *part as u64).wrapping_mul(0xFF51_AFD7_ED55_8CCD);
            (hash ^ (hash >> 33)).wrapping_mul(0xC4CE_B9FE_1A85_EC53)
        });
        let hash = (mixed ^ (mixed >> 29)) % 12;
        let [a, b] = [[x, y], [y, z], [z, x]][(hash / 4) as usize];
        let a = if hash & 1 == 0 { a } else { -a };
        if hash & 2 == 0 { a + b } else { a - b }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(noise: &SolidNoise) -> Vec<f64> {
        // Points of a lattice that has nothing to do with that of the noise.
        let part = |k: usize, step: f64| 37.0 * (k as f64 * step).fract();
        (0..40_000)
            .map(|k| noise.at([part(k, 0.819_172_5), part(k, 0.671_043_6), part(k, 0.549_700_5)]))
            .collect()
    }

    #[test]
    fn noise_is_spread_as_that_of_canvases_whatever_its_octaves() {
        for octaves in [1, 2, 5] {
            let values = values(&SolidNoise::new(1.3, octaves, 4));
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let squares = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>();
            let deviation = (squares / values.len() as f64).sqrt();
            assert!(
                (mean - 0.5).abs() < 0.02 && (deviation - DEVIATION).abs() < 0.02,
                "{octaves}: {mean} {deviation}"
            );
        }
    }

    #[test]
    fn noise_is_smooth_and_differs_by_seed() {
        let [first, second] = [1, 2].map(|seed| SolidNoise::new(10.0, 1, seed));
        let step = |noise: &SolidNoise, by: f64| {
            let pairs = (0..2_000).map(|k| [0.77 * f64::from(k), 0.31 * f64::from(k), 5.0]);
            let off = |at: [f64; 3]| (noise.at([at[0] + by, at[1], at[2]]) - noise.at(at)).abs();
            pairs.map(off).sum::<f64>() / 2_000.0
        };
        assert!(
            step(&first, 0.1) < 0.012 && step(&first, 10.0) > 0.12,
            "{} {}",
            step(&first, 0.1),
            step(&first, 10.0)
        );
        assert!(first.at([3.3, 1.0, 2.0]) != second.at([3.3, 1.0, 2.0]));
    }
}
