//! `dapple bench`: the speed of this machine.

#[cfg(feature = "app")]
mod changes;
mod kernels;
mod machine;
mod phases;
mod pictures;
mod report;

use super::json::print_json;
use super::{Error, interrupted, print, values};
#[cfg(feature = "app")]
use crate::machine::threads;
use crate::rd::benchmark::Case;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use kernels::{Effort, Pools};
use report::Report;
use std::time::Duration;

/// Arguments of `dapple bench`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Answer in JSON
    #[arg(long)]
    pub json: bool,
    /// Threads of the runs with several threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Cells along each side of the grids [default: 256,1024,2048]; with --phases px along each side of the canvases
    /// [default: 1024]
    #[arg(long, value_name = "N,N...", value_delimiter = ',', value_parser = values::grid_side)]
    pub size: Vec<usize>,
    /// Measure the CPU time from documents to their pictures, by section of the work, on one thread
    #[arg(long)]
    pub phases: bool,
    /// Measure how soon a change of a sketch is shown in the window, and how many marks far away from the change move
    #[cfg(feature = "app")]
    #[arg(long, conflicts_with_all = ["phases", "size", "threads"])]
    pub changes: bool,
    /// Measure only cases with this text in their names, such as turing-spots/isotropic or picture/
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    pub only: String,
    /// Fewer and shorter runs, for rough numbers in a few seconds
    #[arg(long)]
    pub quick: bool,
}

impl Args {
    fn effort(&self) -> Effort {
        if self.quick {
            Effort { pairs: 3, at_least: Duration::from_millis(10), pictures: 1 }
        } else {
            Effort { pairs: 5, at_least: Duration::from_millis(100), pictures: 3 }
        }
    }

    /// The requested sizes.
    fn sizes(&self) -> &[usize] {
        match (&self.size[..], self.phases) {
            ([], false) => &[256, 1024, 2048],
            ([], true) => &[1024],
            (sizes, _) => sizes,
        }
    }

    /// The requested cases and documents.
    fn chosen(&self) -> Result<Chosen, Error> {
        let mut names = Vec::new();
        let mut wanted = |name: String| {
            let wanted = name.contains(&self.only);
            names.push(name);
            wanted
        };
        let mut examples = |all: &[pictures::Example]| -> Vec<_> {
            all.iter().filter(|example| wanted(example.label())).copied().collect()
        };
        let (examples, cases): (_, Vec<Case>) = if self.phases {
            (examples(&phases::EXAMPLES), Vec::new())
        } else {
            let examples = examples(&pictures::EXAMPLES);
            (examples, Case::ALL.into_iter().filter(|case| wanted(case.name())).collect())
        };
        if cases.is_empty() && examples.is_empty() {
            let (found, allowed) = (&self.only, names.join(", "));
            return Err(Error::Usage(format!("--only: found {found:?}; allowed: a part of {allowed}")));
        }
        Ok(Chosen { cases, examples })
    }
}

/// The cases that are measured.
struct Chosen {
    cases: Vec<Case>,
    examples: Vec<pictures::Example>,
}

/// Measures this machine and prints the results.
///
/// # Errors
/// [`Error::Interrupted`]; no case was requested; an example cannot be grown.
pub fn run(args: &Args) -> Result<(), Error> {
    #[cfg(feature = "app")]
    if args.changes {
        return run_changes(args);
    }
    let chosen = args.chosen()?;
    super::install();
    let pools = Pools::new(args.threads)?;
    let sizes = args.sizes().len();
    let of_examples = if args.phases { sizes } else { 1 };
    let bar = Bar::new(chosen.cases.len() * sizes + chosen.examples.len() * of_examples);
    let mut report = Report::begin(pools.threads, args.effort());
    let measured = fill(&mut report, args, &chosen, &pools, &bar);
    bar.clear();
    measured?;
    report.end();
    if args.json { print_json(report.json()) } else { print(&report.text()) }
}

/// Measures how a growing texture follows changes of the sketch.
#[cfg(feature = "app")]
fn run_changes(args: &Args) -> Result<(), Error> {
    let wanted = |sketch: &changes::Sketch| sketch.name().contains(&args.only);
    let chosen: Vec<changes::Sketch> = changes::Sketch::ALL.into_iter().filter(wanted).collect();
    if chosen.is_empty() {
        let (found, allowed) = (&args.only, changes::Sketch::ALL.map(changes::Sketch::name).join(", "));
        return Err(Error::Usage(format!("--only: found {found:?}; allowed: a part of {allowed}")));
    }
    super::install();
    let mut report = Report::begin(threads::cores(), args.effort());
    let bar = Bar::new(chosen.len());
    for sketch in chosen {
        bar.show(sketch.name());
        report.changes.push(changes::measure(sketch, if args.quick { 3 } else { 10 })?);
        bar.step();
    }
    bar.clear();
    report.end();
    if args.json { print_json(report.json()) } else { print(&report.text()) }
}

fn fill(
    report: &mut Report,
    args: &Args,
    Chosen { cases, examples }: &Chosen,
    pools: &Pools,
    bar: &Bar,
) -> Result<(), Error> {
    let effort = args.effort();
    for case in cases {
        let start = case.start();
        for &size in args.sizes() {
            bar.show(&format!("{}, {size}²", case.name()));
            report.kernels.push(kernels::measure(case, &start, size, pools, effort)?);
            bar.step();
        }
    }
    if examples.is_empty() {
        return Ok(());
    }
    let folder = pictures::Folder::new()?;
    for example in examples {
        bar.show(&example.label());
        if !args.phases {
            report.pictures.push(pictures::measure(example, &folder, pools, effort)?);
            bar.step();
            continue;
        }
        for &size in args.sizes() {
            bar.show(&format!("{}, {size}²", example.label()));
            report.phases.push(phases::measure(example, size, &folder, pools, effort)?);
            bar.step();
        }
    }
    Ok(())
}

/// [`Error::Interrupted`] if Ctrl-C was pressed.
fn check_interrupt() -> Result<(), Error> {
    if interrupted() { Err(Error::Interrupted) } else { Ok(()) }
}

/// Shows the current measurement on a terminal.
struct Bar(ProgressBar);

impl Bar {
    fn new(parts: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(parts as u64), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len}  {msg}");
        Self(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }

    fn show(&self, what: &str) {
        self.0.set_message(what.to_owned());
    }

    fn step(&self) {
        self.0.inc(1);
    }

    fn clear(&self) {
        self.0.finish_and_clear();
    }
}
