//! `dapple import`: an SVG → a document with what is drawn in it.

use super::{Error, values};
use crate::export;
use crate::marks::{Ellipse, Line, Mark};
use crate::sketch::svg::{self, Drawing, SvgError};
use crate::synth::recipe::{Document, Kind, Layer, Stroke, limits};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// What to read, and where to write it.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The drawing: its ellipses, circles, lines, rectangles and paths become marks, its groups layers
    #[arg(value_name = "IN.svg")]
    pub file: PathBuf,
    /// Where to write the document
    #[arg(short, long, value_name = "OUT.dapple")]
    pub output: PathBuf,
    /// px an inch of the canvas; the SVG says its size in mm or in px of 1/96 inch
    #[arg(long, value_name = "N", default_value_t = svg::DPI, value_parser = values::dpi)]
    pub dpi: f64,
    /// Print what was read as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Do not tell what was read
    #[arg(short, long)]
    pub quiet: bool,
}

/// Why an SVG did not become a document.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// It is none.
    #[error("{file}: {source}")]
    Svg {
        /// The file.
        file: String,
        /// What is wrong with it.
        source: SvgError,
    },
    /// Its canvas.
    #[error("{file}: its canvas has {found} px; allowed: sides of 1 to {most} px; choose another --dpi", most = limits::MAX_SIDE)]
    Size {
        /// The file.
        file: String,
        /// Width × height.
        found: String,
    },
    /// No marks in it.
    #[error(
        "{file}: holds no marks{unread}; allowed: ellipses, circles, lines, rectangles and paths on its canvas"
    )]
    Nothing {
        /// The file.
        file: String,
        /// What it holds instead.
        unread: String,
    },
    /// More groups than a document has layers.
    #[error("{file}: its groups make {found} layers; allowed: {most}", most = limits::MAX_LAYERS)]
    Layers {
        /// The file.
        file: String,
        /// How many.
        found: usize,
    },
}

/// Reads the SVG and writes the document.
///
/// # Errors
/// Where the SVG cannot be read, holds no marks, or the document cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    export::check_ending(&args.output, &["dapple"]).map_err(Error::step)?;
    let file = args.file.display().to_string();
    let bytes =
        bytes(&args.file).map_err(|source| Error::File { file: file.clone(), done: "read", source })?;
    let drawing = svg::read(&bytes, args.dpi)
        .map_err(|source| Error::step(ImportError::Svg { file: file.clone(), source }))?;
    let (document, unread) = document(drawing, args, &file).map_err(Error::step)?;
    document.write(&args.output)?;
    let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    if args.json {
        let layer = |layer: &Layer| json!({"name": layer.name, "marks": layer.strokes.len()});
        let layers: Vec<Value> = document.layers.iter().map(layer).collect();
        let told = json!({"file": file, "document": args.output.display().to_string(), "size": document.size,
            "dpi": document.dpi, "marks": marks, "layers": layers, "unread": unread});
        super::say(&format!("{told:#}\n"))?;
    } else if !args.quiet {
        let unread = told_unread(&unread);
        let layers = document.layers.len();
        let [width, height] = document.size;
        let told = format!("{marks} marks in {layers} layers on {width} × {height} px{unread}");
        // Nobody left to tell is no reason to fail.
        let _ = writeln!(std::io::stderr(), "note: {file}: {told}");
    }
    Ok(())
}

fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take(limits::MAX_FILE).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What an SVG holds that is no mark, and how often.
type Unread = BTreeMap<&'static str, usize>;

/// Such as `; not read: 2 × text`.
fn told_unread(unread: &Unread) -> String {
    let unread: Vec<String> = unread.iter().map(|(kind, count)| format!("{count} × {kind}")).collect();
    if unread.is_empty() { String::new() } else { format!("; not read: {}", unread.join(", ")) }
}

fn document(mut drawing: Drawing, args: &Args, file: &str) -> Result<(Document, Unread), ImportError> {
    // What is a rounding error above whole px is whole.
    let sides = drawing.size.map(|side| (side - 1e-3).ceil().max(1.0));
    if sides.iter().any(|side| *side > limits::MAX_SIDE as f64) {
        let found = format!("{:.0} × {:.0}", sides[0], sides[1]);
        return Err(ImportError::Size { file: file.to_owned(), found });
    }
    let size = sides.map(|side| side as u32);
    let mut layers: Vec<Layer> = Vec::new();
    let mut off = 0;
    for group in std::mem::take(&mut drawing.groups) {
        let marks: Vec<Stroke> = group.marks.iter().filter_map(|mark| stroke(mark, size)).collect();
        off += group.marks.len() - marks.len();
        let (lines, ellipses): (Vec<Stroke>, Vec<Stroke>) =
            marks.into_iter().partition(|stroke| stroke.kind() == Some(Kind::Line));
        // A layer holds one kind.
        let both = !lines.is_empty() && !ellipses.is_empty();
        for (strokes, kind) in [(ellipses, "spots"), (lines, "lines")] {
            if !strokes.is_empty() {
                let name = match group.name.as_str() {
                    "" => kind.to_owned(),
                    name if both => format!("{name} {kind}"),
                    name => name.to_owned(),
                };
                let name = name.chars().take(limits::MAX_NAME).collect();
                layers.push(Layer { name, strokes, ..Layer::default() });
            }
        }
    }
    if off > 0 {
        drawing.unread.insert("mark off the canvas", off);
    }
    let unread = drawing.unread;
    if layers.is_empty() {
        return Err(ImportError::Nothing { file: file.to_owned(), unread: told_unread(&unread) });
    }
    if layers.len() > limits::MAX_LAYERS {
        return Err(ImportError::Layers { file: file.to_owned(), found: layers.len() });
    }
    let name =
        args.file.file_stem().map(|stem| stem.to_string_lossy().chars().take(limits::MAX_NAME).collect());
    let document =
        Document { name: name.unwrap_or_default(), size, dpi: args.dpi, layers, ..Document::default() };
    Ok((document, unread))
}

/// A mark as a document may hold it; `None` where it lies off the canvas.
fn stroke(mark: &Mark, size: [u32; 2]) -> Option<Stroke> {
    let thickness = limits::Range::thickness(size);
    let thick = |length: f64| rounded(length).clamp(thickness.low, thickness.high);
    let inside = |point: [f64; 2]| (0..2).all(|axis| limits::Range::inside(size[axis]).holds(point[axis]));
    let stroke = match *mark {
        Mark::Ellipse(Ellipse { center, radii, angle }) => Stroke::Ellipse(Ellipse {
            center: center.map(rounded),
            radii: radii.map(thick),
            angle: rounded(angle),
        }),
        Mark::Line(Line { from, to, width }) => {
            let [from, to] = [from, to].map(|end| end.map(rounded));
            Stroke::Line(Line { from, to, width: if width > 0.0 { thick(width) } else { Stroke::WIDTH } })
        }
    };
    let fits = match &stroke {
        Stroke::Ellipse(ellipse) => inside(ellipse.center),
        Stroke::Line(line) => {
            let around =
                |end: [f64; 2]| (0..2).all(|axis| limits::Range::around(size[axis]).holds(end[axis]));
            inside(line.center())
                && around(line.from)
                && around(line.to)
                && line.length() >= limits::MIN_LENGTH
        }
        Stroke::Freehand { .. } => false,
    };
    fits.then_some(stroke)
}

/// To a thousandth of a px: an SVG's numbers are no finer.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}
