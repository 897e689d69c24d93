//! The steepness of a relief at its thresholds: where it is flat, edges would be blurred.
//!
//! Lines end and fork at saddles of the relief. If the threshold of a px is the height of a saddle, the pattern stays near ½ over a
//! third of a wavelength, and colours that change at the edge give a gray area there. Stretching the heights about the threshold
//! keeps the edge in place and makes it as narrow as other edges:
//!
//! ```text
//! s² = G_σ * |∇(u − l)|²,  gain = FLAT · usual s ÷ s, in [1, MOST]
//! pattern = cut(l + gain · (u − l))
//! ```

use rayon::prelude::*;

use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// σ of the surroundings whose slopes are averaged, wavelengths: narrower than a line.
const AROUND: f64 = 0.1;
/// Heights are stretched where slopes are smaller than this share of the usual ones. The slopes of waves are 0.5 of their mean
/// halfway from the edges of lines of equal width to their middle.
const FLAT: f32 = 0.7;
/// Largest gain: a flatter saddle has no visible edge.
const MOST: f32 = 40.0;
/// Stride of the px that are sorted for the usual slope.
const STRIDE: usize = 7;

/// Factors by which heights `u` about their thresholds (`levels`) are stretched at each of `size` px, with `wavelength` px from
/// mark to mark.
#[must_use]
pub fn gains(u: &[f32], levels: &[f32], size: [usize; 2], wavelength: f64, edges: Edges) -> Vec<f32> {
    let [width, height] = size;
    let above = |x: isize, y: isize| {
        let px = edges.index(y, height) * width + edges.index(x, width);
        u[px] - levels[px]
    };
    let square = |px: usize| {
        let [x, y] = [px % width, px / width].map(|k| k as isize);
        let [dx, dy] = [above(x + 1, y) - above(x - 1, y), above(x, y + 1) - above(x, y - 1)];
        dx * dx + dy * dy
    };
    let squares: Vec<f32> = (0..u.len()).into_par_iter().map(square).collect();
    let mut slopes = gaussian(&squares, size, AROUND * wavelength, edges);
    slopes.par_iter_mut().for_each(|square| *square = square.max(0.0).sqrt());
    let mut sorted: Vec<f32> = slopes.iter().copied().step_by(STRIDE).collect();
    sorted.sort_unstable_by(f32::total_cmp);
    let usual = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    slopes.par_iter_mut().for_each(|slope| {
        *slope = (FLAT * usual / slope.max(f32::MIN_POSITIVE)).clamp(1.0, MOST);
    });
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_saddle_at_its_level_is_stretched_and_the_edges_of_lines_are_not() {
        let size = [160, 160];
        // Lines of 20 px; the waves become lower towards the middle.
        let height = |px: usize| {
            let [x, y] = [px % 160, px / 160].map(|k| k as f64 - 80.0);
            let fade = 1.0 - libm::exp(-(x * x + y * y) / 128.0);
            (0.5 + 0.35 * fade * libm::sin(TAU * x / 20.0)) as f32
        };
        let u: Vec<f32> = (0..160 * 160).map(height).collect();
        let gains = gains(&u, &vec![0.5; u.len()], size, 20.0, Edges::Closed);
        assert!(gains[80 * 160 + 80] > 3.0, "{}", gains[80 * 160 + 80]);
        assert!((gains[40 * 160 + 120] - 1.0).abs() < 1e-6, "{}", gains[40 * 160 + 120]);
    }
}
