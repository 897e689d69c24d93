//! Tools that make and check the data of dapple. The sweep writes the training sets: parameters → simulation → measured
//! attributes (or a rejection with its reason) → rows in `training/`. The trial measures how well textures match what
//! was drawn. The route measures how well patterns grown over coarse grids match those grown by plain steps. The tables
//! are the measurements by which constants were chosen.
//!
//! ```text
//!  plan.json ─▶ plan ─▶ draw ─▶ run ─▶ journal (a shard's) ─┐
//!               check                  journal, …          ─┴▶ merge ─▶ files: rows, rejected, manifest
//! ```

mod allowed;
mod bodies;
mod check;
mod cpu;
mod cross_talk;
mod draw;
mod files;
mod fineness;
mod growth_map;
pub mod journal;
mod keys;
mod manifest;
mod merge;
mod pairs;
pub mod plan;
mod plot;
mod progress;
mod read_plan;
mod route;
pub mod run;
pub mod shard;
mod sweep;
mod swept;
mod tables;
#[cfg(test)]
mod tests;
mod trial;
mod verdicts;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

/// Sweep reaction-diffusion parameters and write the training sets of dapple
#[derive(Parser)]
#[command(name = "data-gen", version)]
enum Command {
    /// Run the simulations of the training sets; write their rows, the rejected runs and a manifest
    ///
    /// A sweep that was stopped continues where it stopped when it is started again.
    Sweep(sweep::Args),
    /// Join the parts of a sweep that were run with --shard, and write their files
    Merge(merge::Args),
    /// Print the built-in plan: what is swept, over which ranges, and why
    Plan,
    /// Grow all examples and many random sketches; print how much they differ from what was drawn
    Trial(trial::Args),
    /// Compare patterns grown over coarse grids with patterns grown by plain steps to the end
    Route(route::Args),
    /// Draw the table of `dapple learn`
    Plot(plot::Args),
    /// Draw what Turing's growth makes at each growth and decay: assets/growth-map.png and .svg; print the numbers as
    /// CSV
    GrowthMap(growth_map::Args),
    /// Measure how much smaller spots are on coarse meshes: training/fineness.csv
    Fineness(fineness::Args),
    /// Compare growth on models: other triangulations of one surface, other ways to compute diffusion (docs/bodies.md,
    /// docs/turk.md)
    Bodies(bodies::Args),
    /// Measure what else changes when one attribute of a sketch is changed, and what each key of a document changes:
    /// docs/cross-talk.md, docs/keys.md and assets/keys
    CrossTalk(cross_talk::Args),
    /// Print the tables behind constants in the code and in docs/; run this at the root of the repository
    Tables(tables::Args),
}

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    let done = match Command::parse() {
        Command::Sweep(sweep) => sweep::command(&sweep).map(|()| true),
        Command::Merge(merge) => merge::command(&merge).map(|()| true),
        Command::Plan => say(plan::BUILT_IN.trim_end()).map(|()| true),
        Command::Trial(trial) => trial::run(&trial),
        Command::Route(route) => route::run(&route),
        Command::Plot(plot) => plot::run(&plot),
        Command::GrowthMap(map) => growth_map::run(&map).map(|()| true),
        Command::Fineness(fineness) => fineness::run(&fineness).map(|()| true),
        Command::Bodies(bodies) => bodies::run(&bodies).map(|()| true),
        Command::CrossTalk(cross_talk) => cross_talk::run(&cross_talk).map(|()| true),
        Command::Tables(tables) => tables::run(&tables).map(|()| true),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            // If stderr is closed the message is lost.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Writes a line to stdout. Unlike `println!` it does not panic where stdout is closed, which is not a failure.
fn say(line: &str) -> Result<(), String> {
    let mut stdout = std::io::stdout().lock();
    match writeln!(stdout, "{line}").and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(format!("standard output: cannot be written: {error}"))
        }
        _ => Ok(()),
    }
}
