//! SVG → marks: shapes become the ellipses and lines that the same shapes drawn by hand would become.
//!
//! A filled rectangle longer than three times its width becomes a line. What is clipped away or fully transparent is not read.
//! Transforms are applied; the results are in px of the canvas. A closed shape becomes an ellipse as a closed stroke does,
//! an open one a path or a line (or, where it is nearly closed, an ellipse).

mod bar;
mod visibility;

use std::collections::BTreeMap;

use usvg::roxmltree::{self, Node as Element};
use usvg::tiny_skia_path::{PathSegment, Point, Transform};
use usvg::{ImageHrefResolver, Node, Options, Tree};

use super::{fit_outline, recognise};
use crate::marks::{Mark, fit};
use bar::bar;
use visibility::Visibility;

/// Namespace of the labels that Inkscape gives layers.
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
/// px an inch of an SVG.
pub const DPI: f64 = 96.0;
/// The share of its area by which a shape may differ from the ellipse that it is: curves are drawn as polygons.
const SAME: f64 = 0.01;
/// Points along a curved segment.
const FINENESS: u16 = 32;
/// The most marks of an SVG; a sketch has dozens.
const MOST: usize = 100_000;

/// What was read from an SVG.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width and height, px.
    pub size: [f64; 2],
    /// Its top-level groups. The first, with an empty name, holds the shapes outside groups.
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
    #[error("is no SVG: it is not UTF-8 text; allowed: a plain (not compressed) SVG file in UTF-8")]
    NotText,
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

/// Reads an SVG, with `dpi` px an inch.
///
/// ```
/// use dapple_engine::sketch::svg;
///
/// let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="100" height="80"><circle cx="50" cy="40" r="9"/></svg>"#;
/// let drawing = svg::read(text.as_bytes(), 96.0)?;
/// assert_eq!(drawing.size, [100.0, 80.0]);
/// assert_eq!(drawing.groups[0].marks.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Where it is not an SVG, or holds too much for a sketch.
pub fn read(bytes: &[u8], dpi: f64) -> Result<Drawing, SvgError> {
    let text = std::str::from_utf8(bytes).map_err(|_| SvgError::NotText)?;
    check_depth(text)?;
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..roxmltree::ParsingOptions::default() };
    let xml = roxmltree::Document::parse_with_options(text, options).map_err(SvgError::NotXml)?;
    // Before the shapes are made into paths, which takes long.
    if xml.descendants().filter(is_shape).count() > MOST {
        return Err(SvgError::TooMany);
    }
    // Pictures are not loaded, neither embedded nor linked ones.
    let none =
        ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = Options { image_href_resolver: none, dpi: DPI as f32, ..Options::default() };
    let tree = Tree::from_xmltree(&xml, &options).map_err(SvgError::NotSvg)?;
    let scale = dpi / DPI;
    let size = [tree.size().width(), tree.size().height()].map(|side| f64::from(side) * scale);
    let mut reader = Reader { scale, labels: labels(&xml), drawing: Drawing { size, ..Drawing::default() } };
    reader.count_unread(&xml);
    reader.top_level(tree.root())?;
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

/// The labels of groups, by id.
fn labels(xml: &roxmltree::Document) -> BTreeMap<String, String> {
    let groups = xml.descendants().filter(|element| element.tag_name().name() == "g");
    groups
        .filter_map(|group| {
            Some((group.attribute("id")?.to_owned(), group.attribute((INKSCAPE, "label"))?.to_owned()))
        })
        .collect()
}

struct Reader {
    scale: f64,
    labels: BTreeMap<String, String>,
    drawing: Drawing,
}

impl Reader {
    fn unread(&mut self, kind: &'static str) {
        *self.drawing.unread.entry(kind).or_default() += 1;
    }

    /// Counts elements that give no path.
    fn count_unread(&mut self, xml: &roxmltree::Document) {
        for element in xml.descendants().filter(|element| !is_hidden(element)) {
            match element.tag_name().name() {
                "text" => self.unread("text"),
                "image" => self.unread("image"),
                "foreignObject" => self.unread("foreign object"),
                _ => {}
            }
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
            let label = self.labels.get(group.id()).filter(|label| !label.trim().is_empty());
            let mut name = label.cloned().unwrap_or_else(|| group.id().to_owned());
            if name.is_empty() {
                nameless += 1;
                name = format!("group {nameless}");
            }
            self.drawing.groups.push(Group { name, ..Group::default() });
            let at = self.drawing.groups.len() - 1;
            self.group(group, at, &seen)?;
        }
        Ok(())
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
            Node::Group(group) => self.group(group, at, seen)?,
            Node::Path(path) if path.is_visible() => self.path(path, at, seen),
            Node::Path(_) => self.unread("hidden path"),
            // Counted as elements.
            Node::Image(_) | Node::Text(_) => {}
        }
        let marks: usize = self.drawing.groups.iter().map(|group| group.marks.len()).sum();
        if marks > MOST { Err(SvgError::TooMany) } else { Ok(()) }
    }

    fn path(&mut self, path: &usvg::Path, at: usize, seen: &Visibility) {
        let is_filled = path.fill().is_some_and(|fill| fill.opacity().get() > 0.0);
        let pen = path.stroke().filter(|stroke| stroke.opacity().get() > 0.0);
        if seen.is_transparent() || (!is_filled && pen.is_none()) {
            self.unread("transparent shape");
            return;
        }
        let transform = path.abs_transform();
        let area = f64::from(transform.sx * transform.sy - transform.kx * transform.ky).abs();
        let stroke = pen.map(|stroke| f64::from(stroke.width().get()) * area.sqrt() * self.scale);
        let strokes = strokes(path.data(), transform, self.scale);
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
            let width = stroke.unwrap_or(0.0);
            let mark = if closed {
                let line = || fit::line(&drawn.points, width).filter(|_| stroke.is_some()).map(Mark::Line);
                let bar = || bar(&drawn.points, width).filter(|_| is_filled).map(Mark::Line);
                bar().or_else(|| self.area(drawn, at)).or_else(line)
            } else {
                recognise(&drawn.points, width)
            };
            match mark {
                Some(mark) => self.drawing.groups[at].marks.push(mark),
                None => self.unread("path without extent"),
            }
        }
    }
}

impl Reader {
    /// The ellipse that a closed shape of the group `at` is read as. Its outline is kept where it is none.
    fn area(&mut self, drawn: &Drawn, at: usize) -> Option<Mark> {
        let (ellipse, differs) = fit_outline(&drawn.points)?;
        if differs > SAME {
            let group = &mut self.drawing.groups[at];
            group.outlines.insert(group.marks.len(), drawn.points[..drawn.points.len() - 1].to_vec());
        }
        Some(Mark::Ellipse(ellipse))
    }
}

/// A stroke of a path, px of the canvas.
struct Drawn {
    points: Vec<[f64; 2]>,
    closed: bool,
}

fn strokes(path: &usvg::tiny_skia_path::Path, transform: Transform, scale: f64) -> Vec<Drawn> {
    let place = |point: Point| {
        let mut point = point;
        transform.map_point(&mut point);
        [f64::from(point.x) * scale, f64::from(point.y) * scale]
    };
    let mut strokes: Vec<Drawn> = Vec::new();
    for segment in path.segments() {
        if let PathSegment::MoveTo(point) = segment {
            strokes.push(Drawn { points: vec![place(point)], closed: false });
            continue;
        }
        let Some(stroke) = strokes.last_mut() else { continue };
        let from = *stroke.points.last().unwrap_or(&[0.0; 2]);
        match segment {
            PathSegment::LineTo(point) => stroke.points.push(place(point)),
            // A quadratic curve is the cubic with handles two thirds of the way to its own.
            PathSegment::QuadTo(a, end) => {
                let (a, end) = (place(a), place(end));
                let near = |p: [f64; 2]| [0, 1].map(|axis| p[axis] + 2.0 / 3.0 * (a[axis] - p[axis]));
                curve([from, near(from), near(end), end], &mut stroke.points);
            }
            PathSegment::CubicTo(a, b, end) => {
                curve([from, place(a), place(b), place(end)], &mut stroke.points);
            }
            PathSegment::Close => stroke.closed = true,
            PathSegment::MoveTo(_) => {}
        }
    }
    strokes.retain(|stroke| stroke.points.len() > 1 && stroke.points.iter().flatten().all(|c| c.is_finite()));
    for stroke in &mut strokes {
        let (first, last) = (stroke.points[0], stroke.points[stroke.points.len() - 1]);
        if stroke.closed && first != last {
            stroke.points.push(first);
        }
        stroke.closed |= stroke.points.len() > 3 && first == last;
    }
    strokes
}

fn curve([p0, p1, p2, p3]: [[f64; 2]; 4], points: &mut Vec<[f64; 2]>) {
    for i in 1..=FINENESS {
        let t = f64::from(i) / f64::from(FINENESS);
        let s = 1.0 - t;
        let [a, b, c, d] = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        points.push([0, 1].map(|axis| a * p0[axis] + b * p1[axis] + c * p2[axis] + d * p3[axis]));
    }
}

/// Whether a point lies in a polygon, by how often a line from it to the right crosses the sides.
fn encloses(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |pair: &&[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]];
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    polygon.windows(2).filter(crosses).count() % 2 == 1
}

#[cfg(test)]
mod tests;
