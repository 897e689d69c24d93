//! Irregular spots: the decay of a chemical varies in space, at the scale of the pattern.
//!
//! δ(x) = Σᵢ ±w(|x − xᵢ|/ρᵢ), w(r) = (1 − r²)², ρᵢ a share of the distance between spots at xᵢ: noise by sparse
//! convolution (Lewis, "Algorithms for solid noise synthesis", SIGGRAPH 1989), as smooth as its kernel and of unit
//! variance. It is added to the decay. White noise, one value for each cell, would average out over large spots (`facts.md` G).

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::grid::{Domain, Space};
use crate::rd::definition::{DecayNoise, System};
use crate::rd::parameter_field::ParameterField;

/// Radius of a kernel ÷ distance between spots. Its half width is that of noise blurred by 0.075 of a wavelength.
const RADIUS: f64 = 0.2;
/// Number of kernels in a squared radius.
const DENSITY: f64 = 2.5;
/// A kernel.
struct Bump<P> {
    at: P,
    radius: f64,
    sign: f64,
}

impl<D: Domain> ParameterField<D> {
    /// These maps for spots of `system` that are `irregular`, from 0 (not at all) to 1, with an unchanged mean area. Without effect
    /// on a system that has no irregular spots.
    #[must_use]
    pub fn with_decay_noise(mut self, system: System, irregular: f64, seed: u64) -> Self {
        if let Some(DecayNoise { deviation, rate }) = system.definition().decay_noise
            && irregular > 0.0
        {
            self.decay_noise = noise(system, &self, seed);
            self.decay_noise.iter_mut().for_each(|value| *value *= (deviation * irregular) as f32);
            let more = 1.0 + rate * irregular * irregular;
            self.parameters.iter_mut().for_each(|p| p.rate *= more as f32);
        }
        self
    }
}

/// Noise over the domain, by cell, of about unit variance.
fn noise<D: Domain>(system: System, maps: &ParameterField<D>, seed: u64) -> Vec<f32> {
    let bumps = random_kernels(system, maps, seed);
    let mut sum = vec![0.0f32; maps.domain.cells()];
    // Each part sums all kernels in order, so that the sums do not depend on the number of threads.
    let part = maps.domain.part();
    sum.par_chunks_mut(part).enumerate().for_each(|(index, sum)| {
        let first = index * part;
        for bump in &bumps {
            maps.domain.near(bump.at, bump.radius, first..first + sum.len()).for_each(|(cell, [dx, dy])| {
                let window = (1.0 - (dx * dx + dy * dy) / (bump.radius * bump.radius)).max(0.0);
                sum[cell - first] += (bump.sign * window * window) as f32;
            });
        }
    });
    // ∫ w² = π/5 ρ², times DENSITY/ρ².
    let deviation = (std::f64::consts::PI / 5.0 * DENSITY).sqrt() as f32;
    sum.iter_mut().for_each(|value| *value /= deviation);
    sum
}

/// The kernels. They are placed at random with the highest density, and each is kept with the probability local density ÷ highest
/// density.
fn random_kernels<D: Domain>(system: System, maps: &ParameterField<D>, seed: u64) -> Vec<Bump<D::Place>> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let radii: Vec<f64> = maps.parameters.iter().map(|p| RADIUS * system.spacing(p)).collect();
    let least = radii.iter().copied().fold(f64::INFINITY, f64::min);
    // Kernels are also placed in a margin beyond closed edges, so that the noise does not fade there.
    let space = maps.domain.space(radii.iter().copied().fold(0.0, f64::max));
    let throws = (space.points(DENSITY) / (least * least)).ceil() as usize;
    let mut bumps = Vec::new();
    for _ in 0..throws {
        let at = space.to_domain(space.random(&mut rng));
        let (keep, sign) = (rng.random::<f64>(), if rng.random::<bool>() { 1.0 } else { -1.0 });
        let radius = radii[maps.domain.cell_at(at)];
        if keep * radius * radius <= least * least {
            bumps.push(Bump { at, radius, sign });
        }
    }
    bumps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::parameter_field::Parameters;

    fn maps(rate: f32, edges: Edges) -> ParameterField {
        ParameterField::uniform(
            [120, 100],
            edges,
            Parameters { rate, ratio: 1.0, stretch: 1.0, direction: 0.0, pitch: 1.0 },
        )
    }

    #[test]
    fn noise_has_unit_variance_and_zero_mean_for_spots_of_any_size() {
        for rate in [0.3, 0.1, 0.03] {
            for edges in [Edges::Closed, Edges::Wrap] {
                let noise = noise(System::TURING_SPOTS, &maps(rate, edges), 3);
                let mean = noise.iter().sum::<f32>() / noise.len() as f32;
                let variance = noise.iter().map(|v| v * v).sum::<f32>() / noise.len() as f32;
                assert!(mean.abs() < 0.2 && (variance - 1.0).abs() < 0.15, "{rate}: {mean}, {variance}");
            }
        }
    }

    #[test]
    fn a_coarser_grid_has_the_means_of_the_finer_cells() {
        let fine = maps(0.1, Edges::Closed).with_decay_noise(System::TURING_SPOTS, 1.0, 5);
        let coarse = fine.on_grid([60, 50]);
        for (cell, value) in coarse.decay_noise.iter().enumerate() {
            let first = 2 * (cell / 60) * 120 + 2 * (cell % 60);
            let mean = [0, 1, 120, 121].map(|more| fine.decay_noise[first + more]).iter().sum::<f32>() / 4.0;
            assert!((value - mean).abs() < 1e-5, "{cell}: {value}, {mean}");
        }
        assert!(
            maps(0.1, Edges::Closed)
                .with_decay_noise(System::TURING_SPOTS, 0.0, 5)
                .on_grid([60, 50])
                .decay_noise
                .is_empty()
        );
    }

    #[test]
    fn the_number_of_threads_changes_no_bit() {
        let grown = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| noise(System::TURING_SPOTS, &maps(0.1, Edges::Wrap), 9))
        };
        assert!(grown(1) == grown(4));
    }
}
