//! `dapple learn`: the errors of the training sets, for several methods, in parameters and in grown textures.

mod bounds;
mod held_out;
mod json;
mod outcome;
mod pairs;
mod regrown;
mod table;
mod targets;
mod way;

use super::json::print_json;
use super::{Error, print, values};
use crate::document::SystemChoice;
use crate::document::systems::of_pairs;
use crate::files;
use crate::machine::threads;
use crate::rd::System;
use crate::synth::marks::grow::probe::When;
use crate::synth::{Training, Watch};
use indicatif::{ProgressBar, ProgressStyle};
use outcome::Outcome;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Arguments of `dapple learn`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Only this system.
    #[arg(long, value_name = "S", value_parser = values::learnt, help = values::learnt_help())]
    pub system: Option<SystemChoice>,
    /// Number of random targets to grow for each system, and most rows to leave out of a training set and look up
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = values::whole(1..=10_000u32))]
    pub targets: u32,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Compare parameters only; grow nothing
    #[arg(long)]
    pub no_simulation: bool,
    /// Always correct the lookup by two growths of a small patch, even if the training set is certain
    #[arg(long, conflicts_with = "no_simulation")]
    pub always_probe: bool,
    /// Seed of the random targets and of their growths
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::seed)]
    pub seed: u64,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Print one JSON object at the end instead of tables
    #[arg(long)]
    pub json: bool,
    /// Also write the table as CSV
    #[arg(short, long, value_name = "TABLE.csv")]
    pub output: Option<PathBuf>,
}

/// The common inputs of all comparisons.
struct Setting<'a> {
    training: &'a Training,
    /// The number of targets, and of rows to look up, for each system.
    targets: usize,
    seed: u64,
    when: When,
    /// Whether all systems are compared.
    all: bool,
    /// Whether random targets are grown.
    grow: bool,
    watch: &'a Watch<'a>,
}

/// Compares the methods, prints the tables and writes the CSV.
///
/// # Errors
/// A training set cannot be read, or the table cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    if let Some(output) = &args.output {
        super::paths::check_not_in_training(args.training.as_deref(), output)?;
        files::check_file(output).map_err(Error::step)?;
    }
    if let Some(threads) = args.threads {
        threads::set_shared(threads);
    }
    let cancelled = super::install();
    let watch = Watch { progress: &|_, _| {}, cancelled: &|| cancelled.load(Ordering::Relaxed) };
    let training = files::training(args.training.clone());
    let setting = Setting {
        training: &training,
        targets: args.targets as usize,
        seed: args.seed,
        when: if args.always_probe { When::Always } else { When::Unsure },
        all: args.system.is_none(),
        grow: !args.no_simulation,
        watch: &watch,
    };
    let mut outcomes: Vec<Outcome> = Vec::new();
    for system in System::ALL {
        if args.system.is_none_or(|only| only.system() == Some(system)) {
            let of_system = compared(&setting, system)?;
            if !args.json {
                print(&table::text(system.name(), &of_system))?;
            }
            outcomes.extend(of_system);
        }
    }
    for system in of_pairs() {
        if args.system.is_none_or(|only| only.name() == system.name) {
            let of_system = pairs::outcomes(&setting, system)?;
            if !args.json && of_system.is_empty() {
                print(&format!("{}: no rows, left out\n\n", system.name))?;
            } else if !args.json {
                print(&table::text(system.name, &of_system))?;
            }
            outcomes.extend(of_system);
        }
    }
    if args.json {
        print_json(json::outcomes(&outcomes))?;
    }
    let Some(path) = &args.output else { return Ok(()) };
    let csv = table::csv(&outcomes);
    files::save(path, |stream| Ok(stream.write_all(csv.as_bytes())?)).map_err(Error::step)
}

/// The outcomes of one system.
fn compared(setting: &Setting, system: System) -> Result<Vec<Outcome>, Error> {
    let mut outcomes = held_out::outcomes(setting, system)?;
    if setting.grow {
        outcomes.extend(regrown::outcomes(setting, system)?);
    }
    Ok(outcomes)
}

/// A progress bar, drawn on terminals only.
fn bar(message: String, steps: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:40} {bar:30} {pos}/{len}  {elapsed} elapsed, {eta} left");
    let bar = ProgressBar::new(steps as u64).with_message(message);
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
