//! `dapple grow` of a document with a model: a picture of it, a `.glb`, a `.ply`.

use std::io::Write;
use std::path::Path;
use std::sync::atomic::Ordering;

use super::textured::{self, Written};
use super::{Args, is_stdout};
use crate::cli::estimate::Estimate;
use crate::cli::progress::Bar;
use crate::cli::{self, Error};
use crate::document::{Body, BodySource, Document};
use crate::export::{Format, has_ending};
use crate::files::{self, read_model};
use crate::machine::clock::Instant;
use crate::machine::{free_memory, threads};
use crate::synth::body::{BodyGrowth, BodyLayerReport, BodyReport};
use crate::synth::{Options, Training, Watch};

/// Endings of files that hold models.
pub const MODELS: [&str; 4] = ["glb", "ply", "obj", "stl"];
/// The greatest height of marks, mm.
const MOST_MM: f64 = 1_000.0;

/// Options for models.
#[derive(clap::Args, Clone, Debug)]
pub struct BodyArgs {
    /// Grow on this file (OBJ, PLY, STL, GLB, glTF) instead of the model that the document names
    #[arg(long, value_name = "MODEL")]
    pub model: Option<std::path::PathBuf>,
    /// The direction from which the picture shows the model: degrees around it from the front, and above the horizon
    /// [default: -30,18]
    #[arg(long, value_name = "AZ,EL", value_parser = view, allow_hyphen_values = true)]
    pub view: Option<[f64; 2]>,
    /// Raise the marks of a model by MM millimetres, for a printer: with -o OUT.stl or OUT.ply; below 0 they are hollows
    #[arg(long, value_name = "MM", value_parser = millimetres, allow_hyphen_values = true)]
    pub displace: Option<f64>,
}

/// Whether a file of this name holds a model.
pub fn holds_model(path: &Path) -> bool {
    MODELS.iter().any(|ending| has_ending(path, ending))
}

/// Refuses what only a document with a model has.
///
/// # Errors
/// [`Error::Usage`] with what is allowed.
pub fn check_flat(args: &Args) -> Result<(), Error> {
    let file = args.file.display();
    if let Some(output) = args.output.as_deref().filter(|path| holds_model(path)) {
        let output = output.display();
        return Err(Error::Usage(format!(
            "--output: found {output}, which holds a model, and {file} has none; allowed: a picture or outlines, such as a .png"
        )));
    }
    let given = [
        ("--view", args.body.view.is_some()),
        ("--model", args.body.model.is_some()),
        ("--displace", args.body.displace.is_some()),
    ];
    match given.iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Error::Usage(format!(
            "{option}: {file} grows on no model; allowed: with a document that has a \"model\""
        ))),
        None => Ok(()),
    }
}

/// `AZ,EL`, degrees.
fn view(text: &str) -> Result<[f64; 2], String> {
    let allowed =
        "allowed: two numbers, degrees round the model and above the horizon (-90 to 90), such as 30,15";
    let parsed = text.split_once(',').and_then(|(azimuth, elevation)| {
        Some([azimuth.trim().parse().ok()?, elevation.trim().parse().ok()?])
    });
    let fits = |[azimuth, elevation]: &[f64; 2]| azimuth.is_finite() && (-90.0..=90.0).contains(elevation);
    parsed.filter(fits).ok_or_else(|| allowed.to_owned())
}

/// The height of marks, mm.
fn millimetres(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| number.abs() <= MOST_MM && *number != 0.0);
    number.ok_or_else(|| format!("allowed: numbers from -{MOST_MM} to {MOST_MM}, mm, but 0, such as 0.8"))
}

/// Refuses options that have no meaning for a document on a model.
fn check(args: &Args) -> Result<(), Error> {
    const FLAT: &str =
        "the pattern of a model is not flat; allowed: -o OUT.ply, which holds its colours by vertex";
    const LATER: &str = "the texture of a model cannot be varied by maps yet; leave the option out";
    let given = [
        ("--pattern", args.pattern.is_some(), FLAT),
        ("--labels", args.labels.is_some(), FLAT),
        ("--mask", args.mask.is_some(), FLAT),
        ("--layer", args.layer.is_some(), FLAT),
        ("--concentrations", args.concentrations.is_some(), FLAT),
        ("--svg", args.outlines.svg.is_some(), FLAT),
        ("--dxf", args.outlines.dxf.is_some(), FLAT),
        (
            "--depth",
            args.look.depth == 16 && args.material.material.is_none(),
            "pictures of models have 8 bits; allowed: with --material",
        ),
        ("--tone", args.tone.is_some(), LATER),
        ("--map", !args.maps.is_empty(), LATER),
    ];
    let found = given.iter().find(|(_, is_given, _)| *is_given);
    if let Some((option, _, reason)) = found {
        return Err(Error::Usage(format!("{option}: {}: {reason}", args.file.display())));
    }
    textured::check(args)?;
    let Some(output) = &args.output else { return Ok(()) };
    let pictures = Format::ENDINGS.iter().map(|(ending, _)| *ending);
    let endings: Vec<_> = pictures.chain(MODELS).collect();
    files::check_ending(output, &endings).map_err(Error::step)
}

/// Grows a document that has a model.
pub fn grow(args: &Args, document: &Document, body: &Body, training: &Training) -> Result<(), Error> {
    check(args)?;
    if let Some(threads) = args.threads {
        threads::set_shared(threads);
    }
    let model = read_model(&args.file, body, args.body.model.as_deref())?;
    let mut document = document.clone();
    if let (Some(path), Some(body)) = (&args.body.model, &mut document.model) {
        body.source = BodySource::File { path: path.display().to_string(), sha256: None };
    }
    let cancelled = cli::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let bar = Bar::new(args.quiet);
    let watch = Watch { progress: &|stage, share| bar.show(stage, share), cancelled: &cancelled };
    let source = files::source(&args.file);
    let started = Instant::now();
    let options = Options {
        refine: args.no_refine.then_some(false),
        source: &source,
        training,
        memory: Some(free_memory()),
        time: args.limits.time(),
        watch,
        ..Options::default()
    };
    let bytes = model.as_ref().map(|model| model.bytes.as_slice());
    let mut growth = BodyGrowth::begin(&document, bytes, &options)?;
    let seconds = loop {
        growth.advance(1).map_err(Error::grown)?;
        if let Some(seconds) = growth.seconds() {
            break seconds;
        }
    };
    let estimate = Estimate { training, quiet: args.quiet };
    estimate.announce_seconds(seconds / rayon::current_num_threads() as f64);
    let grown = growth.run().map_err(Error::grown)?;
    let written = textured::prepare(args, &grown, &watch);
    bar.clear();
    let Written { files: mut written, notes: said } = written?;
    let report = grown.report(&source, started.elapsed().as_secs_f64());
    if let Some(path) = args.report.as_ref().filter(|path| !is_stdout(path)) {
        let text = text(&report)?;
        written.push(files::prepare(path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(Error::step)?);
    }
    files::keep_all(written).map_err(Error::step)?;
    if args.report.as_deref().is_some_and(is_stdout) {
        cli::print(&text(&report)?)?;
    }
    if !args.quiet {
        if model.is_some_and(|model| model.is_changed) {
            cli::note(&format!("{} is not the file that it was when the document was made", body.source));
        }
        notes(&report).iter().chain(&said).for_each(|line| cli::note(line));
    }
    Ok(())
}

fn text(report: &BodyReport) -> Result<String, Error> {
    let text = serde_json::to_string(report).map_err(Error::step)?;
    let value: serde_json::Value = serde_json::from_str(&text).map_err(Error::step)?;
    Ok(format!("{:#}\n", cli::json::known(value)))
}

/// The notes of a report as lines for a terminal.
fn notes(report: &BodyReport) -> Vec<String> {
    let mut lines: Vec<String> =
        report.model.repairs.iter().map(|note| format!("{}: {note}", report.model.file)).collect();
    for BodyLayerReport { name, regions, notes, settled, .. } in &report.layers {
        lines.extend(notes.iter().map(|note| format!("{name}: {note}")));
        let mut said: Vec<&String> = regions.iter().flat_map(|region| &region.notes).collect();
        said.dedup();
        lines.extend(said.into_iter().take(super::MOST_NOTES).map(|note| format!("{name}: {note}")));
        if !settled {
            lines.push(format!("{name}: did not settle within the step limit; its last state is used"));
        }
    }
    lines
}
