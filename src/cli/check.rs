//! `dapple check`: checks a document and lists its content.

mod body;
mod maps;

use super::Error;
use super::json::print_json;
use super::limits::Limits;
use super::settings::Settings;
use crate::document::sketch_notes::notes_on;
use crate::document::{Document, Layer, Stroke};
use crate::files;
use crate::grid::Edges;
use crate::machine::free_memory;
use crate::synth::check::check;
use crate::synth::{Options, Training};
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
    pub settings: Settings,
    #[command(flatten)]
    pub limits: Limits,
}

/// Reads a document and prints its content, the planned growth, and attributes that cannot be reached.
///
/// # Errors
/// The document is invalid, or cannot be grown with the memory that is free and in the time that is allowed; or a training set cannot be read.
pub fn run(args: &Args) -> Result<(), Error> {
    let document = args.settings.read(&args.file)?;
    let source = files::source(&args.file);
    let notes = notes_on(&document);
    let training = Training::default();
    let options = Options {
        source: &source,
        training: &training,
        memory: Some(free_memory()),
        time: args.limits.time(),
        ..Options::default()
    };
    if document.model.is_some() {
        return body::run(args, &document, &options, notes.iter().map(ToString::to_string).collect());
    }
    let checked = check(&document, &options).map_err(Error::grown)?;
    let verdict = if checked.refusal.is_none() { "valid" } else { "cannot be grown" };
    let mut text = format!("{}: {verdict}\n{}", super::escaped(&source), summary(&document));
    let mut layers = Vec::new();
    for (layer, described) in document.layers.iter().zip(checked.layers) {
        text += &(described.text + &maps::lines(layer));
        for note in &described.notes {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {note}");
        }
        layers.push(maps::with_maps(layer_json(layer, described.json), layer));
    }
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{note}");
    }
    if args.json {
        let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
        print_json(
            json!({"document": source, "valid": checked.refusal.is_none(), "name": document.name, "size": document.size,
            "regions": document.regions, "edges": edges, "seed": document.seed, "layers": layers, "sketch": notes}),
        )?;
    } else {
        super::print(&text)?;
    }
    checked.refusal.map_or(Ok(()), |refusal| Err(Error::grown(refusal)))
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
        None => writeln!(text, "regions: none, each mark sets what grows around it"),
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
