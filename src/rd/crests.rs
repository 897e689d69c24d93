//! Stripes that are to run along given lines: the noise that they begin from has its crests there.
//!
//! n′ = (1 − W) n + Σᵢ wᵢ A cos(2π dᵢ/λ) ÷ max(1, Σᵢ wᵢ), W = min(1, Σᵢ wᵢ), dᵢ the distance across line i and wᵢ 1 beside
//! it, falling to 0 across and beyond its ends.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::System;
use super::maps::Maps;
use crate::field::Edges;

/// A straight line along which a stripe is to run, in shares of the canvas' sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crest {
    /// One end.
    pub from: [f64; 2],
    /// The other.
    pub to: [f64; 2],
}

/// Height of the wave ÷ the noise's deviation.
const HEIGHT: f64 = 2.0;
/// Wavelengths across to which the wave is whole, and at which it ends.
const ACROSS: [f64; 2] = [0.4, 1.3];
/// The same beyond the ends.
const BEYOND: [f64; 2] = [0.0, 1.5];

/// Gives `noise` over the grid of `maps` crests along these lines.
pub fn lead(noise: &mut [f32], maps: &Maps, edges: Edges, crests: &[Crest]) {
    if crests.is_empty() {
        return;
    }
    noise.par_iter_mut().enumerate().for_each(|(cell, noise)| {
        let (sum, wave) = waves(maps, edges, crests, cell);
        let share = sum.min(1.0);
        *noise = ((1.0 - share) * f64::from(*noise) + HEIGHT * wave / sum.max(1.0)) as f32;
    });
}

/// Σ wᵢ and Σ wᵢ cos(2π dᵢ/λ) at a cell.
fn waves(maps: &Maps, edges: Edges, crests: &[Crest], cell: usize) -> (f64, f64) {
    let at = maps.middle(cell);
    let length = System::MeinhardtStripes.spacing(&maps.parameters[cell]);
    let (mut sum, mut wave) = (0.0, 0.0);
    for crest in crests {
        let [beyond, across] = crest.seen(at, [maps.nx, maps.ny], edges);
        let weight = fall(beyond / length, BEYOND) * fall(across.abs() / length, ACROSS);
        sum += weight;
        wave += weight * libm::cos(TAU * across / length);
    }
    (sum, wave)
}

impl Crest {
    /// The corners of the box around it, cells.
    pub fn box_of(&self, n: [usize; 2]) -> [[f64; 2]; 2] {
        [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| [0, 1].map(|axis| pick(self.from[axis], self.to[axis]) * n[axis] as f64))
    }

    /// How far a point (cells) is from it, cells.
    pub fn distance(&self, at: [f64; 2], n: [usize; 2], edges: Edges) -> f64 {
        let [beyond, across] = self.seen(at, n, edges);
        (beyond * beyond + across * across).sqrt()
    }

    /// How far a point (cells) lies beyond the ends and across, cells.
    fn seen(&self, at: [f64; 2], n: [usize; 2], edges: Edges) -> [f64; 2] {
        let [from, to] = [self.from, self.to].map(|end| [end[0] * n[0] as f64, end[1] * n[1] as f64]);
        let half = [0, 1].map(|axis| 0.5 * (to[axis] - from[axis]));
        let length = (half[0] * half[0] + half[1] * half[1]).sqrt();
        let along = [0, 1].map(|axis| half[axis] / length);
        let off = [0, 1].map(|axis| {
            let (off, side) = (at[axis] - from[axis] - half[axis], n[axis] as f64);
            if edges == Edges::Wrap { off - side * (off / side).round() } else { off }
        });
        let beyond = (off[0] * along[0] + off[1] * along[1]).abs() - length;
        [beyond.max(0.0), off[1] * along[0] - off[0] * along[1]]
    }
}

/// 1 up to `from`, 0 from `to` on, smooth between.
fn fall(v: f64, [from, to]: [f64; 2]) -> f64 {
    let t = ((to - v) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
