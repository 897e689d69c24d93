//! `dapple lookup`: attributes → parameters, from the training sets alone.

mod answer;
mod batch;
mod law;
mod pairs;
mod sketch;

use super::json::print_json;
use super::{Error, print, values};
use crate::attributes::system::Description;
use crate::attributes::{Attributes, Spots};
use crate::document::SystemChoice;
use crate::files;
use crate::synth::Training;
use answer::LookupReport;
use law::LawReport;
use pairs::PairReport;
use rayon::prelude::*;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Arguments of `dapple lookup`.
#[derive(clap::Args, Debug)]
#[command(
    override_usage = "dapple lookup --system S --area A --aspect R --angle D [--spacing L] [--raggedness Q] [--training DIR] [--json]
       dapple lookup --system S --width W --angle D [--duty Q] [--training DIR] [--json]
       dapple lookup --system weave --width W --angle D [--duty Q] --across D[,W[,Q]]... [--training DIR] [--json]
       dapple lookup --system cells --area A --aspect R --angle D [--gap W] [--training DIR] [--json]
       dapple lookup --batch IN.csv -o OUT.csv [--training DIR]"
)]
pub struct Args {
    /// The system.
    #[arg(
        long, value_name = "S", value_parser = values::looked_up, required_unless_present = "batch",
        help = values::looked_up_help()
    )]
    pub system: Option<SystemChoice>,
    /// Mean area of a spot, px²
    #[arg(long, value_name = "A", value_parser = values::positive, requires = "aspect")]
    pub area: Option<f64>,
    /// Mean minor / major radius of a spot, 0 to 1 (1 = round)
    #[arg(long, value_name = "R", value_parser = values::aspect, requires = "area")]
    pub aspect: Option<f64>,
    /// Direction, degrees from right towards down
    #[arg(long, value_name = "D", value_parser = values::angle)]
    pub angle: Option<f64>,
    /// Mean distance between neighbouring spots, px [default: free]
    #[arg(long, value_name = "L", value_parser = values::positive, requires = "area")]
    pub spacing: Option<f64>,
    /// Mean width of a stripe, px
    #[arg(long, value_name = "W", value_parser = values::positive, conflicts_with_all = ["area", "aspect", "spacing"])]
    pub width: Option<f64>,
    /// Raggedness of patches: (contour ÷ contour of an ellipse)², 1 or more [default: the least]
    #[arg(long, value_name = "Q", value_parser = values::raggedness, requires = "area")]
    pub raggedness: Option<f64>,
    /// Stripe width ÷ period, for meinhardt-lines, streaks and cracks, 0.18 to 0.82 [default: 0.5, or that of the
    /// system]
    #[arg(long, value_name = "Q", value_parser = values::duty, requires = "width")]
    pub duty: Option<f64>,
    /// Another direction of a weave or a maze: its angle, and its width and duty where they differ; can be given up to
    /// four times
    #[arg(long, value_name = "D[,W[,Q]]", value_parser = values::across, requires = "width")]
    pub across: Vec<values::Across>,
    /// Length of the pieces of a maze, px [default: four periods]
    #[arg(long, value_name = "L", value_parser = values::positive, requires = "across")]
    pub long: Option<f64>,
    /// Decay of stucco, 0 to 0.85 [default: 0.8]
    #[arg(long, value_name = "F", value_parser = values::decay, requires = "width")]
    pub decay: Option<f64>,
    /// Width of the lines between cells, px [default: a fifth of a cell's side]
    #[arg(long, value_name = "W", value_parser = values::positive, requires = "area")]
    pub gap: Option<f64>,
    /// Look up each row of a table: columns system,area,aspect,angle,spacing,width,duty
    #[arg(
        long, value_name = "IN.csv", requires = "output",
        conflicts_with_all = ["system", "area", "aspect", "angle", "spacing", "raggedness", "width", "duty", "across", "long", "decay", "gap", "json"]
    )]
    pub batch: Option<PathBuf>,
    /// Where to write the table with the answers
    #[arg(short, long, value_name = "OUT.csv", requires = "batch")]
    pub output: Option<PathBuf>,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Answer in JSON
    #[arg(long)]
    pub json: bool,
}

impl Args {
    /// The question in the arguments; `None` with `--batch`.
    ///
    /// # Errors
    /// [`Error::Usage`] if the system needs other attributes.
    pub fn question(&self) -> Result<Option<(SystemChoice, Attributes)>, Error> {
        let Some(system) = self.system else { return Ok(None) };
        let system = system.with_stripes_chosen(self.duty.is_some());
        let usage = |needs: &str| Error::Usage(format!("--system {}: it needs {needs}", system.name()));
        // Streaks and cracks have a width, as lines do.
        let attributes = if system.is_known(Description::is_striped) {
            let needs = "--width and --angle (area, aspect and spacing are a spot's)";
            let undirected = system.is_known(|system| !system.directed);
            let angle = self.angle.or(undirected.then_some(0.0));
            let (Some(width), Some(angle)) = (self.width, angle) else { return Err(usage(needs)) };
            if let Some(allowed) = self.duty.and_then(|duty| values::duty_mismatch(duty, system)) {
                return Err(Error::Usage(format!("--duty: allowed: {allowed}")));
            }
            Attributes::Stripes(values::stripes(system, width, angle, self.duty))
        } else {
            let needs = "--area, --aspect and --angle (--width is a stripe's)";
            let (Some(area), Some(aspect), Some(angle)) = (self.area, self.aspect, self.angle) else {
                return Err(usage(needs));
            };
            Attributes::Spots(Spots {
                area,
                aspect,
                angle: crate::marks::axial(angle),
                spacing: self.spacing,
            })
        };
        Ok(Some((system, attributes)))
    }

    /// # Errors
    /// [`Error::Usage`] where an option is given that only systems of pairs have.
    fn refuse_of_pairs(&self, system: SystemChoice) -> Result<(), Error> {
        let given = [
            ("--across", !self.across.is_empty(), "with weave and maze"),
            ("--long", self.long.is_some(), "with maze"),
            ("--decay", self.decay.is_some(), "with stucco"),
            ("--gap", self.gap.is_some(), "with cells"),
        ];
        match given.iter().find(|(_, given, _)| *given) {
            Some((key, _, allowed)) => {
                Err(Error::Usage(format!("{key}: {} has none; allowed: {allowed}", system.name())))
            }
            None => Ok(()),
        }
    }
}

/// Looks up parameters.
///
/// # Errors
/// The question is incomplete, or a file cannot be read or written.
pub fn run(args: &Args) -> Result<(), Error> {
    let training = files::training(args.training.clone());
    if let (Some(table), Some(output)) = (&args.batch, &args.output) {
        super::paths::check_apart("--batch", table, output)?;
        super::paths::check_not_in_training(args.training.as_deref(), output)?;
        files::check_file(output).map_err(Error::step)?;
        return run_batch(&training, table, output);
    }
    // clap requires a system unless there is a batch.
    let Some((system, wanted)) = args.question()? else {
        return Err(Error::Usage("--system is missing".into()));
    };
    if system.is_known(|system| system.coordinates().is_some()) {
        let looked = PairReport::new(&training, system, &wanted, args)?;
        return if args.json { print_json(looked.json()) } else { print(&looked.text()) };
    }
    args.refuse_of_pairs(system)?;
    if let Some(looked) = LawReport::new(system, &wanted, args.raggedness)? {
        return if args.json { print_json(looked.json()) } else { print(&looked.text()) };
    }
    let looked = LookupReport::new(&training, system, &wanted)?;
    if args.json { print_json(looked.json()) } else { print(&looked.text()) }
}

/// Answers all rows of `table`, or none if one is invalid.
fn run_batch(training: &Training, table: &Path, output: &Path) -> Result<(), Error> {
    let file = table.display().to_string();
    let opened = files::input(table);
    let opened = opened.map_err(|source| Error::File { file: file.clone(), done: "read", source })?;
    super::install();
    let mut answers = files::begin(output).map_err(Error::step)?;
    match answer_table(training, &file, opened, &mut answers) {
        Ok(()) => answers.finish().and_then(files::Prepared::keep).map_err(Error::step),
        Err(Error::Output(why)) => Err(Error::step(answers.stopped(why.into()))),
        Err(error) => Err(error),
    }
}

/// Writes the table in `input` with the answer in each row to `output`; `file` is its name in messages. At most a
/// thousand rows are in memory at a time. (This is part of the command line because cells are parsed like options.)
///
/// # Errors
/// The first invalid row, with line and column; a training set that cannot be read; [`Error::Output`] where `output` fails;
/// [`Error::Interrupted`].
pub fn answer_table(
    training: &Training,
    file: &str,
    input: impl Read,
    output: impl Write,
) -> Result<(), Error> {
    let mut questions = batch::Questions::new(file, input)?;
    let mut answers = batch::Answers::new(&questions, output)?;
    loop {
        if super::interrupted() {
            return Err(Error::Interrupted);
        }
        let rows = questions.next_rows(ROWS)?;
        if rows.is_empty() {
            return answers.finish();
        }
        let answered = rows.into_par_iter().map(|row| row.answered(training));
        answers.write(&answered.collect::<Result<Vec<_>, _>>()?)?;
    }
}

/// The number of rows of a table that are answered together.
const ROWS: usize = 1_000;
