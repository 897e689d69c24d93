//! `dapple bench`: how fast this machine is.

mod kernels;
mod machine;
mod pictures;
mod report;

use super::{Error, interrupted, print, values};
use crate::rd::benchmark::Case;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use kernels::{Crews, Effort};
use report::Report;
use std::time::Duration;

/// What to measure.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Answer in JSON
    #[arg(long)]
    pub json: bool,
    /// Threads of the runs on many [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Sides of the square grids to step, cells
    #[arg(
        long, value_name = "N,N...", value_delimiter = ',', value_parser = values::grid_side,
        default_values_t = [256, 1024, 2048]
    )]
    pub size: Vec<usize>,
    /// Measure only what has this in its name, such as turing-spots/isotropic or picture/
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    pub only: String,
    /// Fewer and shorter runs: rough numbers in a few seconds
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

    /// The cases and the documents that were asked for.
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

/// Measures this machine and tells what it found.
///
/// # Errors
/// [`Error::Interrupted`]; where nothing was asked for; where an example cannot be grown.
pub fn run(args: &Args) -> Result<(), Error> {
    let (cases, examples) = args.chosen()?;
    super::install();
    let crews = Crews::of(args.threads)?;
    let bar = Bar::new(cases.len() * args.size.len() + examples.len());
    let mut report = Report::begin(crews.threads, args.effort());
    let measured = fill(&mut report, args, &cases, &examples, &crews, &bar);
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
    crews: &Crews,
    bar: &Bar,
) -> Result<(), Error> {
    let effort = args.effort();
    for case in cases {
        let start = case.start();
        for &size in &args.size {
            bar.show(&format!("{}, {size}²", case.name()));
            report.kernels.push(kernels::measure(case, &start, size, crews, effort)?);
            bar.step();
        }
    }
    if examples.is_empty() {
        return Ok(());
    }
    let folder = pictures::Folder::new()?;
    for example in examples {
        bar.show(&example.label());
        report.pictures.push(pictures::measure(example, &folder, crews, effort)?);
        bar.step();
    }
    Ok(())
}

/// Gives up where Ctrl-C was pressed.
fn go_on() -> Result<(), Error> {
    if interrupted() { Err(Error::Interrupted) } else { Ok(()) }
}

/// Shows on a terminal what is being measured.
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
