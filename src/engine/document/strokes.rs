//! Reading strokes: each has an extent, and some part of it lies on the canvas.

use crate::document::body;
use crate::document::layer_rules::mixed_marks;
use crate::document::limits::{self, MIN_LENGTH, Range};
use crate::document::node::Node;
use crate::document::shape::{ANY, Key, Object, Shape};
use crate::document::{Body, BodyMark, Outline, Problem, Stroke, SystemChoice};
use crate::marks::{Ellipse, Line, Mark, Path, ellipse_of_outline, largest_loop, polygon_is_on};
use crate::sketch::recognise;

const PLACE: Shape = Shape::Numbers(&[Range::AROUND; 2]);
const WIDTH: Shape = Shape::Number(Range::THICKNESS);
const CORNERS: Shape = Shape::List(&PLACE, [3, limits::MAX_CORNERS]);

static ELLIPSE: Object = Object {
    name: "Ellipse",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["ellipse"]), Key::REQUIRED, "what it is"),
        Key::new(
            "center",
            PLACE,
            Key::REQUIRED,
            "its centre, px; it may leave the canvas by its whole side, the ellipse may not",
        ),
        Key::new(
            "radii",
            Shape::Numbers(&[Range::THICKNESS; 2]),
            Key::REQUIRED,
            "along the angle and across it, px, 0.01 to the longer side of the canvas",
        ),
        Key::new("angle", Shape::Number(Range::ANGLE), "0", "its direction"),
        Key::new(
            "outline",
            CORNERS,
            Key::NONE,
            "the outline that it was drawn as and fitted to: its corners as those of an outline. Patches and cells grow it; all else has to do with the ellipse alone, `auto` too. The window writes it of closed strokes, and `import` of shapes that are no ellipses",
        ),
    ],
};

static LINE: Object = Object {
    name: "Line",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["line"]), Key::REQUIRED, "what it is"),
        Key::new(
            "from",
            PLACE,
            Key::REQUIRED,
            "one end, px; it may leave the canvas by its whole side, the line may not",
        ),
        Key::new("to", PLACE, Key::REQUIRED, "the other end, px, at least 0.01 px away"),
        Key::new("width", WIDTH, "6", "its width, px"),
    ],
};

static PATH: Object = Object {
    name: "Path",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["path"]), Key::REQUIRED, "what it is"),
        Key::new(
            "points",
            Shape::List(&PLACE, [2, ANY]),
            Key::REQUIRED,
            "its points in order, px, at least two; they may leave the canvas by its whole side, the path may not",
        ),
        Key::new("width", WIDTH, "6", "its width, px"),
    ],
};

static FREEHAND: Object = Object {
    name: "Freehand",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["freehand"]), Key::REQUIRED, "what it is"),
        Key::new(
            "points",
            Shape::List(&PLACE, [2, ANY]),
            Key::REQUIRED,
            "where the pen was, px, at least two points",
        ),
        Key::new("width", WIDTH, "6", "the width of the line or path, px"),
    ],
};

static OUTLINE: Object = Object {
    name: "Outline",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["outline"]), Key::REQUIRED, "what it is"),
        Key::new(
            "points",
            CORNERS,
            Key::REQUIRED,
            "its corners in order, px, 3 to 1000; they may leave the canvas by its whole side, the polygon may not",
        ),
    ],
};

/// A stroke on the canvas.
pub(super) const STROKE: Shape = Shape::AnyOf(&[
    Shape::Object(&ELLIPSE),
    Shape::Object(&LINE),
    Shape::Object(&PATH),
    Shape::Object(&FREEHAND),
    Shape::Object(&OUTLINE),
]);

/// A layer's strokes on the canvas and on the model, where there is one: at least one unless there may be none. They are ellipses
/// or lines; both only if the `system` takes lines beside ellipses.
pub(super) fn strokes(
    node: &Node,
    (size, model): ([u32; 2], Option<&Body>),
    system: SystemChoice,
    may_be_none: bool,
) -> Result<(Vec<Stroke>, Vec<BodyMark>), Problem> {
    let (mut strokes, mut on_model) = (Vec::new(), Vec::new());
    let mut first = None;
    for item in node.items("a list of strokes")? {
        if let Some(model) = model.filter(|_| body::is_on_body(&item)) {
            on_model.push(body::mark(&item, model.px)?);
            continue;
        }
        let stroke = stroke(&item, size)?;
        if let Some(kind) = stroke.kind() {
            let first = *first.get_or_insert(kind);
            mixed_marks(system, kind, first, &item.place()).map_or(Ok(()), Err)?;
        }
        strokes.push(stroke);
    }
    if strokes.is_empty() && on_model.is_empty() && !may_be_none {
        Err(node.found("no strokes", "at least one stroke"))
    } else {
        Ok((strokes, on_model))
    }
}

/// The strokes of a list on a canvas of `size` px.
pub(super) fn on_canvas_of(node: &Node, size: [u32; 2]) -> Result<Vec<Stroke>, Problem> {
    node.items("a list of strokes")?.map(|item| stroke(&item, size)).collect()
}

fn stroke(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    let kinds: [(&str, Reader); 5] =
        [("ellipse", ellipse), ("line", line), ("path", path), ("freehand", freehand), ("outline", outline)];
    let read = node.need("kind", "ellipse, line, path, freehand or outline")?.choice(&kinds)?;
    read(node, size)
}

type Reader = fn(&Node, [u32; 2]) -> Result<Stroke, Problem>;

/// An ellipse, with the outline that it was fitted to if that was kept.
fn ellipse(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.is(&ELLIPSE)?;
    let ellipse = Ellipse {
        center: node.need("center", "[x, y] in px")?.numbers(size.map(Range::around))?,
        radii: node
            .need("radii", "[along the angle, across it] in px")?
            .numbers([Range::thickness(size); 2])?,
        angle: node.get("angle").map_or(Ok(0.0), |node| node.number(&Range::ANGLE))?,
    };
    on_canvas(
        node,
        Mark::Ellipse(ellipse).is_on(size.map(f64::from)),
        || about("an ellipse", ellipse.center),
        size,
    )?;
    match node.get("outline") {
        Some(list) => Ok(Stroke::Fitted { ellipse, outline: corners(&list, size)?.0 }),
        None => Ok(Stroke::Ellipse(ellipse)),
    }
}

fn line(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.is(&LINE)?;
    let from = node.need("from", "[x, y] in px")?.numbers(size.map(Range::around))?;
    let to = node.need("to", "[x, y] in px")?.numbers(size.map(Range::around))?;
    let line = Line { from, to, width: width(node, size)? };
    if line.length() < MIN_LENGTH {
        let found = format!("a line of length {} px", line.length());
        return Err(node.found(found, format!("\"from\" and \"to\" at least {MIN_LENGTH} px apart")));
    }
    let ends = || format!("a line from [{}, {}] to [{}, {}]", from[0], from[1], to[0], to[1]);
    on_canvas(node, Mark::Line(line).is_on(size.map(f64::from)), ends, size)?;
    Ok(Stroke::Line(line))
}

fn path(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.is(&PATH)?;
    let list = node.need("points", POINTS)?;
    let mark = Mark::Path(Path { points: points(&list, size)?, width: width(node, size)? });
    on_canvas(&list, mark.is_on(size.map(f64::from)), || about("a path", mark.center()), size)?;
    Ok(Stroke::from(mark))
}

/// Even if no piece of the stroke and not the mean of its points is on the canvas, the mark that is fitted to it may be.
fn freehand(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.is(&FREEHAND)?;
    let list = node.need("points", POINTS)?;
    let points = points(&list, size)?;
    let n = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / n);
    let (canvas, width) = (size.map(f64::from), width(node, size)?);
    let is_inside = (0..2).all(|axis| (0.0..=canvas[axis]).contains(&mean[axis]));
    // The width of the pen has no meaning for a closed stroke.
    let thin = || Mark::Path(Path { points: points.clone(), width: MIN_LENGTH });
    let is_read =
        is_inside || thin().is_on(canvas) || recognise(&points, width).is_some_and(|mark| mark.is_on(canvas));
    on_canvas(&list, is_read, || about("a stroke", mean), size)?;
    Ok(Stroke::Freehand { points, width })
}

/// The outline or its ellipse is on the canvas: other systems than those of areas grow the ellipse.
fn outline(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.is(&OUTLINE)?;
    let list = node.need("points", POINTS)?;
    let (outline, ellipse) = corners(&list, size)?;
    let canvas = size.map(f64::from);
    let is_on = Mark::Ellipse(ellipse).is_on(canvas) || polygon_is_on(&outline.points, canvas);
    on_canvas(&list, is_on, || about("an outline", ellipse.center), size)?;
    Ok(Stroke::Outline(outline))
}

/// The corners of an outline, which encloses an area, and the ellipse of its moments.
fn corners(list: &Node, size: [u32; 2]) -> Result<(Outline, Ellipse), Problem> {
    let points = points(list, size)?;
    if points.len() > limits::MAX_CORNERS {
        let allowed = format!("at most {}: leave out those that are nearest to others", limits::MAX_CORNERS);
        return Err(list.found(format!("{} points", points.len()), allowed));
    }
    let distinct = (0..points.len()).filter(|k| !points[..*k].contains(&points[*k])).take(3).count();
    if distinct < 3 {
        return Err(
            list.found(format!("{distinct} different points"), "at least 3, the corners of the outline")
        );
    }
    if let Some((share, [x, y])) = largest_loop(&points).filter(|(share, _)| *share > limits::LOOP) {
        let found = format!(
            "an outline that crosses itself near [{x:.1}, {y:.1}], with a loop of {:.0} % of its area",
            100.0 * share
        );
        let allowed = format!(
            "loops of at most {:.0} %: draw it without crossing, or draw two outlines",
            100.0 * limits::LOOP
        );
        return Err(list.found(found, allowed));
    }
    let ellipse = ellipse_of_outline(&points).filter(|ellipse| ellipse.radii[1] >= MIN_LENGTH);
    let Some(ellipse) = ellipse else {
        let allowed = format!(
            "an outline that is {} px wide or more; points on one line enclose nothing",
            2.0 * MIN_LENGTH
        );
        return Err(list.found("an outline that encloses no area", allowed));
    };
    Ok((Outline { points }, ellipse))
}

const POINTS: &str = "a list of points [x, y] in px";

/// The points of a path or a freehand stroke, which has an extent.
fn points(list: &Node, size: [u32; 2]) -> Result<Vec<[f64; 2]>, Problem> {
    let points: Vec<[f64; 2]> =
        list.items(POINTS)?.map(|point| point.numbers(size.map(Range::around))).collect::<Result<_, _>>()?;
    if points.len() < 2 {
        return Err(list.found(format!("{} points", points.len()), "at least 2 points"));
    }
    let extent = [0, 1].map(|axis| {
        let along = || points.iter().map(|point| point[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    });
    if extent[0].max(extent[1]) < MIN_LENGTH {
        let found = format!("points within {} × {} px", extent[0], extent[1]);
        return Err(list.found(found, format!("a stroke that extends over at least {MIN_LENGTH} px")));
    }
    Ok(points)
}

fn width(node: &Node, size: [u32; 2]) -> Result<f64, Problem> {
    let range = Range::thickness(size);
    // On a canvas narrower than the default width, the canvas' width is the default.
    node.get("width").map_or(Ok(Stroke::WIDTH.min(range.high)), |node| node.number(&range))
}

fn about(what: &str, [x, y]: [f64; 2]) -> String {
    format!("{what} about [{x}, {y}]")
}

/// Refuses a stroke that is not on the canvas.
fn on_canvas(node: &Node, is_on: bool, what: impl Fn() -> String, size: [u32; 2]) -> Result<(), Problem> {
    if is_on {
        return Ok(());
    }
    let [x, y] = size;
    let allowed = format!(
        "a stroke of which some part is on the canvas, from [0, 0] to [{x}, {y}]: move it, or leave it out"
    );
    Err(node.found(format!("{} that is wholly outside the canvas", what()), allowed))
}
