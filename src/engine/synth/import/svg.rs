//! SVG → a document with the marks that are drawn in it.

use crate::document::{Document, Kind, Layer, Outline, Stroke, limits};
use crate::marks::{self, Ellipse, Line, Mark};
use crate::sketch::svg::{self, Drawing, SvgError};
use std::collections::BTreeMap;
use std::path::Path;

pub use crate::sketch::svg::DPI;

/// Why an SVG did not become a document.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// The file could not be read.
    #[error("{file}: cannot be read: {source}")]
    Unreadable {
        /// The file.
        file: String,
        /// Why.
        source: std::io::Error,
    },
    /// The file is not an SVG.
    #[error("{file}: {source}")]
    Svg {
        /// The file.
        file: String,
        /// What is wrong with it.
        source: SvgError,
    },
    /// Its canvas is too large.
    #[error("{file}: its canvas has {found} px; allowed: sides of 1 to {most} px; choose another --dpi", most = limits::MAX_SIDE)]
    Size {
        /// The file.
        file: String,
        /// Width × height.
        found: String,
    },
    /// It holds no marks.
    #[error(
        "{file}: holds no marks{unread}; allowed: ellipses, circles, lines, rectangles and paths on its canvas"
    )]
    Nothing {
        /// The file.
        file: String,
        /// What else it holds, in words.
        unread: String,
    },
    /// The drawing has more groups than a document has layers.
    #[error("{file}: its groups make {found} layers; allowed: {most}", most = limits::MAX_LAYERS)]
    Layers {
        /// The file.
        file: String,
        /// Their number.
        found: usize,
    },
}

/// A document read from an SVG.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The document.
    pub document: Document,
    /// A summary, such as `3 marks in 1 layers on 200 × 100 px; not read: 1 × text`.
    pub summary: String,
    /// What was not read.
    pub unread: Unread,
}

/// Counts of what an SVG holds that is no mark, by kind.
pub type Unread = BTreeMap<&'static str, usize>;

/// In words, such as `; not read: 2 × text`.
#[must_use]
pub fn unread_in_words(unread: &Unread) -> String {
    let unread: Vec<String> = unread.iter().map(|(kind, count)| format!("{count} × {kind}")).collect();
    if unread.is_empty() { String::new() } else { format!("; not read: {}", unread.join(", ")) }
}

/// Reads the SVG in `bytes` as a document named like `file`, and counts what was not read.
///
/// # Errors
/// [`ImportError`].
pub fn read_svg(bytes: &[u8], dpi: f64, file: &str) -> Result<(Document, Unread), ImportError> {
    let drawing =
        svg::read(bytes, dpi).map_err(|source| ImportError::Svg { file: file.to_owned(), source })?;
    document(drawing, dpi, file)
}

/// Bytes in which a drawing begins.
pub const START: u64 = 256;

/// Whether a file that begins with these bytes is a drawing: by the `<`; no picture of px begins with one.
#[must_use]
pub fn begins_a_drawing(start: &[u8]) -> bool {
    // Behind the mark of UTF-8, and spaces.
    let start = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start);
    start.trim_ascii_start().first() == Some(&b'<')
}

impl Imported {
    /// Reads the SVG in `bytes` as a document with `dpi` px an inch, named like `file`.
    ///
    /// # Errors
    /// [`ImportError`].
    pub fn read(bytes: &[u8], dpi: f64, file: &str) -> Result<Self, ImportError> {
        let (document, unread) = read_svg(bytes, dpi, file)?;
        let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
        let layers = document.layers.len();
        let [width, height] = document.size;
        let summary =
            format!("{marks} marks in {layers} layers on {width} × {height} px{}", unread_in_words(&unread));
        Ok(Self { document, summary, unread })
    }
}

fn document(mut drawing: Drawing, dpi: f64, file: &str) -> Result<(Document, Unread), ImportError> {
    // Rounding errors above whole px are cut.
    let sides = drawing.size.map(|side| (side - 1e-3).ceil().max(1.0));
    if sides.iter().any(|side| *side > limits::MAX_SIDE as f64) {
        let found = format!("{:.0} × {:.0}", sides[0], sides[1]);
        return Err(ImportError::Size { file: file.to_owned(), found });
    }
    let size = sides.map(|side| side as u32);
    let mut layers: Vec<Layer> = Vec::new();
    let mut off = 0;
    for group in std::mem::take(&mut drawing.groups) {
        let mut outlines = group.outlines;
        let drawn = |(index, mark): (usize, &Mark)| {
            let stroke = stroke(mark, size)?;
            Some(match outlines.remove(&index) {
                Some(corners) => with_outline(stroke, corners, size),
                None => stroke,
            })
        };
        let marks: Vec<Stroke> = group.marks.iter().enumerate().filter_map(drawn).collect();
        off += group.marks.len() - marks.len();
        let (lines, ellipses): (Vec<Stroke>, Vec<Stroke>) =
            marks.into_iter().partition(|stroke| stroke.kind() == Some(Kind::Line));
        // A layer holds one kind of marks.
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
        return Err(ImportError::Nothing { file: file.to_owned(), unread: unread_in_words(&unread) });
    }
    if layers.len() > limits::MAX_LAYERS {
        return Err(ImportError::Layers { file: file.to_owned(), found: layers.len() });
    }
    let name = Path::new(file)
        .file_stem()
        .map(|stem| stem.to_string_lossy().chars().take(limits::MAX_NAME).collect());
    let document = Document { name: name.unwrap_or_default(), size, dpi, layers, ..Document::default() };
    Ok((document, unread))
}

/// A mark as a stroke within the limits of documents; `None` where it lies off the canvas.
pub(super) fn stroke(mark: &Mark, size: [u32; 2]) -> Option<Stroke> {
    let thickness = limits::Range::thickness(size);
    let thick = |length: f64| rounded(length).clamp(thickness.low, thickness.high);
    let wide = |width: f64| if width > 0.0 { thick(width) } else { Stroke::WIDTH };
    let mark = match mark {
        Mark::Ellipse(Ellipse { center, radii, angle }) => Mark::Ellipse(Ellipse {
            center: center.map(rounded),
            radii: radii.map(thick),
            angle: rounded(*angle),
        }),
        Mark::Line(Line { from, to, width }) => {
            let [from, to] = [from, to].map(|end| end.map(rounded));
            Mark::Line(Line { from, to, width: wide(*width) })
        }
        Mark::Path(path) => {
            let path = path.with_points(|point| point.map(rounded));
            Mark::Path(marks::Path { width: wide(path.width), ..path })
        }
    };
    let mark = mark.cut(limits::Range::around_canvas(size));
    let has_extent = match &mark {
        Mark::Ellipse(_) => true,
        Mark::Line(line) => line.length() >= limits::MIN_LENGTH,
        Mark::Path(path) => {
            let [low, high] = path.bounds();
            (0..2).any(|axis| high[axis] - low[axis] >= limits::MIN_LENGTH)
        }
    };
    (has_extent && mark.is_on(size.map(f64::from))).then(|| Stroke::from(mark))
}

/// The stroke of an ellipse with the outline that it was fitted to, if a document can hold that.
fn with_outline(stroke: Stroke, corners: Vec<[f64; 2]>, size: [u32; 2]) -> Stroke {
    let [low, high] = limits::Range::around_canvas(size);
    let is_near = |point: &[f64; 2]| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&point[axis]));
    match (stroke, Outline::of(corners)) {
        (Stroke::Ellipse(ellipse), Some(outline)) if outline.points.iter().all(is_near) => {
            Stroke::Fitted { ellipse, outline }
        }
        (stroke, _) => stroke,
    }
}

/// Rounds to a thousandth of a px: numbers in an SVG are no finer.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}
