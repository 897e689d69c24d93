//! The sweep, ahead of time: parameters → simulation → measured attributes (or a rejection with its reason) →
//! rows in `training/`. And the trial: how well what grows matches what was drawn; and the
//! route: how well what grows fast matches what grows slowly.

mod files;
mod plan;
mod plot;
mod route;
mod run;
mod trial;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

/// Sweep reaction-diffusion parameters and write the training sets of dapple
#[derive(Parser)]
#[command(name = "data-gen", version)]
enum Command {
    /// Run the simulations of the training sets and write one CSV a system, with what was rejected beside it
    Sweep(Sweep),
    /// Grow all examples and many random sketches; tell how far they are from what was drawn
    Trial(trial::Args),
    /// Compare patterns grown over coarse grids with the same grown by plain steps to the end
    Route(route::Args),
    /// Draw the table of `dapple learn`
    Plot(plot::Args),
}

#[derive(clap::Args)]
struct Sweep {
    /// Only this system
    #[arg(long, value_parser = dapple::learn::SYSTEMS)]
    system: Option<String>,
    /// Simulations a system [default: as planned for each]
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    runs: Option<u64>,
    /// Where to write
    #[arg(short, long, default_value = "training")]
    output: PathBuf,
    /// Threads to use [default: all cores]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

fn main() -> ExitCode {
    let done = match Command::parse() {
        Command::Sweep(sweep) => run_sweep(&sweep).map(|()| true),
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

fn run_sweep(sweep: &Sweep) -> Result<(), String> {
    if let Some(threads) = sweep.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(threads))
            .build_global()
            .map_err(|error| format!("cannot start {threads} threads: {error}"))?;
    }
    for set in plan::sets() {
        if sweep.system.as_deref().is_none_or(|system| system == set.system.name()) {
            let outcomes = run::all(&set, sweep.runs.unwrap_or(set.runs));
            files::write(&sweep.output, set.system, &outcomes)?;
        }
    }
    Ok(())
}
