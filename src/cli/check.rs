//! `dapple check`: checks a document and lists its content.

mod maps;

use super::Error;
use super::json::print_json;
use super::limits::Limits;
use crate::document::sketch_notes::notes_on;
use crate::document::{Document, Layer, Stroke};
use crate::files::ReadFile;
use crate::grid::Edges;
use crate::machine::free_memory;
use crate::synth::kind::{Described, Request};
use crate::synth::time::TimeLimit;
use crate::synth::{GrowError, LayerPlan, Training};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// Arguments of `dapple check`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub limits: Limits,
}

/// Reads a document and prints its content, the planned growth, and attributes that cannot be reached.
///
/// # Errors
/// The document is invalid, a training set cannot be read, or a layer needs more memory than is free or more time than is allowed.
pub fn run(args: &Args) -> Result<(), Error> {
    let document = Document::read(&args.file)?;
    let source = args.file.display().to_string();
    let mut text = format!("{source}: valid\n{}", summary(&document));
    let notes = notes_on(&document);
    let training = Training::default();
    let mut beneath: Option<LayerPlan> = None;
    let (mut seconds, mut refusals) = (0.0, Vec::new());
    let mut layers = Vec::new();
    let (size, memory) = (document.size.map(f64::from), Some(free_memory()));
    for (index, layer) in document.layers.iter().enumerate() {
        let (document, source, training) = (&document, source.as_str(), &training);
        let below = beneath.as_ref().map(LayerPlan::own);
        let request = Request { document, index, source, size, training, memory, beneath: below };
        let Checked { plan, seconds: own, described, refused } =
            checked(&request, args.limits.time(), seconds)?;
        seconds += own;
        refusals.extend(refused);
        text += &(described.text + &maps::lines(layer));
        for note in &described.notes {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {note}");
        }
        layers.push(maps::with_maps(layer_json(layer, described.json), layer));
        beneath = plan;
    }
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{note}");
    }
    if args.json {
        let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
        print_json(json!({"document": source, "valid": true, "name": document.name, "size": document.size,
            "regions": document.regions, "edges": edges, "seed": document.seed, "layers": layers, "sketch": notes}))?;
    } else {
        super::print(&text)?;
    }
    refusals.into_iter().next().map_or(Ok(()), |refused| Err(Error::grown(refused)))
}

/// What is known of a layer.
struct Checked {
    /// Its plan; none of what is too large to be planned.
    plan: Option<LayerPlan>,
    /// Seconds that it takes on one core.
    seconds: f64,
    described: Described,
    /// Why it cannot be grown here.
    refused: Option<GrowError>,
}

/// Plans a layer, above others that take so many seconds.
fn checked(request: &Request, time: TimeLimit, beneath: f64) -> Result<Checked, Error> {
    let cannot = |error: &GrowError| format!("cannot be grown: {error}");
    let plan = match LayerPlan::read(request) {
        Ok(plan) => plan,
        Err(GrowError::TooLarge(error)) => {
            let json = json!({"grid": error.grid, "notes": [cannot(&error.into())]});
            let described = Described::new(String::new(), vec![cannot(&error.into())], json);
            return Ok(Checked { plan: None, seconds: 0.0, described, refused: Some(error.into()) });
        }
        Err(error) => return Err(Error::grown(error)),
    };
    let fits = plan.fits(request).map_err(GrowError::from);
    let seconds = plan.seconds();
    let in_time = time.allows(beneath + seconds, request.size, request.index + 1);
    let refused = fits.and_then(|()| Ok(in_time?)).err();
    let described = plan.describe(request, refused.iter().map(cannot).collect());
    Ok(Checked { plan: Some(plan), seconds, described, refused })
}

/// What `check --json` says of a layer.
fn layer_json(layer: &Layer, own: Map<String, Value>) -> Value {
    let mut json = json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible,
        "drawn": drawn(layer)});
    if let Some(all) = json.as_object_mut() {
        all.extend(own);
    }
    json
}

/// How many strokes of each kind were drawn.
fn drawn(layer: &Layer) -> Map<String, Value> {
    counts(layer).into_iter().map(|(name, n)| (name.replace(' ', "_"), json!(n))).collect()
}

fn summary(document: &Document) -> String {
    let mut text = String::new();
    let [width, height] = document.size;
    let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
    // Writing to a String cannot fail.
    let _ = writeln!(text, "name:    {}", printable(&document.name));
    let _ = writeln!(text, "size:    {width} × {height} px, edges {edges}");
    let _ = match document.regions {
        Some([columns, rows]) => writeln!(text, "regions: {columns} × {rows}"),
        None => writeln!(text, "regions: none, each mark says what is wanted around it"),
    };
    let _ = writeln!(text, "layers:  {}", document.layers.len());
    for (i, layer) in document.layers.iter().enumerate() {
        let name = printable(&layer.name);
        let hidden = if layer.visible { "" } else { ", hidden" };
        let (system, after) = (layer.system.name(), layer.after.name());
        let _ = writeln!(text, "  {}. {name}: {} ({system}, {after}{hidden})", i + 1, marks(layer));
    }
    text
}

/// Such as `12 ellipses, 1 freehand stroke`.
fn marks(layer: &Layer) -> String {
    let counted =
        counts(layer).into_iter().map(|(name, n)| format!("{n} {name}{}", if n == 1 { "" } else { "s" }));
    let drawn = counted.collect::<Vec<_>>().join(", ");
    if drawn.is_empty() { "nothing drawn".to_owned() } else { drawn }
}

/// The number of drawn strokes of each kind, without kinds that do not occur.
fn counts(layer: &Layer) -> Vec<(&'static str, usize)> {
    let name = |stroke: &Stroke| match stroke {
        Stroke::Ellipse(_) | Stroke::Fitted { .. } => "ellipse",
        Stroke::Line(_) => "line",
        Stroke::Path(_) => "path",
        Stroke::Freehand { .. } => "freehand stroke",
        Stroke::Outline(_) => "outline",
    };
    let count = |kind| layer.strokes.iter().filter(|stroke| name(stroke) == kind).count();
    let names = ["ellipse", "line", "path", "freehand stroke", "outline"];
    names.into_iter().map(|kind| (kind, count(kind))).filter(|(_, n)| *n > 0).collect()
}

/// A name with control characters replaced.
fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { '�' } else { c }).collect()
}
