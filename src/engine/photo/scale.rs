//! The size of the marks of a picture: the scale at which it varies most.
//!
//! D_σ = G_{kσ} ∗ c − G_σ ∗ c is nearly (k − 1)·σ²·∇²G_σ ∗ c, which responds most to a wave of the length λ = √2·π·σ. The scale is
//! the highest peak of the mean of D² over the picture, as a function of σ. Noise of single px and light that falls off have no
//! peak: their values are largest at the ends.
//!
//! T. Lindeberg, "Feature detection with automatic scale selection", IJCV 30 (1998), section 3.

use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// λ ÷ σ at the peak: √2·π.
const WAVELENGTH: f64 = std::f64::consts::SQRT_2 * std::f64::consts::PI;
/// The finest blur of an octave, cells. For a finer one the cells are too coarse for a Gaussian.
const SIGMA: f64 = 1.2;
/// Blurs per octave. Peaks of textures are at least an octave wide.
const STEPS: usize = 4;
/// Coarsest σ, as a share of the shorter side: for three wavelengths along it.
const COARSEST: f64 = 1.0 / (3.0 * WAVELENGTH);

/// The dominant wavelength of a channel on `size` cells, cells; if there is no peak, that of the largest value.
#[must_use]
pub fn wavelength(channel: &[f32], size: [usize; 2]) -> f64 {
    let scales = energies(channel, size);
    let inner = 1..scales.len().saturating_sub(1);
    let peaks = inner.filter(|k| scales[*k].1 >= scales[k - 1].1 && scales[*k].1 >= scales[k + 1].1);
    let highest = |a: &usize, b: &usize| scales[*a].1.total_cmp(&scales[*b].1);
    let Some(peak) = peaks.max_by(highest) else {
        let strongest = scales.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        return WAVELENGTH * strongest.map_or(SIGMA, |(sigma, _)| *sigma);
    };
    // The vertex of the parabola through the peak and its neighbours, over log σ.
    let [low, top, high] = [peak - 1, peak, peak + 1].map(|k| scales[k].1);
    let bend = low - 2.0 * top + high;
    let shift = if bend < 0.0 { 0.5 * (low - high) / bend } else { 0.0 };
    WAVELENGTH * scales[peak].0 * libm::exp2(shift / STEPS as f64)
}

/// (σ, mean of D_σ²), ascending.
fn energies(channel: &[f32], size: [usize; 2]) -> Vec<(f64, f64)> {
    let ratio = libm::exp2(1.0 / STEPS as f64);
    let coarsest = COARSEST * size[0].min(size[1]) as f64;
    let (mut scales, mut octave) = (Vec::new(), 1.0);
    let (mut size, mut finest) = (size, gaussian(channel, size, SIGMA, Edges::Closed));
    while octave * SIGMA <= coarsest && size.iter().all(|side| *side >= 8) {
        let mut before = finest.clone();
        let mut sigma = SIGMA;
        for _ in 0..STEPS {
            let next = sigma * ratio;
            let blurred = gaussian(&before, size, (next * next - sigma * sigma).sqrt(), Edges::Closed);
            let square = |(a, b): (&f32, &f32)| f64::from(a - b) * f64::from(a - b);
            let energy = before.iter().zip(&blurred).map(square).sum::<f64>() / before.len() as f64;
            scales.push((octave * sigma * ratio.sqrt(), energy));
            (before, sigma) = (blurred, next);
        }
        // Twice the blur on half as many cells is an equal blur.
        (finest, size) = halved(&before, size);
        octave *= 2.0;
    }
    scales
}

/// Every second cell.
fn halved(values: &[f32], [width, height]: [usize; 2]) -> (Vec<f32>, [usize; 2]) {
    let rows = (0..height).step_by(2);
    let half = rows.flat_map(|y| values[y * width..(y + 1) * width].iter().step_by(2).copied()).collect();
    (half, [width.div_ceil(2), height.div_ceil(2)])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(size: [usize; 2], value: impl Fn(f64, f64) -> f64) -> Vec<f32> {
        let cell = |k: usize| value((k % size[0]) as f64, (k / size[0]) as f64) as f32;
        (0..size[0] * size[1]).map(cell).collect()
    }

    #[test]
    fn a_wave_has_its_own_length_in_noise_and_falling_light_too() {
        for length in [12.0, 23.0, 40.0] {
            let size = [200, 160];
            let noise =
                |x: f64, y: f64| ((x * 12.9898 + y * 78.233).sin() * 43758.5453).rem_euclid(1.0) - 0.5;
            let wave = |x: f64, y: f64| (std::f64::consts::TAU * (0.6 * x + 0.8 * y) / length).sin();
            let found = wavelength(&picture(size, |x, y| wave(x, y) + 0.5 * noise(x, y) + 0.02 * x), size);
            assert!((found / length - 1.0).abs() < 0.1, "{length}: {found}");
        }
    }
}
