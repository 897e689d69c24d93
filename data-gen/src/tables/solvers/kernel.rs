//! Euler's method by the kernel of dapple: on one grid, and on a coarse one first.

use dapple::internals::grid::Edges;
use dapple::internals::rd::pairs::{Course, PairModel, PairStart};
use dapple::internals::rd::prolongate;

use super::case::{Case, growth};
use super::{Run, SIDE};
use crate::cpu::Stopwatch;

/// The share of the time that is grown on the coarse grid.
const COARSE: f64 = 0.75;

/// All on the whole grid.
pub fn euler(case: &Case, seed: u64) -> Result<Run, String> {
    let start = PairStart::Noise(seed);
    let mut growth = growth(&case.maps(1), &case.model(1), &start)?;
    let watch = Stopwatch::start();
    growth.advance(growth.steps_in(case.time));
    Ok(Run {
        steps: growth.steps(),
        seconds: watch.seconds(),
        differences: growth.differences().into_iter().map(|field| field.values).collect(),
        level: case.level(),
    })
}

/// First on a grid with `factor` times fewer cells each way.
pub fn coarse_to_fine(case: &Case, seed: u64, factor: usize) -> Result<Run, String> {
    let watch = Stopwatch::start();
    let mut coarse = growth(&case.maps(factor), &case.model(factor), &PairStart::Noise(seed))?;
    coarse.advance(coarse.steps_in(COARSE * case.time));
    let from = [SIDE / factor; 2];
    let fine = |cells: Vec<f32>| prolongate(&cells, from, [SIDE; 2], Edges::Wrap);
    let start = PairStart::Grown(coarse.concentrations().into_iter().map(fine).collect());
    let model = PairModel { threshold: Course::Constant(case.threshold), ..case.model(1) };
    let mut fine = growth(&case.maps(1), &model, &start)?;
    fine.advance(fine.steps_in((1.0 - COARSE) * case.time));
    Ok(Run {
        steps: coarse.steps() + fine.steps(),
        seconds: watch.seconds(),
        differences: fine.differences().into_iter().map(|field| field.values).collect(),
        level: case.level(),
    })
}
