//! Ink on paper: edges that run along the fibres of the paper, a darker rim where the ink dried, and uneven density.

use super::light;
use super::noise::{Noise, part_seed};
use super::surfel::{Source, Surfel};

/// The paper.
const PAPER: [f32; 3] = [0.98, 0.965, 0.93];
/// How far ink runs ÷ length of the fibres.
pub(super) const RUN: f32 = 0.32;

/// Ink on paper with fibres `size` px long.
#[must_use]
pub fn on_paper(source: &Source, size: f32) -> Vec<Surfel> {
    let mut picture = source.shaded(surfel(source, size));
    light::apply(&mut picture, source, 0.0);
    picture
}

/// Noise that is long along one direction: fibres that lie across each other.
fn fibres(canvas: [f32; 2], size: f32, seed: u32, along: usize) -> impl Fn([f32; 2]) -> f32 {
    let stretch = 5.0;
    let mut squeezed = canvas;
    squeezed[along] /= stretch;
    let noise = Noise::new(squeezed, 0.2 * size, seed);
    move |point: [f32; 2]| {
        let mut point = point;
        point[along] /= stretch;
        noise.at(point)
    }
}

pub(super) fn surfel<'a>(source: &'a Source, size: f32) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    let part = |index| part_seed(source.seed, index);
    let run = [0, 1].map(|axis| Noise::new(source.canvas, 0.45 * size, part(96 + axis as u32)));
    let fine = [0, 1].map(|axis| Noise::new(source.canvas, 0.16 * size, part(98 + axis as u32)));
    let threads = [0, 1].map(|axis| fibres(source.canvas, size, part(100 + axis as u32), axis));
    let cloud = Noise::new(source.canvas, 2.4 * size, part(102));
    move |point| {
        let fibre = [threads[0](point), threads[1](point)];
        let by = [0, 1].map(|axis| {
            RUN * size * (0.75 * run[axis].at(point) + 0.45 * fine[axis].at(point) + 0.6 * fibre[axis])
        });
        let far = (by[0] * by[0] + by[1] * by[1]).sqrt().max(1e-6);
        let part = source.reach.at(point, size).min(far) / far;
        let seen = source.at([point[0] + part * by[0], point[1] + part * by[1]]);
        // Where the places around have other colours, an edge is near: there the ink dries last.
        let around = [[1.1, 0.0], [-1.1, 0.0], [0.0, 1.1], [0.0, -1.1]].map(|[dx, dy]: [f32; 2]| {
            let there = source.at([point[0] + part * by[0] + dx, point[1] + part * by[1] + dy]);
            (0..3).map(|channel| (there[channel] - seen[channel]).max(0.0)).sum::<f32>()
        });
        let rim = (around.iter().sum::<f32>() * 0.5).min(1.0);
        dried(seen, rim, cloud.at(point), 0.5 * (fibre[0] + fibre[1]))
    }
}

/// Dried ink of a colour and share of ink: how much of a rim it is, 0..1, slow noise, and noise of the fibres.
#[inline]
pub(super) fn dried(seen: [f32; 4], rim: f32, slow: f32, grain: f32) -> Surfel {
    let density = 1.12 + 0.14 * slow + 0.1 * grain + 0.3 * rim;
    // Each channel is what the ink lets through: more ink lets less through.
    let passed = [0, 1, 2].map(|channel| {
        let absorbed = (1.0 - seen[channel]) * density;
        PAPER[channel] * (1.0 - absorbed).clamp(0.0, 1.0)
    });
    Surfel {
        colour: passed,
        tint: 1.0 + 0.02 * grain,
        light: 1.0,
        height: 0.05 * grain,
        roughness: 0.92 - 0.1 * seen[3],
        ink: seen[3],
    }
}
