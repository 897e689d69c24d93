//! Makes a document from the marks in an SVG.

use crate::document::{Colours, Document, Kind, Layer, Outline, Stop, Stroke, limits};
use crate::marks::{self, Ellipse, Line, Mark};
use crate::photo::{Foreign, foreign};
use crate::sketch::svg::{self, Drawing, SvgError};
use std::collections::BTreeMap;
use std::path::Path;

pub use crate::sketch::svg::DPI;

/// The reason why an SVG did not become a document.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// The file could not be read.
    #[error("{file}: cannot be read: {source}")]
    Unreadable {
        /// The file.
        file: String,
        /// The reason.
        source: std::io::Error,
    },
    /// The file is not an SVG.
    #[error("{file}: {source}")]
    Svg {
        /// The file.
        file: String,
        /// The reason.
        source: SvgError,
    },
    /// The file is of another kind.
    #[error("{file}: it is {what}; allowed: an SVG, or a photograph (JPEG, PNG, WebP, TIFF, BMP, GIF); {remedy}", what = found.what, remedy = found.remedy)]
    Foreign {
        /// The file.
        file: String,
        /// The kind of file.
        found: Foreign,
    },
    /// Its canvas is too large.
    #[error("{file}: its canvas has {found} px; allowed: sides of 1 to {most} px; choose another --dpi", most = limits::MAX_SIDE)]
    Size {
        /// The file.
        file: String,
        /// Width × height.
        found: String,
    },
    /// The file holds no marks.
    #[error(
        "{file}: holds no marks{unread}; allowed: ellipses, circles, lines, rectangles and paths on its canvas"
    )]
    Nothing {
        /// The file.
        file: String,
        /// Other contents of the file, in words.
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
    /// Contents that were not read.
    pub unread: Unread,
    /// The colour of the shape that covers the canvas, sRGB.
    pub ground: Option<[u8; 3]>,
}

/// Counts of the contents of an SVG that are no marks, by kind.
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
pub fn read_svg(bytes: &[u8], dpi: Option<f64>, file: &str) -> Result<(Document, Unread), ImportError> {
    document(drawing(bytes, dpi, file)?, file)
}

fn drawing(bytes: &[u8], dpi: Option<f64>, file: &str) -> Result<Drawing, ImportError> {
    if let Some(found) = foreign(bytes).filter(|found| !found.is_text() && !svg::is_compressed(bytes)) {
        return Err(ImportError::Foreign { file: file.to_owned(), found });
    }
    svg::read(bytes, dpi).map_err(|source| ImportError::Svg { file: file.to_owned(), source })
}

/// Number of first bytes of a file that are searched for the start of a drawing.
pub const START: u64 = 256;

/// Whether a file that begins with these bytes is a drawing: it begins with `<`, as no picture of px does, or is compressed.
#[must_use]
pub fn begins_a_drawing(start: &[u8]) -> bool {
    // The `<` may follow the byte order mark of UTF-8 or UTF-16, and spaces; in UTF-16 a zero precedes or follows it.
    let start = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start);
    let wide = [&b"\xff\xfe"[..], b"\xfe\xff"].into_iter().find_map(|mark| start.strip_prefix(mark));
    let start = wide.unwrap_or(start);
    let start = start.strip_prefix(b"\0").unwrap_or(start);
    start.trim_ascii_start().first() == Some(&b'<') || svg::is_compressed(start)
}

/// Pattern values of ground and marks: the edge is at ½, and the narrow transition paints sharp edges.
const STOPS: [f64; 4] = [0.0, 0.41, 0.59, 1.0];

/// The colours of a layer whose marks have these colours; `None` if the drawing has black marks without a ground, and so gives no
/// colours.
fn colours(ground: Option<[u8; 3]>, marks: &[[u8; 3]]) -> Option<Colours> {
    let mark = svg::commonest(marks)?;
    let paper = ground.unwrap_or([u8::MAX; 3]);
    let is_said = ground.is_some() || mark != [0; 3];
    is_said.then(|| Colours::new(STOPS.into_iter().zip([paper, paper, mark, mark])))
}

impl Imported {
    /// Reads the SVG in `bytes` as a document with `dpi` px an inch (`None` = the number in the SVG), named like `file`.
    ///
    /// # Errors
    /// [`ImportError`].
    pub fn read(bytes: &[u8], dpi: Option<f64>, file: &str) -> Result<Self, ImportError> {
        let drawing = drawing(bytes, dpi, file)?;
        let ground = drawing.ground;
        let (document, unread) = document(drawing, file)?;
        let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
        let layers = document.layers.len();
        let [width, height] = document.size;
        let summary =
            format!("{marks} marks in {layers} layers on {width} × {height} px{}", unread_in_words(&unread));
        let on =
            ground.map_or_else(String::new, |ground| format!("; ground {}", Stop::opaque(0.0, ground).hex()));
        Ok(Self { document, summary: summary + &on, unread, ground })
    }
}

fn document(mut drawing: Drawing, file: &str) -> Result<(Document, Unread), ImportError> {
    // Excesses over whole px from rounding are cut off: lengths in mm have three decimal digits.
    let sides = drawing.size.map(|side| (side - 0.02).ceil().max(1.0));
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
            let stroke = match outlines.remove(&index) {
                Some(corners) => with_outline(stroke, corners, size),
                None => stroke,
            };
            Some((stroke, group.colours[index]))
        };
        let marks: Vec<(Stroke, [u8; 3])> = group.marks.iter().enumerate().filter_map(drawn).collect();
        off += group.marks.len() - marks.len();
        let (lines, ellipses): (Vec<_>, Vec<_>) =
            marks.into_iter().partition(|(stroke, _)| stroke.kind() == Some(Kind::Line));
        // A layer holds one kind of marks.
        let both = !lines.is_empty() && !ellipses.is_empty();
        for (painted, kind) in [(ellipses, "spots"), (lines, "lines")] {
            if !painted.is_empty() {
                let name = match group.name.as_str() {
                    "" => kind.to_owned(),
                    name if both => format!("{name} {kind}"),
                    name => name.to_owned(),
                };
                let name = name.chars().take(limits::MAX_NAME).collect();
                let (strokes, painted): (Vec<Stroke>, Vec<[u8; 3]>) = painted.into_iter().unzip();
                let colours = colours(drawing.ground, &painted);
                layers.push(Layer { name, strokes, colours, ..Layer::default() });
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
    let document =
        Document { name: name.unwrap_or_default(), size, dpi: drawing.dpi, layers, ..Document::default() };
    Ok((document, unread))
}

/// The stroke for a mark, within the limits of documents; `None` if the mark lies outside the canvas.
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

/// Rounds to a thousandth of a px; finer digits in an SVG have no meaning.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}
