//! The sweep, ahead of time: parameters → simulation → measured attributes (or a rejection with its reason) →
//! rows in `training/`. And the trial: how well what grows matches what was drawn; and the
//! route: how well what grows fast matches what grows slowly.
//!
//! ```text
//!  plan.json ─▶ plan ─▶ draw ─▶ run ─▶ journal (a shard's) ─┐
//!               check                  journal, …          ─┴▶ merge ─▶ files: rows, rejected, manifest
//! ```

mod check;
mod draw;
mod files;
pub mod journal;
mod manifest;
mod merge;
pub mod plan;
mod plot;
mod progress;
mod route;
pub mod run;
pub mod shard;
mod sweep;
#[cfg(test)]
mod tests;
mod trial;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

/// Sweep reaction-diffusion parameters and write the training sets of dapple
#[derive(Parser)]
#[command(name = "data-gen", version)]
enum Command {
    /// Run the simulations of the training sets; write their rows, what was rejected and a manifest
    ///
    /// A sweep that is stopped goes on where it was when it is started again.
    Sweep(sweep::Args),
    /// Make the files of parts that were swept with --shard
    Merge(merge::Args),
    /// Print the built-in plan: what is swept, over which ranges, and why
    Plan,
    /// Grow all examples and many random sketches; tell how far they are from what was drawn
    Trial(trial::Args),
    /// Compare patterns grown over coarse grids with the same grown by plain steps to the end
    Route(route::Args),
    /// Draw the table of `dapple learn`
    Plot(plot::Args),
}

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    let done = match Command::parse() {
        Command::Sweep(sweep) => sweep::command(&sweep).map(|()| true),
        Command::Merge(merge) => merge::command(&merge).map(|()| true),
        // A reader who has seen enough is no failure.
        Command::Plan => {
            let _ = std::io::stdout().write_all(plan::BUILT_IN.as_bytes());
            Ok(true)
        }
        Command::Trial(trial) => trial::run(&trial),
        Command::Route(route) => route::run(&route),
        Command::Plot(plot) => plot::run(&plot),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
