//! The colours of rosettes: those of their blotches and of the ground, and those of their centres, which may be tinted.

use super::FoundRosettes;
use crate::colour::{linear_light, oklab_of_light, srgb_of_oklab};
use crate::grid::distance::{length, nearest};
use crate::photo::lab::Lab;
use crate::photo::light::Light;
use crate::photo::stops::{self, Tone};
use crate::points::rosettes::Rosettes;

/// Least difference between the ground and the centres, OKLab, from which on these are tinted.
const TINTED: f32 = 0.025;
/// Distance of the cells of a centre from the ink, beyond the blur, cells.
const BLUR: f64 = 2.0;
/// Quantiles of the tints of the rosettes that become the least and the greatest one.
const TINTS: [f64; 2] = [0.1, 0.9];
/// The pattern in the least tinted centre ÷ that in the most tinted one.
const LEAST: f64 = 0.45;
/// Pattern values of the ground and of marks beside an edge.
const NEAR: [f64; 2] = [0.41, 0.59];

/// The colours of rosettes in a picture, and what they are like, with their tint.
pub fn tones(lab: Option<&Lab>, found: &FoundRosettes) -> (Vec<Tone>, Rosettes) {
    let plain = Rosettes { tint: 0.0, ..found.like };
    let Some(lab) = lab else { return (Vec::new(), plain) };
    let enclosed = |cell: usize| found.centres[cell] > 0;
    let stops::Tones { tones, light } = stops::tones(lab, &found.ink, found.level, |_| true, enclosed);
    let (Some(light), Some(ground)) = (light, tones.first().filter(|tone| tone.at == 0.0)) else {
        return (tones, plain);
    };
    let ground = oklab(ground.colour);
    let centres = colours(lab, found, &light);
    let Some([least, most]) = tints(ground, &centres) else { return (tones, plain) };
    let tint = found.like.tint;
    // Inside of an outline the pattern goes from the tint to the edge, so what lies between has the colour of the centre.
    let inner = [(LEAST * tint, least), (tint, most), (NEAR[0], most)];
    let inner = inner.map(|(at, colour)| Tone { at, colour: srgb_of_oklab(colour) });
    let ends =
        |low: bool| tones.iter().filter(move |tone| if low { tone.at == 0.0 } else { tone.at >= NEAR[1] });
    (ends(true).copied().chain(inner).chain(ends(false).copied()).collect(), found.like)
}

fn oklab(colour: [u8; 3]) -> [f32; 3] {
    let light = linear_light();
    oklab_of_light(colour.map(|channel| light[usize::from(channel)]))
}

/// The mean colour of the centre of each rosette that has one beyond the blur of its ink, in full light.
fn colours(lab: &Lab, found: &FoundRosettes, light: &Light) -> Vec<[f32; 3]> {
    let grid = found.ink.grid();
    let is_ink: Vec<bool> = found.ink.values.iter().map(|value| *value > found.level).collect();
    let Some(to_ink) = nearest(&is_ink, &grid) else { return Vec::new() };
    let count = found.centres.iter().max().map_or(0, |most| *most as usize);
    let mut sums = vec![([0.0; 3], 0.0); count];
    for (cell, centre) in found.centres.iter().enumerate().filter(|(_, centre)| **centre > 0) {
        if length(to_ink[cell], &grid) > BLUR * grid.cell[0] {
            let (sum, count) = &mut sums[*centre as usize - 1];
            let colour = light.divided_out(lab, cell);
            (0..3).for_each(|k| sum[k] += colour[k]);
            *count += 1.0;
        }
    }
    sums.into_iter()
        .filter(|(_, count)| *count > 0.0)
        .map(|(sum, count)| sum.map(|sum| sum / count))
        .collect()
}

/// The least and the most tinted colour of the centres, from that of the ground along the way to their mean; `None` if they are as the
/// ground.
fn tints(ground: [f32; 3], centres: &[[f32; 3]]) -> Option<[[f32; 3]; 2]> {
    let count = centres.len() as f32;
    let way = [0, 1, 2].map(|k| centres.iter().map(|colour| colour[k] - ground[k]).sum::<f32>() / count);
    let square = way.iter().map(|along| along * along).sum::<f32>();
    if centres.is_empty() || square < TINTED * TINTED {
        return None;
    }
    let along = |colour: &[f32; 3]| (0..3).map(|k| (colour[k] - ground[k]) * way[k]).sum::<f32>() / square;
    let mut all: Vec<f32> = centres.iter().map(along).collect();
    all.sort_by(f32::total_cmp);
    Some(TINTS.map(|share| {
        let tint = all[((all.len() - 1) as f64 * share).round() as usize].max(0.0);
        [0, 1, 2].map(|k| ground[k] + tint * way[k])
    }))
}
