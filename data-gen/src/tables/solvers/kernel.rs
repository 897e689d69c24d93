//! The kernel of dapple: Euler's method on one grid, and on a coarse one first; super steps.

use dapple_engine::grid::Edges;
use dapple_engine::rd::pairs::{Course, PairGrowth, PairModel, PairStart};
use dapple_engine::rd::prolongate;

use super::case::{Case, growth};
use super::{Run, SIDE};
use crate::cpu::Stopwatch;

/// The share of the time that is grown on the coarse grid.
const COARSE: f64 = 0.75;

/// Euler steps on the whole grid.
pub fn euler(case: &Case, seed: u64) -> Result<Run, String> {
    run(case, growth(&case.maps(1), &case.model(1), &PairStart::Noise(seed))?.with_stages(1))
}

/// Super steps on the whole grid.
pub fn super_steps(case: &Case, seed: u64) -> Result<Run, String> {
    run(case, growth(&case.maps(1), &case.model(1), &PairStart::Noise(seed))?)
}

fn run(case: &Case, mut growth: PairGrowth) -> Result<Run, String> {
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
    let mut coarse = growth(&case.maps(factor), &case.model(factor), &PairStart::Noise(seed))?.with_stages(1);
    coarse.advance(coarse.steps_in(COARSE * case.time));
    let from = [SIDE / factor; 2];
    let fine = |cells: Vec<f32>| prolongate(cells, from, [SIDE; 2], Edges::Wrap);
    let start = PairStart::Grown(coarse.concentrations().into_iter().map(fine).collect());
    let model = PairModel { threshold: Course::Constant(case.threshold), ..case.model(1) };
    let mut fine = growth(&case.maps(1), &model, &start)?.with_stages(1);
    fine.advance(fine.steps_in((1.0 - COARSE) * case.time));
    Ok(Run {
        steps: coarse.steps() + fine.steps(),
        seconds: watch.seconds(),
        differences: fine.differences().into_iter().map(|field| field.values).collect(),
        level: case.level(),
    })
}
