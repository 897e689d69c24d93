//! Plans of mazes: lines of several directions that exclude each other.

use rayon::prelude::*;

use super::base_model;
use super::thread_map::ThreadMap;
use crate::grid::Field;
use crate::rd::pairs::{Combination, PairModel, Threads};
use crate::synth::report::NOTED;

/// e of the pairs of a maze, of two directions and of more: with 2 three directions are twisted, and with 3 two make long pieces that
/// their neighbours turn (`facts.md` H).
const ELONGATIONS: [f32; 2] = [2.0, 3.0];
/// Distance of the lines of a maze ÷ Λ: lines of one direction, from noise, are .935 Λ apart (`facts.md` H).
const PERIOD: f64 = 0.935;
/// w/K₀ of a maze: softer steps let pieces of one direction grow at the cost of others.
const SOFTNESS: f32 = 0.02;
/// By how much max Dᵢ + min Dᵢ of a maze is raised, in K₀: in the middle of the ground it is about −0.5 K₀.
const RAISED: f32 = 0.5;

/// Size of the pieces, in distances of lines, at least: of smaller ones less than nine tenths keep their direction (`facts.md` H: 2.5 Λ).
const LEAST_LINES: f64 = 2.7;
/// Size of the pieces, in shorter sides of the canvas, at most: so that all directions are seen.
const MOST_SIDES: f64 = 0.4;

/// Width ÷ period of the lines of a maze. Of sketches of two and three directions, thinner ones were 0.31 to 0.32 and wider ones 0.68 to 0.70:
/// at other levels they break or merge.
const DUTIES: [f64; 2] = [0.32, 0.69];

/// What only a maze has.
#[derive(Clone, Debug, Default)]
pub struct MazeForm {
    /// The direction that each cell is to have, by its number among the threads; empty until it is laid out.
    pub pieces: Vec<u8>,
}

/// The size s of the pair of these threads, px.
pub(super) fn size(threads: &Threads) -> f64 {
    threads.period / (PERIOD * base_model().wavelength())
}

/// The mean width of these threads that a maze can have, px. Those whose duty a map varies are cut as wide as they are wanted.
pub(super) fn reached(threads: &ThreadMap) -> f64 {
    let asked = threads.mean();
    let [least, most] = if threads.mean_duty().is_some() { [0.0, 1.0] } else { DUTIES };
    asked.width / asked.duty() * asked.duty().clamp(least, most)
}

/// What to know of threads that are thinner or wider than the lines of a maze can be.
pub(super) fn note(threads: &ThreadMap) -> Option<String> {
    let (asked, reached) = (threads.mean(), reached(threads));
    let [least, most] = DUTIES.map(|duty| 100.0 * duty);
    ((reached / asked.width - 1.0).abs() > NOTED).then(|| {
        format!(
            "at {:.0}° lines are to be {:.1} px wide and {:.1} px apart; those of a maze cover {least:.0} % to {most:.0} % of their \
             distance, so that they grow {reached:.1} px wide",
            asked.angle,
            asked.width,
            asked.width / asked.duty()
        )
    })
}

/// The size of a piece on a `canvas`, px: the mean length of the drawn lines.
pub(super) fn length_of_pieces(threads: &[ThreadMap], canvas: [f64; 2]) -> f64 {
    let lengths: Vec<f64> =
        threads.iter().flat_map(|threads| threads.lines.iter().map(|(_, line)| line.length())).collect();
    let mean = lengths.iter().sum::<f64>() / lengths.len().max(1) as f64;
    let apart = threads.iter().map(|threads| {
        let mean = threads.mean();
        mean.width / mean.duty()
    });
    let least = LEAST_LINES * apart.fold(0.0, f64::max);
    let [width, height] = canvas;
    mean.min(MOST_SIDES * width.min(height)).max(least)
}

/// e of the pairs of so many `directions`.
pub(super) fn elongation(directions: usize) -> f32 {
    ELONGATIONS[usize::from(directions > 2)]
}

/// The level of the [`shown`] field at which X is 0.
pub(super) fn level() -> f32 {
    RAISED * base_model().peak_gain()
}

/// max Dᵢ + min Dᵢ, whose sign is that of the reaction's X, raised so that the ground is 0.
pub(super) fn shown(differences: &[Field]) -> Vec<Field> {
    let Some((first, others)) = differences.split_first() else { return Vec::new() };
    let value = |(cell, first): (usize, &f32)| {
        let all = others.iter().map(|other| other.values[cell]);
        let [low, high] = all.fold([*first; 2], |[low, high], value| [low.min(value), high.max(value)]);
        (low + high + level()).max(0.0)
    };
    vec![Field { values: first.values.par_iter().enumerate().map(value).collect(), ..first.clone() }]
}

/// The reaction.
pub(super) fn model() -> PairModel {
    PairModel { combination: Combination::DifferenceOfAbsolutes, softness: SOFTNESS, ..base_model() }
}
