//! Mottling: the tone of a material varies slowly and finely, in marks and ground alike.

use rayon::prelude::*;

use super::noise::{Noise, part_seed};
use super::surfel::{Source, Surfel};

/// Octaves: size ÷ size of the material, and weight.
pub(super) const OCTAVES: [(f32, f32); 3] = [(8.0, 1.0), (3.0, 0.7), (1.2, 0.5)];
/// The standard deviation of [`Noise`].
const DEVIATION: f32 = 0.5;
/// The seeds of the octaves are those of parts of the finish from this on.
pub(super) const PART: u32 = 64;

/// The factor of the sum of the weighted octaves for a tone with the standard deviation `by`.
pub(super) fn factor(by: f32) -> f32 {
    let squares: f32 = OCTAVES.iter().map(|(_, weight)| weight * weight).sum();
    by / (DEVIATION * squares.sqrt())
}

/// Varies the tone of the px of `picture` with the standard deviation `by`, a share of the tone. The parts of the material are `size` px of
/// the document.
pub fn mottle(picture: &mut [Surfel], source: &Source, size: f32, by: f32) {
    let noises: Vec<(Noise, f32)> = OCTAVES
        .iter()
        .zip(PART..)
        .map(|((times, weight), part)| {
            (Noise::new(source.canvas, times * size, part_seed(source.seed, part)), *weight)
        })
        .collect();
    let factor = factor(by);
    let (width, scale) = (source.size[0], source.scale());
    picture.par_chunks_mut(width.max(1)).enumerate().for_each(|(y, row)| {
        for (x, surfel) in row.iter_mut().enumerate() {
            let point = [(x as f32 + 0.5) / scale[0], (y as f32 + 0.5) / scale[1]];
            let noise: f32 = noises.iter().map(|(noise, weight)| weight * noise.at(point)).sum();
            surfel.tint *= (1.0 + factor * noise).max(0.0);
        }
    });
}
