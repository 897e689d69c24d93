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
mod strokes;
mod text;
mod visibility;

use std::collections::BTreeMap;

use usvg::roxmltree::{self, Node as Element};
use usvg::tiny_skia_path::Transform;
use usvg::{ImageHrefResolver, Node, Options, Paint, Tree};

use super::{fit_outline, recognise};
use crate::marks::{Mark, fit};
use bar::bar;
use ground::Area;
use names::Names;
pub use paint::commonest;
use strokes::{Drawn, encloses, strokes};
pub use text::is_compressed;
use visibility::Visibility;

/// px an inch of an SVG.
pub const DPI: f64 = 96.0;
/// px an inch that a file may say.
const DPIS: std::ops::RangeInclusive<f64> = 1.0..=100_000.0;
/// The share of its area by which a shape may differ from the ellipse that it is: curves are drawn as polygons.
const SAME: f64 = 0.01;
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

/// Whether an element is drawn as a path.
fn is_shape(element: &Element) -> bool {
    let names = ["path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "use"];
    names.contains(&element.tag_name().name()) && !is_hidden(element)
}

/// Whether an element is drawn only where others refer to it.
fn is_hidden(element: &Element) -> bool {
    let hidden = ["defs", "symbol", "clipPath", "mask", "pattern", "marker"];
    element.ancestors().any(|above| hidden.contains(&above.tag_name().name()))
}

/// Whether an element is not drawn because a style says so.
fn is_off(element: &Element) -> bool {
    let of = |name: &str, value: &str| {
        let in_style = |style: &str| {
            style
                .split(';')
                .filter_map(|part| part.split_once(':'))
                .any(|(key, found)| key.trim() == name && found.trim() == value)
        };
        element.attribute(name) == Some(value) || element.attribute("style").is_some_and(in_style)
    };
    of("display", "none")
}

struct Reader {
    scale: f64,
    names: Names,
    drawing: Drawing,
    /// Paths that were seen.
    paths: usize,
}

/// A mark and its colour.
struct Painted {
    mark: Mark,
    colour: [u8; 3],
    /// The corners of a closed shape that is no ellipse.
    corners: Option<Vec<[f64; 2]>>,
}

impl Reader {
    fn unread(&mut self, kind: &'static str) {
        *self.drawing.unread.entry(kind).or_default() += 1;
    }

    /// Counts elements that give no path.
    fn count_unread(&mut self, xml: &roxmltree::Document) {
        for element in xml.descendants().filter(|element| !is_hidden(element)) {
            match element.tag_name().name() {
                "text" | "flowRoot" => self.unread("text"),
                "image" => self.unread("image"),
                "foreignObject" => self.unread("foreign object"),
                "animate" | "animateTransform" | "animateMotion" => self.unread("animation"),
                _ => {}
            }
            if is_shape(&element) && element.ancestors().any(|above| is_off(&above)) {
                self.unread("hidden shape");
            }
        }
    }

    /// Counts shapes of which nothing is drawn: without extent, or with neither fill nor stroke.
    fn count_undrawn(&mut self, xml: &roxmltree::Document, shapes: usize) {
        let names = ["use", "switch", "marker"];
        let is_counted = !xml.descendants().any(|element| names.contains(&element.tag_name().name()));
        let hidden = self.drawing.unread.get("hidden shape").copied().unwrap_or_default();
        let undrawn = shapes.saturating_sub(hidden + self.paths);
        if is_counted && undrawn > 0 {
            self.drawing.unread.insert("shape that draws nothing", undrawn);
        }
    }

    /// Reads the top-level groups; a single nameless group around everything is skipped.
    fn top_level(&mut self, mut root: &usvg::Group) -> Result<(), SvgError> {
        let mut seen = Visibility::default().inside(root, self.scale);
        while let [Node::Group(only)] = root.children()
            && only.id().is_empty()
        {
            root = only;
            seen = seen.inside(root, self.scale);
        }
        self.drawing.groups.push(Group::default());
        let mut nameless = 0;
        for node in root.children() {
            // usvg puts a transformed shape into a nameless group of its own.
            let group = match node {
                Node::Group(group) if !group.id().is_empty() || group.children().len() > 1 => group,
                node => {
                    self.node(node, 0, &seen)?;
                    continue;
                }
            };
            let name = self.names.name(group.id()).unwrap_or(group.id()).to_owned();
            nameless += usize::from(name.is_empty());
            let name = if name.is_empty() { format!("group {nameless}") } else { name };
            self.layer(name, group, &seen)?;
        }
        Ok(())
    }

    /// Reads a group as a layer of its own.
    fn layer(&mut self, name: String, group: &usvg::Group, around: &Visibility) -> Result<(), SvgError> {
        self.drawing.groups.push(Group { name, ..Group::default() });
        let at = self.drawing.groups.len() - 1;
        self.group(group, at, around)
    }

    fn group(&mut self, group: &usvg::Group, at: usize, around: &Visibility) -> Result<(), SvgError> {
        if group.mask().is_some() {
            self.unread("mask");
        }
        let seen = around.inside(group, self.scale);
        group.children().iter().try_for_each(|node| self.node(node, at, &seen))
    }

    fn node(&mut self, node: &Node, at: usize, seen: &Visibility) -> Result<(), SvgError> {
        match node {
            Node::Group(group) if self.names.is_layer(group.id()) => {
                let name = self.names.name(group.id()).unwrap_or_default().to_owned();
                self.layer(name, group, seen)?;
            }
            Node::Group(group) => self.group(group, at, seen)?,
            Node::Path(path) => {
                self.paths += 1;
                if path.is_visible() { self.path(path, at, seen) } else { self.unread("hidden path") }
            }
            // Counted as elements.
            Node::Image(_) | Node::Text(_) => {}
        }
        let marks: usize = self.drawing.groups.iter().map(|group| group.marks.len()).sum();
        if marks > MOST { Err(SvgError::TooMany) } else { Ok(()) }
    }

    fn path(&mut self, path: &usvg::Path, at: usize, seen: &Visibility) {
        let drawn = strokes(path.data(), path.abs_transform(), self.scale);
        if let Some(Paint::Pattern(pattern)) = path.fill().map(usvg::Fill::paint) {
            self.pattern(pattern, path, &drawn, at, seen);
            return;
        }
        if self.covers(path, &drawn, seen) {
            self.ground(path, seen);
            return;
        }
        for painted in self.painted(path, path.abs_transform(), seen) {
            self.add(painted, at);
        }
    }

    /// Whether a shape covers the canvas, filled or as a frame.
    fn covers(&self, path: &usvg::Path, drawn: &[Drawn], seen: &Visibility) -> bool {
        let closed: Vec<&Drawn> =
            drawn.iter().filter(|drawn| drawn.closed || path.fill().is_some()).collect();
        let rule = path.fill().map_or_else(Default::default, usvg::Fill::rule);
        Area::canvas(self.drawing.size).is_covered(&closed, rule, |place| seen.shows(place))
    }

    /// Takes a shape that covers the canvas for the ground.
    fn ground(&mut self, path: &usvg::Path, seen: &Visibility) {
        let Some(fill) = path.fill().filter(|fill| fill.opacity().get() * seen.opacity() > 0.0) else {
            self.unread(if path.stroke().is_some() { "frame" } else { "transparent shape" });
            return;
        };
        if self.drawing.groups.iter().any(|group| !group.marks.is_empty()) {
            self.unread("shape over the whole canvas");
        } else if let Some(colour) = paint::colour(fill.paint()) {
            let opacity = fill.opacity().get() * seen.opacity();
            self.drawing.ground = Some(paint::over(colour, opacity, self.paper()));
        }
    }

    /// The colour beneath the marks: white without a ground.
    fn paper(&self) -> [u8; 3] {
        self.drawing.ground.unwrap_or([u8::MAX; 3])
    }

    /// The colour of a shape: of its fill, or else of its stroke.
    fn colour(&self, path: &usvg::Path, seen: &Visibility) -> [u8; 3] {
        let fill = path.fill().map(|fill| (fill.paint(), fill.opacity().get()));
        let pen = path.stroke().map(|pen| (pen.paint(), pen.opacity().get()));
        let shown = fill.filter(|(_, opacity)| *opacity > 0.0).or(pen);
        let painted = shown.and_then(|(paint, opacity)| Some((paint::colour(paint)?, opacity)));
        let (colour, opacity) = painted.unwrap_or(([0; 3], 1.0));
        paint::over(colour, opacity * seen.opacity(), self.paper())
    }

    fn add(&mut self, Painted { mark, colour, corners }: Painted, at: usize) {
        let group = &mut self.drawing.groups[at];
        if let Some(corners) = corners {
            group.outlines.insert(group.marks.len(), corners);
        }
        group.marks.push(mark);
        group.colours.push(colour);
    }

    /// The marks of a path with this transform; what is none is counted.
    fn painted(&mut self, path: &usvg::Path, transform: Transform, seen: &Visibility) -> Vec<Painted> {
        let is_filled = path.fill().is_some_and(|fill| fill.opacity().get() > 0.0);
        let pen = path.stroke().filter(|stroke| stroke.opacity().get() > 0.0);
        if seen.opacity() <= 0.0 || (!is_filled && pen.is_none()) {
            self.unread("transparent shape");
            return Vec::new();
        }
        let area = f64::from(transform.sx * transform.sy - transform.kx * transform.ky).abs();
        let stroke = pen.map(|stroke| f64::from(stroke.width().get()) * area.sqrt() * self.scale);
        let strokes = strokes(path.data(), transform, self.scale);
        let (colour, mut found) = (self.colour(path, seen), Vec::new());
        for (index, drawn) in strokes.iter().enumerate() {
            if seen.is_clipped(&drawn.points) {
                self.unread("clipped shape");
                continue;
            }
            let closed = drawn.closed || (is_filled && stroke.is_none());
            let within = |other: &Drawn| other.closed && encloses(&other.points, drawn.points[0]);
            let around = strokes.iter().enumerate().filter(|(i, other)| *i != index && within(other)).count();
            if is_filled && closed && around % 2 == 1 {
                self.unread("hole");
                continue;
            }
            match mark(drawn, closed, is_filled, stroke) {
                Some((mark, corners)) => found.push(Painted { mark, colour, corners }),
                None => self.unread("path without extent"),
            }
        }
        found
    }
}

/// The mark that a stroke of a path is read as, with its corners where it is closed and no ellipse. `pen` is the width of its stroke.
fn mark(
    drawn: &Drawn,
    closed: bool,
    is_filled: bool,
    pen: Option<f64>,
) -> Option<(Mark, Option<Vec<[f64; 2]>>)> {
    let (points, width) = (&drawn.points, pen.unwrap_or(0.0));
    if !closed {
        return recognise(points, width).map(|mark| (mark, None));
    }
    if let Some(line) = bar(points, width).filter(|_| is_filled) {
        return Some((Mark::Line(line), None));
    }
    let Some((ellipse, differs)) = fit_outline(points) else {
        return fit::line(points, width).filter(|_| pen.is_some()).map(|line| (Mark::Line(line), None));
    };
    let corners = (differs > SAME).then(|| points[..points.len() - 1].to_vec());
    Some((Mark::Ellipse(ellipse), corners))
}

#[cfg(test)]
mod tests;
