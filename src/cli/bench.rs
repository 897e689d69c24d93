//! `dapple bench`: the speed of this machine.

mod kernels;
mod machine;
mod pictures;
mod report;

use super::{Error, interrupted, print, values};
use crate::export::TemporaryFolder;
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
    /// Cells along each side of the grids
    #[arg(
        long, value_name = "N,N...", value_delimiter = ',', value_parser = values::grid_side,
        default_values_t = [256, 1024, 2048]
    )]
    pub size: Vec<usize>,
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

    /// The requested cases and documents.
    fn chosen(&self) -> Result<(Vec<Case>, Vec<pictures::Example>), Error> {
        let mut names = Vec::new();
        let mut wanted = |name: String| {
            let wanted = name.contains(&self.only);
            names.push(name);
            wanted
        };
        let cases: Vec<Case> = Case::ALL.into_iter().filter(|case| wanted(case.name())).collect();
        let examples: Vec<_> =
            pictures::EXAMPLES.into_iter().filter(|example| wanted(example.label())).collect();
        if cases.is_empty() && examples.is_empty() {
            let (found, allowed) = (&self.only, names.join(", "));
            return Err(Error::Usage(format!("--only: found {found:?}; allowed: a part of {allowed}")));
        }
        Ok((cases, examples))
    }
}

/// Measures this machine and prints the results.
///
/// # Errors
/// [`Error::Interrupted`]; no case was requested; an example cannot be grown.
pub fn run(args: &Args) -> Result<(), Error> {
    let (cases, examples) = args.chosen()?;
    super::install();
    let pools = Pools::new(args.threads)?;
    let bar = Bar::new(cases.len() * args.size.len() + examples.len());
    let mut report = Report::begin(pools.threads, args.effort());
    let measured = fill(&mut report, args, &cases, &examples, &pools, &bar);
    bar.clear();
    measured?;
    report.end();
    if args.json { print(&format!("{:#}\n", report.json())) } else { print(&report.text()) }
}

fn fill(
    report: &mut Report,
    args: &Args,
    cases: &[Case],
    examples: &[pictures::Example],
    pools: &Pools,
    bar: &Bar,
) -> Result<(), Error> {
    let effort = args.effort();
    for case in cases {
        let start = case.start();
        for &size in &args.size {
            bar.show(&format!("{}, {size}²", case.name()));
            report.kernels.push(kernels::measure(case, &start, size, pools, effort)?);
            bar.step();
        }
    }
    if examples.is_empty() {
        return Ok(());
    }
    let folder = TemporaryFolder::new().map_err(Error::step)?;
    for example in examples {
        bar.show(&example.label());
        report.pictures.push(pictures::measure(example, folder.path(), pools, effort)?);
        bar.step();
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
