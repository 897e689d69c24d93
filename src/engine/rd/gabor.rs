//! Initial noise of stripes, with their wavelength and direction.
//!
//! n(x) = Σᵢ (1 − r²)² cos(2π (x − xᵢ)·nᵢ/λᵢ + φᵢ), r² = (along/A)² + (across/B)², with the direction of the
//! stripes along and nᵢ across: sparse convolution with oriented waves.
//! Lagae et al., "Procedural noise using sparse Gabor convolution", SIGGRAPH 2009; its Gaussian window is
//! replaced by a polynomial of compact support.

use std::ops::Range;

use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::gabor_wave::{Wave, across, add};
use super::parameter_field::{ParameterField, Parameters};
use crate::grid::resample::resample;
use crate::grid::{Domain, Edges, Field, Grid, atan2};
use crate::rd::line_noise::{Guide, GuideLine, Led, Reach, Wavelength};

/// The kernels of the noise.
#[derive(Clone, Copy, Debug)]
pub struct Kernels {
    /// A and B, their reach along and across the stripes, in wavelengths. Longer kernels give longer stripes with fewer
    /// forks, but follow changes of direction less closely.
    pub reach: [f64; 2],
    /// Kernels in a square wavelength; fewer leave gaps.
    pub density: f64,
}

/// Amplitude of the waves along guide lines in [`phases`]; the standard deviation of the noise is 2.5.
pub(super) const LEADING: f64 = 4.0;

/// Rows that are summed at once.
const ROWS_A_BAND: usize = 32;

/// Length of the shortest wave, in cells of the grid on which noise is summed. Interpolated from there, its error is below a twentieth
/// of its standard deviation.
const CELLS_A_WAVE: f64 = 5.0;

/// Noise over the grid, row by row, of about unit variance.
pub fn noise(
    maps: &ParameterField,
    wavelength: Wavelength,
    kernels: Kernels,
    rng: &mut impl Rng,
) -> Vec<f32> {
    noise_from(maps, wavelength, kernels, CELLS_A_WAVE, rng)
}

/// Noise over the grid of `maps`, row by row, of about unit variance. It is summed on a grid on which the shortest wave is
/// `cells` long, if that is coarser.
fn noise_from(
    maps: &ParameterField,
    wavelength: Wavelength,
    kernels: Kernels,
    cells: f64,
    rng: &mut impl Rng,
) -> Vec<f32> {
    let (grid, waves) = waves(maps, wavelength, kernels, cells, rng);
    let mut sum = vec![0.0f32; grid.cells()];
    // Each band sums all waves in order, so that the sums do not depend on the number of threads.
    sum.par_chunks_mut(ROWS_A_BAND * grid.size[0]).enumerate().for_each(|(band, sum)| {
        for wave in &waves {
            add(wave, rows(band, sum.len(), &grid), &grid, |cells, cos, _| {
                sum[cells].iter_mut().zip(cos).for_each(|(sum, cos)| *sum += *cos);
            });
        }
    });
    // ∫ window² cos² = ½ (π/5) A·B, times density/λ².
    let Kernels { reach: [a, b], density } = kernels;
    let deviation = (0.5 * std::f64::consts::PI / 5.0 * a * b * density).sqrt() as f32;
    for n in &mut sum {
        *n /= deviation;
    }
    let [nx, ny] = maps.domain.size;
    resample(&Field::new(&grid, sum), nx, ny).values
}

/// The phase of [`noise`] over the grid, row by row, −π..π: 0 along a crest, however low the noise is there. Crests at phase 0 have
/// one height, and end only where two waves cancel each other.
///
/// φ(x) = atan2(Σᵢ ±(1 − r²)² sin(…), Σᵢ (1 − r²)² cos(…)): Tricard et al., "Procedural phasor noise", SIGGRAPH 2019.
/// The direction of a wave is axial, nᵢ and −nᵢ are equivalent: ± chooses the one closer to the direction at the place, so
/// the sign of the phase has no meaning. The phase follows `lines` within `reach`.
pub fn phases(
    maps: &ParameterField,
    wavelength: Wavelength,
    kernels: Kernels,
    (lines, reach): (&[GuideLine], Reach),
    rng: &mut impl Rng,
) -> Vec<f32> {
    let (_, waves) = waves(maps, wavelength, kernels, f64::INFINITY, rng);
    let guide = Guide::new(maps, lines, wavelength, reach);
    let mut phases = vec![0.0f32; maps.domain.cells()];
    phases.par_chunks_mut(ROWS_A_BAND * maps.domain.size[0]).enumerate().for_each(|(band, phases)| {
        let rows = rows(band, phases.len(), &maps.domain);
        let first = rows.start as usize * maps.domain.size[0];
        let own = &maps.parameters[first..first + phases.len()];
        let own: Vec<[f64; 2]> = own.iter().map(across).collect();
        let mut sums = vec![[0.0f64; 2]; phases.len()];
        for wave in &waves {
            add(wave, rows.clone(), &maps.domain, |cells, cos, sin| {
                let own = &own[cells.clone()];
                for ((sum, own), (cos, sin)) in sums[cells].iter_mut().zip(own).zip(cos.iter().zip(sin)) {
                    let same = own[0] * wave.n[0] + own[1] * wave.n[1] >= 0.0;
                    sum[0] += f64::from(*cos);
                    sum[1] += f64::from(if same { *sin } else { -sin });
                }
            });
        }
        for (cell, (phase, [cos, sin])) in phases.iter_mut().zip(sums).enumerate() {
            let Led { share, wave } = guide.led(first + cell, own[cell]);
            let [cos, sin] =
                [(cos, wave[0]), (sin, wave[1])].map(|(noise, wave)| (1.0 - share) * noise + LEADING * wave);
            *phase = atan2(sin, cos) as f32;
        }
    });
    phases
}

/// The rows of a band of `cells` cells.
fn rows(band: usize, cells: usize, grid: &Grid) -> Range<isize> {
    let first = band * ROWS_A_BAND;
    first as isize..(first + cells / grid.size[0]) as isize
}

/// Shortest wavelength, cells. Shorter waves are replaced by waves of this length: a grid does not show them, and their number
/// grows as they get shorter.
const SHORTEST: f64 = 1.0;

/// The wavelength of each cell.
fn lengths(maps: &ParameterField, wavelength: Wavelength) -> Vec<f64> {
    let part = |part: &[Parameters]| {
        let mut before: Option<(Parameters, f64)> = None;
        let of = |p: &Parameters| {
            // Neighbours mostly have equal wavelengths.
            let length = match before {
                Some((same, length)) if same == *p => length,
                _ => wavelength(p).max(SHORTEST),
            };
            before = Some((*p, length));
            length
        };
        part.iter().map(of).collect::<Vec<_>>()
    };
    let parts: Vec<Vec<f64>> = maps.parameters.par_chunks(maps.domain.part()).map(part).collect();
    parts.concat()
}

/// Waves at random places, in the cells of a grid on which the shortest wave is `cells` long, if that grid is coarser than that of
/// `maps`.
fn waves(
    maps: &ParameterField,
    wavelength: Wavelength,
    Kernels { reach, density }: Kernels,
    cells: f64,
    rng: &mut impl Rng,
) -> (Grid, Vec<Wave>) {
    let [nx, ny] = maps.domain.size;
    let lengths = lengths(maps, wavelength);
    let coarser = (lengths.iter().copied().fold(f64::INFINITY, f64::min) / cells).max(1.0);
    let size = maps.domain.size.map(|side| (side as f64 / coarser).ceil() as usize);
    let scale = [0, 1].map(|axis| maps.domain.size[axis] as f64 / size[axis] as f64);
    let densest = lengths.iter().map(|length| density / (length * length)).fold(0.0, f64::max);
    // Waves are also placed in a frame beyond closed edges, so that the noise does not fade there.
    let frame = match maps.domain.edges {
        Edges::Wrap => 0.0,
        Edges::Closed => reach[0] * lengths.iter().copied().fold(0.0, f64::max),
    };
    let (w, h) = (nx as f64 + 2.0 * frame, ny as f64 + 2.0 * frame);
    let throws = (densest * w * h).ceil() as usize;
    let mut waves = Vec::new();
    for _ in 0..throws {
        let at = [rng.random::<f64>() * w - frame, rng.random::<f64>() * h - frame];
        let (keep, phase) = (rng.random::<f64>(), rng.random::<f64>());
        let p = maps.at(at);
        let length = lengths[maps.domain.cell_at(at)];
        if keep * densest <= density / (length * length) {
            waves.push(Wave::new(at, &p, reach.map(|reach| reach * length), length, phase, scale));
        }
    }
    (Grid::unit(size, maps.domain.edges), waves)
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const KERNELS: Kernels = Kernels { reach: [8.0, 4.0], density: 0.6 };
    const REACH: Reach = Reach { beyond: [0.0, 4.0], across: [0.4, 3.0] };

    /// Crests that each column of a grid crosses, relative to waves of 10 cells along x, where directions change from `left` to
    /// `right` degrees.
    fn crossed(left: f32, right: f32) -> f64 {
        const N: usize = 160;
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 0.0, pitch: 1.0 };
        let mut maps = ParameterField::uniform([N, N], Edges::Closed, p);
        for (cell, p) in maps.parameters.iter_mut().enumerate() {
            let share = (cell % N) as f32 / N as f32;
            // Directions of parameters are from 0 to 180.
            p.direction = (left + share * (right - left)).rem_euclid(180.0);
        }
        let phases = phases(&maps, &|_| 10.0, KERNELS, (&[], REACH), &mut Pcg64Mcg::seed_from_u64(1));
        let crest = |cell: usize| phases[cell].abs() < 0.8;
        let begins = (N..N * N).filter(|cell| crest(*cell) && !crest(cell - N)).count();
        begins as f64 / (N * N) as f64 * 10.0
    }

    #[test]
    fn crests_are_one_wavelength_apart_also_where_directions_wrap_from_180_to_0_degrees() {
        for (left, right) in [(30.0, 20.0), (5.0, -5.0), (176.0, 190.0)] {
            // Along y, waves at 25° are 1/cos 25° = 1.1 times as long.
            let share = crossed(left, right);
            assert!((0.82..1.08).contains(&share), "{left}° to {right}°: {share}");
        }
    }

    #[test]
    fn waves_far_shorter_than_a_cell_are_as_many_as_those_of_a_cell() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 33.0, pitch: 1.0 };
        let maps = ParameterField::uniform([20, 20], Edges::Wrap, p);
        let (_, waves) = waves(&maps, &|_| 1e-6, KERNELS, CELLS_A_WAVE, &mut Pcg64Mcg::seed_from_u64(2));
        assert_eq!(waves.len(), 240);
    }

    #[test]
    fn the_number_of_threads_changes_no_phase() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 33.0, pitch: 1.0 };
        let maps = ParameterField::uniform([90, 70], Edges::Wrap, p);
        let phases = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| phases(&maps, &|_| 9.0, KERNELS, (&[], REACH), &mut Pcg64Mcg::seed_from_u64(2)))
        };
        assert!(phases(1) == phases(4));
    }

    #[test]
    fn noise_from_a_coarser_grid_is_that_of_each_cell() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 33.0, pitch: 1.0 };
        for edges in [Edges::Closed, Edges::Wrap] {
            let mut maps = ParameterField::uniform([131, 90], edges, p);
            let turned = maps.parameters.iter_mut().enumerate();
            turned.for_each(|(cell, p)| p.direction = 33.0 + 60.0 * (cell % 131) as f32 / 131.0);
            let noise =
                |cells: f64| noise_from(&maps, &|_| 12.0, KERNELS, cells, &mut Pcg64Mcg::seed_from_u64(3));
            let (exact, coarse) = (noise(f64::INFINITY), noise(CELLS_A_WAVE));
            let rms = |values: &mut dyn Iterator<Item = f32>| {
                (values.map(|value| value * value).sum::<f32>() / exact.len() as f32).sqrt()
            };
            let deviation = rms(&mut exact.iter().copied());
            let error = rms(&mut exact.iter().zip(&coarse).map(|(a, b)| a - b));
            assert!(
                (0.8..1.2).contains(&deviation) && error < 0.05 * deviation,
                "{edges:?}: {error} of {deviation}"
            );
        }
    }
}
