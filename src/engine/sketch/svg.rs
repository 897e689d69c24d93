//! SVG → marks: shapes become the ellipses and lines that the same shapes drawn by hand would become.
//!
//! A filled rectangle longer than three times its width becomes a line. What is clipped away or fully transparent is not read.
//! Transforms are applied; the results are in px of the canvas. A closed shape becomes an ellipse as a closed stroke does,
//! an open one a path or a line (or, where it is nearly closed, an ellipse). What covers the canvas is the ground; a fill by a
//! pattern gives the marks of its tiles.

mod bar;
mod ground;
mod names;
mod paint;
mod pattern;
mod reader;
mod strokes;
mod text;
mod visibility;

use std::collections::{BTreeMap, BTreeSet};

use usvg::roxmltree::{self, Node as Element};
use usvg::{ImageHrefResolver, Options, Tree};

use crate::marks::Mark;
use names::Names;
pub use paint::commonest;
use reader::Reader;
pub use text::is_compressed;

/// px an inch of an SVG.
pub const DPI: f64 = 96.0;
/// px an inch that a file may say.
const DPIS: std::ops::RangeInclusive<f64> = 1.0..=100_000.0;
/// The most marks of an SVG; a sketch has dozens.
const MOST: usize = 100_000;

/// What was read from an SVG.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width and height, px.
    pub size: [f64; 2],
    /// px an inch.
    pub dpi: f64,
    /// The colour of what covers the canvas, sRGB.
    pub ground: Option<[u8; 3]>,
    /// Its layers: groups at the top, and those inside of them that have names. The first, with an empty name, holds the shapes outside
    /// groups.
    pub groups: Vec<Group>,
    /// Kinds of elements that could not be read, and how many of each.
    pub unread: BTreeMap<&'static str, usize>,
}

/// Marks that belong together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// The group's label or id.
    pub name: String,
    /// What is in it.
    pub marks: Vec<Mark>,
    /// The colour of each mark, sRGB.
    pub colours: Vec<[u8; 3]>,
    /// The corners of closed shapes that are no ellipses, px, by the index of their mark.
    pub outlines: BTreeMap<usize, Vec<[f64; 2]>>,
}

/// Why an SVG could not be read at all.
#[derive(Debug, thiserror::Error)]
pub enum SvgError {
    /// Not XML, or cut short.
    #[error("is no SVG: {}; allowed: a plain SVG file, such as drawing programs save", shown(.0))]
    NotXml(roxmltree::Error),
    /// Not text.
    #[error("is no SVG: it is no text; allowed: an SVG file, such as drawing programs save")]
    NotText,
    /// Compressed data that are damaged, or too many.
    #[error(
        "is no SVG: its compressed data are damaged or too large ({0}); allowed: a whole .svgz file, or a plain .svg file"
    )]
    Packed(String),
    /// Valid XML, but not a valid SVG.
    #[error("cannot be read as SVG: {}; open it in a drawing program and save it as plain SVG", shown(.0))]
    NotSvg(usvg::Error),
    /// Groups are nested too deep.
    #[error("has groups nested {found} deep; allowed: {DEEPEST}; ungroup it in a drawing program")]
    TooDeep {
        /// How deep.
        found: usize,
    },
    /// More shapes than a sketch has.
    #[error("holds more than {MOST} shapes; allowed: a sketch of at most so many")]
    TooMany,
}

/// The message of an XML reader, cut to a length and without control characters: it quotes the file.
fn shown(error: &dyn std::error::Error) -> String {
    const LONGEST: usize = 200;
    let said = error.to_string();
    let cut = if said.chars().count() > LONGEST { "…" } else { "" };
    let plain = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    let start: String = said.chars().take(LONGEST).map(plain).collect();
    format!("{start}{cut}")
}

/// The deepest nesting of elements: the readers are recursive and would overflow the stack.
const DEEPEST: usize = 200;

/// Reads an SVG, with `dpi` px an inch; `None` = as many as the file says that it was drawn with, or [`DPI`].
///
/// ```
/// use dapple_engine::sketch::svg;
///
/// let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="100" height="80"><circle cx="50" cy="40" r="9"/></svg>"#;
/// let drawing = svg::read(text.as_bytes(), None)?;
/// assert_eq!(drawing.size, [100.0, 80.0]);
/// assert_eq!(drawing.groups[0].marks.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Where it is not an SVG, or holds too much for a sketch.
pub fn read(bytes: &[u8], dpi: Option<f64>) -> Result<Drawing, SvgError> {
    let mut text = text::text(bytes)?;
    check_depth(&text)?;
    if let Some(with_points) = text::with_points(&text) {
        text = with_points;
    }
    let xml = roxmltree::Document::parse_with_options(&text, text::options()).map_err(SvgError::NotXml)?;
    // Before the shapes are made into paths, which takes long.
    let shapes = xml.descendants().filter(is_shape).count();
    if shapes > MOST {
        return Err(SvgError::TooMany);
    }
    // Pictures are not loaded, neither embedded nor linked ones.
    let none =
        ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = Options { image_href_resolver: none, dpi: DPI as f32, ..Options::default() };
    let tree = Tree::from_xmltree(&xml, &options).map_err(SvgError::NotSvg)?;
    let drawn = || xml.root_element().attribute("data-dpi")?.parse().ok().filter(|dpi| DPIS.contains(dpi));
    let dpi = dpi.or_else(drawn).unwrap_or(DPI);
    let scale = dpi / DPI;
    let size = [tree.size().width(), tree.size().height()].map(|side| f64::from(side) * scale);
    let drawing = Drawing { size, dpi, ..Drawing::default() };
    let mut reader = Reader { scale, names: Names::of(&xml), drawing, paths: 0 };
    reader.count_unread(&xml);
    reader.top_level(tree.root())?;
    reader.count_undrawn(&xml, shapes);
    reader.drawing.groups.retain(|group| !group.marks.is_empty());
    Ok(reader.drawing)
}

/// Refuses elements that are nested too deep, before a recursive reader sees them.
fn check_depth(text: &str) -> Result<(), SvgError> {
    let (mut depth, mut deepest) = (0_usize, 0);
    for tag in text.split('<').skip(1) {
        let tag = tag.split('>').next().unwrap_or_default();
        if tag.starts_with('/') {
            depth = depth.saturating_sub(1);
        } else if !tag.ends_with('/') && !tag.starts_with(['!', '?']) {
            depth += 1;
            deepest = deepest.max(depth);
        }
    }
    if deepest > DEEPEST { Err(SvgError::TooDeep { found: deepest }) } else { Ok(()) }
}

/// Elements that are drawn as paths.
const SHAPES: [&str; 8] = ["path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "use"];

/// Whether an element is drawn as a path.
fn is_shape(element: &Element) -> bool {
    SHAPES.contains(&element.tag_name().name()) && !is_hidden(element)
}

/// Whether an element is drawn only where others refer to it.
fn is_hidden(element: &Element) -> bool {
    let hidden = ["defs", "symbol", "clipPath", "mask", "pattern", "marker"];
    element.ancestors().any(|above| hidden.contains(&above.tag_name().name()))
}

/// A property of an element, by its own attribute or style.
fn property<'a>(element: &Element<'a, '_>, name: &str) -> Option<&'a str> {
    let style = element.attribute("style").into_iter().flat_map(|style| style.split(';'));
    let in_style = style.filter_map(|part| part.split_once(':')).find(|(key, _)| key.trim() == name);
    in_style.map(|(_, value)| value.trim()).or_else(|| element.attribute(name))
}

/// Whether an element is not drawn because a style says so.
fn is_off(element: &Element) -> bool {
    property(element, "display") == Some("none")
}

/// Shapes that are filled by patterns without any shapes, such as of pictures: of these usvg leaves nothing.
fn filled_by_no_shapes(xml: &roxmltree::Document) -> usize {
    let empty =
        |pattern: &Element| !pattern.descendants().any(|inside| SHAPES.contains(&inside.tag_name().name()));
    let patterns = xml.descendants().filter(|element| element.tag_name().name() == "pattern");
    let ids: BTreeSet<&str> = patterns.filter(empty).filter_map(|pattern| pattern.attribute("id")).collect();
    let is_filled_so = |shape: &Element| {
        let fill = shape.ancestors().find_map(|element| property(&element, "fill")).unwrap_or_default();
        let id = fill.strip_prefix("url(#").and_then(|rest| rest.split(')').next());
        id.is_some_and(|id| ids.contains(id))
    };
    xml.descendants().filter(is_shape).filter(is_filled_so).count()
}

#[cfg(test)]
mod tests;
