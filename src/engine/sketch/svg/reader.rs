//! Shapes of an SVG → marks, by layers, with their colours.

use usvg::tiny_skia_path::Transform;
use usvg::{Node, Paint, roxmltree};

use super::bar::bar;
use super::ground::Area;
use super::names::Names;
use super::paint;
use super::strokes::{Drawn, encloses, strokes};
use super::visibility::Visibility;
use super::{Drawing, Group, MOST, SvgError, filled_by_no_shapes, is_hidden, is_off, is_shape};
use crate::marks::{Mark, fit};
use crate::sketch::{fit_outline, recognise};

/// The share of its area by which a shape may differ from the ellipse that it is: curves are drawn as polygons.
const SAME: f64 = 0.01;

/// What shapes are counted as that have no extent, or neither fill nor stroke.
const NOTHING: &str = "shape that draws nothing";

/// Reads the shapes of an SVG, group by group.
pub(super) struct Reader {
    pub(super) scale: f64,
    pub(super) names: Names,
    pub(super) drawing: Drawing,
    /// Paths that were seen.
    pub(super) paths: usize,
}

/// A mark and its colour.
pub(super) struct Painted {
    pub(super) mark: Mark,
    colour: [u8; 3],
    /// The corners of a closed shape that is no ellipse.
    corners: Option<Vec<[f64; 2]>>,
}

impl Reader {
    pub(super) fn unread(&mut self, kind: &'static str) {
        *self.drawing.unread.entry(kind).or_default() += 1;
    }

    /// Counts elements that give no path.
    pub(super) fn count_unread(&mut self, xml: &roxmltree::Document) {
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
    pub(super) fn count_undrawn(&mut self, xml: &roxmltree::Document, shapes: usize) {
        let names = ["use", "switch", "marker"];
        let is_counted = !xml.descendants().any(|element| names.contains(&element.tag_name().name()));
        let hidden = self.drawing.unread.get("hidden shape").copied().unwrap_or_default();
        let undrawn = if is_counted { shapes.saturating_sub(hidden + self.paths) } else { 0 };
        let patterns = filled_by_no_shapes(xml);
        for (kind, more) in
            [(NOTHING, undrawn), ("pattern", patterns)].into_iter().filter(|(_, more)| *more > 0)
        {
            *self.drawing.unread.entry(kind).or_default() += more;
        }
        // These were counted as such that draw nothing, too.
        let left = self.drawing.unread.get(NOTHING).copied().unwrap_or_default().saturating_sub(patterns);
        match left {
            0 => self.drawing.unread.remove(NOTHING),
            left => self.drawing.unread.insert(NOTHING, left),
        };
    }

    /// Reads the top-level groups; a single nameless group around everything is skipped.
    pub(super) fn top_level(&mut self, mut root: &usvg::Group) -> Result<(), SvgError> {
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
                let is_drawn = path.fill().is_some() || path.stroke().is_some();
                match path.is_visible() {
                    true => self.path(path, at, seen),
                    false => self.unread(if is_drawn { "hidden path" } else { NOTHING }),
                }
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
    pub(super) fn ground(&mut self, path: &usvg::Path, seen: &Visibility) {
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

    pub(super) fn add(&mut self, Painted { mark, colour, corners }: Painted, at: usize) {
        let group = &mut self.drawing.groups[at];
        if let Some(corners) = corners {
            group.outlines.insert(group.marks.len(), corners);
        }
        group.marks.push(mark);
        group.colours.push(colour);
    }

    /// The marks of a path with this transform; what is none is counted.
    pub(super) fn painted(
        &mut self,
        path: &usvg::Path,
        transform: Transform,
        seen: &Visibility,
    ) -> Vec<Painted> {
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
