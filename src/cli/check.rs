//! `dapple check`: is a document valid, and what is in it.

use super::Error;
use crate::field::Edges;
use crate::synth::recipe::{Document, Kind, Layer};
use std::fmt::Write;
use std::path::PathBuf;

/// What to check.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
}

/// Reads a document and says what is in it.
///
/// # Errors
/// Where it is not valid.
pub fn run(args: &Args) -> Result<(), Error> {
    let document = Document::read(&args.file)?;
    super::say(&format!("{}: valid\n{}", args.file.display(), summary(&document)))
}

fn summary(document: &Document) -> String {
    let mut text = String::new();
    let [width, height] = document.size;
    let [columns, rows] = document.regions;
    let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
    // Writing to a String cannot fail.
    let _ = writeln!(text, "name:    {}", printable(&document.name));
    let _ = writeln!(text, "size:    {width} × {height} px, edges {edges}");
    let _ = writeln!(text, "regions: {columns} × {rows}");
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
    let kinds = [(Some(Kind::Ellipse), "ellipse"), (Some(Kind::Line), "line"), (None, "freehand stroke")];
    let counted = kinds.iter().filter_map(|(kind, name)| {
        let n = layer.strokes.iter().filter(|stroke| stroke.kind() == *kind).count();
        (n > 0).then(|| format!("{n} {name}{}", if n == 1 { "" } else { "s" }))
    });
    counted.collect::<Vec<_>>().join(", ")
}

/// A name without the characters that would act on a terminal.
fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { '�' } else { c }).collect()
}
