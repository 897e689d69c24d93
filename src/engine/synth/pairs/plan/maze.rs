//! Plans of mazes: lines of several directions that exclude each other.

use rayon::prelude::*;

use super::base_model;
use super::thread_map::ThreadMap;
use crate::grid::Field;
use crate::rd::pairs::{Combination, PairModel, Threads};
use crate::synth::report::NOTED;

/// e of the pairs of a maze, of two directions and of more. With 2, mazes of three directions are twisted; with 3, mazes of two
/// directions have long pieces that their neighbours rotate (`facts.md` H).
const ELONGATIONS: [f32; 2] = [2.0, 3.0];
/// Distance of the lines of a maze ÷ Λ: lines of one direction, from noise, are .935 Λ apart (`facts.md` X).
const PERIOD: f64 = 0.935;
/// w/K₀ of a maze: with softer steps pieces of one direction grow at the cost of others.
const SOFTNESS: f32 = 0.02;
/// Constant added to max Dᵢ + min Dᵢ of a maze, in K₀: in the middle of the ground the sum is about −0.5 K₀.
const RAISED: f32 = 0.5;

/// Least size of the pieces, in distances of lines: of smaller pieces less than nine tenths keep their direction (`facts.md` H: 2.5
/// Λ).
const LEAST_LINES: f64 = 2.7;
/// Largest size of the pieces, in shorter sides of the canvas: all directions should be visible.
const MOST_SIDES: f64 = 0.4;

/// Width ÷ period of the lines of a maze. In sketches of two and three directions, thinner ones reached 0.31 to 0.32 and wider ones
/// 0.68 to 0.70: at other thresholds they break or merge.
const DUTIES: [f64; 2] = [0.32, 0.69];

/// The part of a plan that only mazes have.
#[derive(Clone, Debug, Default)]
pub struct MazeForm {
    /// The direction that each cell is to have, as the index of a thread; empty until it is laid out.
    pub pieces: Vec<u8>,
}

/// The size s of the pair of these threads, px.
pub(super) fn size(threads: &Threads) -> f64 {
    threads.period / (PERIOD * base_model().wavelength())
}

/// The nearest mean width of these threads that a maze can have, px. If a map varies the duty, it is the wanted width.
pub(super) fn reached(threads: &ThreadMap) -> f64 {
    let asked = threads.mean();
    let [least, most] = if threads.mean_duty().is_some() { [0.0, 1.0] } else { DUTIES };
    asked.width / asked.duty() * asked.duty().clamp(least, most)
}

/// A note on threads that are thinner or wider than the lines of a maze can be.
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

/// e of the pairs of a maze with this number of `directions`.
pub(super) fn elongation(directions: usize) -> f32 {
    ELONGATIONS[usize::from(directions > 2)]
}

/// The threshold of the [`shown`] field at which X is 0.
pub(super) fn level() -> f32 {
    RAISED * base_model().peak_gain()
}

/// max Dᵢ + min Dᵢ, which has the sign of the reaction's X, plus a constant so that the ground is 0.
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
