//! Noise and turbulence without a lattice: random values at Poisson discs (the paper's figures 6–8).
//!
//! ```text
//! T = Σᵢ 2⁻ⁱ·Pᵢ,  i = 0 … octaves − 1        eq. 5; Pᵢ from discs of radius r·2⁻ⁱ with random values
//! P′ = 2·|P − ½|                            folded: turbulence
//! ```
//! divided by Σ 2⁻ⁱ, so that the values stay within 0..1.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::delaunay::Delaunay;
use super::discs::poisson_discs;
use super::extent::Extent;
use super::interpolation::{Weights, interpolate};
use super::metric::Metric;
use crate::grid::{Field, Grid};

/// Noise over a canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Radius of the discs of the first octave, px: roughly the distance from a light place to the next dark one.
    pub radius: f64,
    /// Octaves, 1–[`Noise::MOST_OCTAVES`], each with half the radius and half the weight of the previous one.
    pub octaves: u32,
    /// Whether each octave is folded at its mean value.
    pub fold: bool,
    /// Seed of points and values.
    pub seed: u64,
}

impl Noise {
    /// An eighth octave has 1/128 of the weight of the first: less than half a step of an 8-bit picture.
    pub const MOST_OCTAVES: u32 = 8;
    /// Octaves with smaller discs, in cells, are left out: a cell would show the mean of several.
    const FINEST: f64 = 1.0;

    /// The noise on the cells of `grid`, 0..1.
    #[must_use]
    pub fn field(&self, grid: &Grid) -> Field {
        let extent = Extent::from(grid.bounds_px());
        let (mut sum, mut total) = (vec![0.0f32; grid.size[0] * grid.size[1]], 0.0);
        for octave in 0..self.octaves.clamp(1, Self::MOST_OCTAVES) {
            let share = 0.5f32.powi(octave as i32);
            let radius = self.radius * f64::from(share);
            if octave > 0 && radius < Self::FINEST * grid.px_a_cell() {
                break;
            }
            let seed = self.seed.wrapping_add(u64::from(octave).wrapping_mul(OCTAVE_SEED));
            let mut rng = Pcg64Mcg::seed_from_u64(seed);
            let points = poisson_discs(&extent, MARGIN * radius, &|_| Metric::circle(radius), &[], &mut rng);
            let values: Vec<f32> = points.iter().map(|_| rng.random()).collect();
            let field = interpolate(&Delaunay::new(&points, extent), &values, grid, &Weights::default());
            for (sum, value) in sum.iter_mut().zip(&field.values) {
                *sum += share * if self.fold { 2.0 * (value - 0.5).abs() } else { *value };
            }
            total += share;
        }
        sum.iter_mut().for_each(|value| *value /= total);
        Field::new(grid, sum)
    }
}

/// Difference between the seeds of successive octaves; an odd number, so that none repeats (2⁶⁴ ÷ the golden ratio).
const OCTAVE_SEED: u64 = 0x9E37_79B9_7F4A_7C15;
/// Width of the frame beyond a border that does not wrap, in radii: a place on the canvas is in supports of at most 2 radii, and
/// the neighbours of their points are 2 farther.
const MARGIN: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    fn moments(field: &Field) -> (f64, f64) {
        let n = field.values.len() as f64;
        let mean = field.values.iter().map(|value| f64::from(*value)).sum::<f64>() / n;
        let square = field.values.iter().map(|value| (f64::from(*value) - mean).powi(2)).sum::<f64>() / n;
        (mean, square.sqrt())
    }

    /// Correlation of the values at a distance of `away` px along x.
    fn correlation(field: &Field, away: usize) -> f64 {
        let (mean, deviation) = moments(field);
        let pairs = (0..field.height).flat_map(|y| (0..field.width).map(move |x| (x as isize, y as isize)));
        let product = |(x, y)| {
            (f64::from(field.get(x, y)) - mean) * (f64::from(field.get(x + away as isize, y)) - mean)
        };
        pairs.map(product).sum::<f64>() / field.values.len() as f64 / (deviation * deviation)
    }

    #[test]
    fn noise_is_correlated_within_a_radius_and_not_beyond_two() {
        for radius in [8.0, 16.0] {
            let grid = Grid::unit([256, 256], Edges::Wrap);
            let field = Noise { radius, octaves: 1, fold: false, seed: 3 }.field(&grid);
            let [near, far] = [0.3, 2.2].map(|radii| correlation(&field, (radii * radius) as usize));
            assert!(near > 0.8 && far.abs() < 0.15, "{radius}: {near}, {far}");
            let (mean, deviation) = moments(&field);
            assert!((mean - 0.5).abs() < 0.06 && (deviation - 0.22).abs() < 0.03, "{mean}, {deviation}");
        }
    }

    #[test]
    fn octaves_add_fine_detail_and_folding_makes_the_mean_the_minimum() {
        let grid = Grid::unit([128, 128], Edges::Wrap);
        let noise = Noise { radius: 16.0, octaves: 1, fold: false, seed: 3 };
        let steps = |octaves| correlation(&Noise { octaves, ..noise }.field(&grid), 3);
        assert!(steps(4) < steps(1) - 0.03, "{}, {}", steps(4), steps(1));
        let (plain, folded) = (noise.field(&grid), Noise { fold: true, ..noise }.field(&grid));
        for (plain, folded) in plain.values.iter().zip(&folded.values) {
            assert!((folded - 2.0 * (plain - 0.5).abs()).abs() < 1e-6);
        }
        let seeds = [1, 2].map(|seed| Noise { seed, ..noise }.field(&grid));
        assert!(seeds[0] != seeds[1] && seeds[0] == Noise { seed: 1, ..noise }.field(&grid));
    }
}
