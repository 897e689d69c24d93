//! Where stripes begin: noise that already has the wavelength and the direction of the stripes.
//!
//! n(x) = Σᵢ (1 − r²)² cos(2π (x − xᵢ)·nᵢ/λᵢ + φᵢ), r² = (along/A)² + (across/B)², with the direction of the
//! stripes along and nᵢ across: sparse convolution with oriented waves.
//! Lagae et al., "Procedural noise using sparse Gabor convolution", SIGGRAPH 2009; its Gaussian window is
//! replaced by a polynomial of compact support.

use rand::{Rng, RngExt};

use super::maps::{Maps, Parameters};
use crate::field::Edges;

/// A and B, the kernel's reach along and across the stripes, in wavelengths. Longer kernels make longer stripes
/// with fewer forks, but follow turning directions worse.
const REACH: [f64; 2] = [4.0, 1.8];
/// Kernels a square wavelength; fewer leave gaps.
const DENSITY: f64 = 2.0;

/// Noise over the grid, row by row, of about unit variance.
pub fn noise(
    maps: &Maps,
    edges: Edges,
    wavelength: &dyn Fn(&Parameters) -> f64,
    rng: &mut impl Rng,
) -> Vec<f32> {
    let (nx, ny) = (maps.nx, maps.ny);
    let mut sum = vec![0.0f32; nx * ny];
    let densities: Vec<f64> =
        maps.parameters.iter().map(|p| DENSITY / (wavelength(p) * wavelength(p))).collect();
    let densest = densities.iter().copied().fold(0.0, f64::max);
    // Thrown over a frame beyond closed borders too, so that the noise does not fade there.
    let frame = match edges {
        Edges::Wrap => 0.0,
        Edges::Closed => REACH[0] * maps.parameters.iter().map(wavelength).fold(0.0, f64::max),
    };
    let (w, h) = (nx as f64 + 2.0 * frame, ny as f64 + 2.0 * frame);
    let throws = (densest * w * h).ceil() as usize;
    for _ in 0..throws {
        let at = [rng.random::<f64>() * w - frame, rng.random::<f64>() * h - frame];
        let (keep, phase) = (rng.random::<f64>(), rng.random::<f64>());
        let p = maps.at(at);
        let length = wavelength(&p);
        if keep * densest <= DENSITY / (length * length) {
            splat(&mut sum, [nx, ny], edges, at, &p, length, phase);
        }
    }
    // ∫ window² cos² = ½ (π/5) A·B, times DENSITY/λ².
    let deviation = (0.5 * std::f64::consts::PI / 5.0 * REACH[0] * REACH[1] * DENSITY).sqrt() as f32;
    for n in &mut sum {
        *n /= deviation;
    }
    sum
}

fn splat(
    sum: &mut [f32],
    [nx, ny]: [usize; 2],
    edges: Edges,
    at: [f64; 2],
    p: &Parameters,
    length: f64,
    phase: f64,
) {
    use std::f64::consts::TAU;
    let [far, near] = REACH.map(|reach| reach * length);
    let across = (f64::from(p.direction) + 90.0).to_radians();
    let n = [libm::cos(across), libm::sin(across)];
    let (kx, ky) = (TAU / length * n[0], TAU / length * n[1]);
    let range = |v: f64| (v - far).ceil() as isize..=(v + far).floor() as isize;
    // cos(α + x·kx) along a row by the angle-sum rule: two multiplications instead of a cosine a cell.
    let (cos_step, sin_step) = (libm::cos(kx), libm::sin(kx));
    for y in range(at[1] - 0.5) {
        let inside_y = edges == Edges::Wrap || (0..ny as isize).contains(&y);
        if !inside_y {
            continue;
        }
        let dy = y as f64 + 0.5 - at[1];
        let row = edges.index(y, ny) * nx;
        let columns = range(at[0] - 0.5);
        let dx = *columns.start() as f64 + 0.5 - at[0];
        let start = TAU * phase + dx * kx + dy * ky;
        let (mut c, mut s) = (libm::cos(start), libm::sin(start));
        for x in columns {
            let dx = x as f64 + 0.5 - at[0];
            let (along, across) = (dx * n[1] - dy * n[0], dx * n[0] + dy * n[1]);
            let window = 1.0 - along * along / (far * far) - across * across / (near * near);
            if window > 0.0 && (edges == Edges::Wrap || (0..nx as isize).contains(&x)) {
                sum[row + edges.index(x, nx)] += (window * window * c) as f32;
            }
            (c, s) = (c * cos_step - s * sin_step, s * cos_step + c * sin_step);
        }
    }
}
