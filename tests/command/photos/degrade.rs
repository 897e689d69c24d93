//! Effects of a camera and a file format on a picture: fractal background, vignette, blur, noise, JPEG.

use image::RgbImage;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The share of the brightness that the fractal background changes.
const FRACTAL: f64 = 0.08;
/// Brightness at the corners ÷ that in the middle.
const CORNERS: f64 = 0.45;
/// Standard deviation of the blur, px.
const BLUR: f64 = 1.5;
/// Standard deviation of the noise, relative to full brightness.
const NOISE: f64 = 0.07;
/// Quality of the JPEG.
const JPEG: u8 = 55;

/// The bytes of a JPEG of the degraded picture.
pub fn degraded(picture: &RgbImage, seed: u64) -> Vec<u8> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let [width, height] = [picture.width() as usize, picture.height() as usize];
    let fractal = fractal([width, height], &mut random);
    let mut planes =
        [0, 1, 2].map(|k| picture.pixels().map(|px| f64::from(px.0[k]) / 255.0).collect::<Vec<f64>>());
    for plane in &mut planes {
        for (at, value) in plane.iter_mut().enumerate() {
            let across = (at % width) as f64 / width as f64 - 0.5;
            let down = (at / width) as f64 / height as f64 - 0.5;
            let light = 1.0 - (1.0 - CORNERS) * 2.0 * (across * across + down * down);
            *value *= light * (1.0 + FRACTAL * fractal[at]);
        }
        *plane = blurred(plane, [width, height]);
        plane.iter_mut().for_each(|value| *value += NOISE * normal(&mut random));
    }
    let px = |at: usize| [0, 1, 2].map(|k| (255.0 * planes[k][at] + 0.5).clamp(0.0, 255.0) as u8);
    let noisy = RgbImage::from_fn(width as u32, height as u32, |x, y| {
        image::Rgb(px(y as usize * width + x as usize))
    });
    let mut bytes = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, JPEG);
    noisy.write_with_encoder(encoder).expect("a picture can be written as JPEG");
    bytes
}

/// A normally distributed number (the sum of twelve uniform ones, minus 6).
pub fn normal(random: &mut impl Rng) -> f64 {
    (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0
}

/// Value noise of six octaves, each with half the amplitude of the one before; its variance is about 1.
pub fn fractal([width, height]: [usize; 2], random: &mut impl Rng) -> Vec<f64> {
    let mut sum = vec![0.0; width * height];
    let (mut cell, mut strength) = (width.max(height) as f64 / 2.0, 1.0);
    for _ in 0..6 {
        let columns = (width as f64 / cell) as usize + 3;
        let rows = (height as f64 / cell) as usize + 3;
        let corners: Vec<f64> = (0..columns * rows).map(|_| normal(random)).collect();
        for (at, sum) in sum.iter_mut().enumerate() {
            let (x, y) = ((at % width) as f64 / cell, (at / width) as f64 / cell);
            let (i, j) = (x as usize, y as usize);
            let smooth = |t: f64| t * t * (3.0 - 2.0 * t);
            let (u, v) = (smooth(x - i as f64), smooth(y - j as f64));
            let corner = |i: usize, j: usize| corners[j * columns + i];
            let top = corner(i, j) * (1.0 - u) + corner(i + 1, j) * u;
            let bottom = corner(i, j + 1) * (1.0 - u) + corner(i + 1, j + 1) * u;
            *sum += strength * (top * (1.0 - v) + bottom * v);
        }
        cell = (cell / 2.0).max(1.0);
        strength /= 2.0;
    }
    sum
}

/// The plane, blurred by a Gaussian of [`BLUR`] px; beyond the border, the values of the border are repeated.
fn blurred(plane: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let weights: Vec<f64> = (-5..=5).map(|i| (-0.5 * (f64::from(i) / BLUR).powi(2)).exp()).collect();
    let total: f64 = weights.iter().sum();
    let pass = |plane: &[f64], across: bool| -> Vec<f64> {
        let cell = |at: usize| {
            let (x, y) = ((at % width) as isize, (at / width) as isize);
            let value = |i: isize| {
                let (x, y) = if across { (x + i, y) } else { (x, y + i) };
                plane[y.clamp(0, height as isize - 1) as usize * width
                    + x.clamp(0, width as isize - 1) as usize]
            };
            weights.iter().enumerate().map(|(i, weight)| weight * value(i as isize - 5)).sum::<f64>() / total
        };
        (0..width * height).map(cell).collect()
    };
    pass(&pass(plane, true), false)
}
