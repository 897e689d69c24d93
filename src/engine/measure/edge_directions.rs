//! The directions of the edges of a picture; for a weave, those of its threads.
//!
//! A histogram of the directions along the edges, weighted by the squared gradient and smoothed by a Gaussian; a weave has a peak for
//! each of its directions.

use rayon::prelude::*;

use crate::grid::Field;
use crate::marks::{axial, turn};

/// Bins of half a degree.
const BINS: usize = 360;
/// Standard deviation of the smoothing, bins.
const SIGMA: f64 = 6.0;
/// Peaks closer than this to a higher one are part of it, degrees: the threads of a weave are at least 30° apart.
const APART: f64 = 25.0;
/// Lowest peak ÷ the highest. Threads 45 px apart next to others 11 px apart are below 0.15.
const LOWEST: f64 = 0.05;
/// Edges within this of a peak make up its direction, degrees.
const WINDOW: f64 = 10.0;

/// The directions along the edges of `field`, degrees in [0, 180), the most frequent first.
#[must_use]
pub fn edge_directions(field: &Field) -> Vec<f64> {
    let histogram = smooth(&histogram(field));
    let is_peak = |bin: &usize| {
        let [before, after] = [BINS - 1, 1].map(|step| histogram[(bin + step) % BINS]);
        histogram[*bin] > before && histogram[*bin] >= after
    };
    let mut peaks: Vec<usize> = (0..BINS).filter(is_peak).collect();
    peaks.sort_by(|a, b| histogram[*b].total_cmp(&histogram[*a]));
    let mut found: Vec<f64> = Vec::new();
    for bin in peaks {
        let is_high = histogram[bin] >= LOWEST * histogram.iter().copied().fold(0.0, f64::max);
        let angle = degrees(bin as f64 + 0.5);
        if is_high && found.iter().all(|other| turn(angle, *other).abs() >= APART) {
            found.push(angle);
        }
    }
    found.into_iter().map(|angle| mean_about(&histogram, angle)).collect()
}

fn degrees(bins: f64) -> f64 {
    bins * 180.0 / BINS as f64
}

/// Squared gradients by the direction along the edge.
fn histogram(field: &Field) -> Vec<f64> {
    let [nx, ny] = [field.width, field.height];
    let row = |y: usize| {
        let mut bins = vec![0.0; BINS];
        for x in 0..nx {
            let at = |dx: isize, dy: isize| {
                let [x, y] =
                    [(x as isize + dx, nx), (y as isize + dy, ny)].map(|(i, n)| field.edges.index(i, n));
                f64::from(field.values[y * nx + x])
            };
            // Scharr's derivative, whose directions have errors below 0.1° at any angle.
            let gx =
                3.0 * (at(1, -1) - at(-1, -1)) + 10.0 * (at(1, 0) - at(-1, 0)) + 3.0 * (at(1, 1) - at(-1, 1));
            let gy =
                3.0 * (at(-1, 1) - at(-1, -1)) + 10.0 * (at(0, 1) - at(0, -1)) + 3.0 * (at(1, 1) - at(1, -1));
            let [gx, gy] = [gx / field.cell[0], gy / field.cell[1]];
            let along = axial(libm::atan2(gy, gx).to_degrees() + 90.0);
            bins[((along * BINS as f64 / 180.0) as usize).min(BINS - 1)] += gx * gx + gy * gy;
        }
        bins
    };
    let rows: Vec<Vec<f64>> = (0..ny).into_par_iter().map(row).collect();
    let mut all = vec![0.0; BINS];
    rows.iter().for_each(|row| all.iter_mut().zip(row).for_each(|(sum, bin)| *sum += bin));
    all
}

fn smooth(histogram: &[f64]) -> Vec<f64> {
    let reach = (4.0 * SIGMA) as isize;
    let weight = |d: isize| libm::exp(-0.5 * (d as f64 / SIGMA) * (d as f64 / SIGMA));
    let at = |bin: isize| histogram[bin.rem_euclid(BINS as isize) as usize];
    let smoothed = |bin: isize| (-reach..=reach).map(|d| weight(d) * at(bin + d)).sum();
    (0..BINS as isize).map(smoothed).collect()
}

/// Mean of the directions about `angle`, above the lowest of them.
fn mean_about(histogram: &[f64], angle: f64) -> f64 {
    let near: Vec<(f64, f64)> = (0..BINS)
        .map(|bin| (turn(degrees(bin as f64 + 0.5), angle), histogram[bin]))
        .filter(|(away, _)| away.abs() <= WINDOW)
        .collect();
    let floor = near.iter().map(|(_, height)| *height).fold(f64::INFINITY, f64::min);
    let (sum, weight) = near.iter().fold((0.0, 0.0), |(sum, weight), (away, height)| {
        (sum + away * (height - floor), weight + height - floor)
    });
    axial(if weight > 0.0 { angle + sum / weight } else { angle })
}
