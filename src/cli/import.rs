//! `dapple import`: SVG → document with its shapes as marks.

use super::{Error, values};
use crate::export;
use crate::synth::import::{DPI, ImportError, Imported, import};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Arguments of `dapple import`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The drawing: its ellipses, circles, lines, rectangles and paths become marks, its groups layers
    #[arg(value_name = "IN.svg")]
    pub file: PathBuf,
    /// Where to write the document
    #[arg(short, long, value_name = "OUT.dapple")]
    pub output: PathBuf,
    /// px an inch of the canvas; the SVG says its size in mm or in px of 1/96 inch
    #[arg(long, value_name = "N", default_value_t = DPI, value_parser = values::dpi)]
    pub dpi: f64,
    /// Print what was read as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Do not print a note about what was read
    #[arg(short, long)]
    pub quiet: bool,
}

/// Reads the SVG and writes the document.
///
/// # Errors
/// The SVG cannot be read or has no marks, or the document cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    super::paths::check_apart("IN.svg", &args.file, &args.output)?;
    export::check_ending(&args.output, &["dapple"]).map_err(Error::step)?;
    let imported = import(&args.file, args.dpi).map_err(|error| match error {
        ImportError::Unreadable { file, source } => Error::File { file, done: "read", source },
        other => Error::step(other),
    })?;
    imported.document.write(&args.output)?;
    if args.json {
        super::print(&format!("{:#}\n", summary(args, &imported)))?;
    } else if !args.quiet {
        super::note(&format!("{}: {}", args.file.display(), imported.summary));
    }
    Ok(())
}

/// What was read, as JSON.
fn summary(args: &Args, Imported { document, unread, .. }: &Imported) -> Value {
    let layers =
        document.layers.iter().map(|layer| json!({"name": layer.name, "marks": layer.strokes.len()}));
    let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    json!({
        "file": args.file.display().to_string(), "document": args.output.display().to_string(),
        "size": document.size, "dpi": document.dpi, "marks": marks, "layers": layers.collect::<Vec<_>>(),
        "unread": unread,
    })
}
