//! Reading strokes: each has an extent and its centre on the canvas.

use crate::document::layer_rules::mixed_marks;
use crate::document::limits::{self, MIN_LENGTH, Range};
use crate::document::node::Node;
use crate::document::{Outline, Problem, Stroke, SystemChoice};
use crate::marks::{Ellipse, Line, Path, ellipse_of_outline, largest_loop};

/// A layer's strokes: at least one unless there may be none, ellipses or lines; both only where the `system` takes lines beside ellipses.
pub(super) fn strokes(
    node: &Node,
    size: [u32; 2],
    system: SystemChoice,
    may_be_none: bool,
) -> Result<Vec<Stroke>, Problem> {
    let mut strokes = Vec::new();
    let mut first = None;
    for item in node.items("a list of strokes")? {
        let stroke = stroke(&item, size)?;
        if let Some(kind) = stroke.kind() {
            let first = *first.get_or_insert(kind);
            mixed_marks(system, kind, first, &item.place()).map_or(Ok(()), Err)?;
        }
        strokes.push(stroke);
    }
    if strokes.is_empty() && !may_be_none {
        Err(node.found("no strokes", "at least one stroke"))
    } else {
        Ok(strokes)
    }
}

fn stroke(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    let kinds: [(&str, Reader); 5] =
        [("ellipse", ellipse), ("line", line), ("path", path), ("freehand", freehand), ("outline", outline)];
    let read = node.need("kind", "ellipse, line, path, freehand or outline")?.choice(&kinds)?;
    read(node, size)
}

type Reader = fn(&Node, [u32; 2]) -> Result<Stroke, Problem>;

/// An ellipse may reach over the edge as long as its centre is on the canvas.
fn ellipse(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.keys(&["kind", "center", "radii", "angle"])?;
    Ok(Stroke::Ellipse(Ellipse {
        center: node.need("center", "[x, y] in px")?.numbers(size.map(Range::inside))?,
        radii: node
            .need("radii", "[along the angle, across it] in px")?
            .numbers([Range::thickness(size); 2])?,
        angle: node.get("angle").map_or(Ok(0.0), |node| node.number(&Range::ANGLE))?,
    }))
}

/// The midpoint of a line is on the canvas; its ends may lie outside.
fn line(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.keys(&["kind", "from", "to", "width"])?;
    let from = node.need("from", "[x, y] in px")?.numbers(size.map(Range::around))?;
    let to = node.need("to", "[x, y] in px")?.numbers(size.map(Range::around))?;
    let line = Line { from, to, width: width(node, size)? };
    if line.length() < MIN_LENGTH {
        let found = format!("a line of length {} px", line.length());
        return Err(node.found(found, format!("\"from\" and \"to\" at least {MIN_LENGTH} px apart")));
    }
    inside(node, "a line whose midpoint is", line.center(), size)?;
    Ok(Stroke::Line(line))
}

/// The point half way along a path is on the canvas; others may leave it.
fn path(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.keys(&["kind", "points", "width"])?;
    let list = node.need("points", POINTS)?;
    let path = Path { points: points(&list, size)?, width: width(node, size)? };
    inside(&list, "a path whose centre is", path.center(), size)?;
    Ok(Stroke::Path(path))
}

/// The mean of the points is on the canvas; single points may leave it.
fn freehand(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.keys(&["kind", "points", "width"])?;
    let list = node.need("points", POINTS)?;
    let points = points(&list, size)?;
    let n = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / n);
    inside(&list, "a stroke whose centre is", mean, size)?;
    Ok(Stroke::Freehand { points, width: width(node, size)? })
}

/// The centroid of an outline is on the canvas; corners may leave it.
fn outline(node: &Node, size: [u32; 2]) -> Result<Stroke, Problem> {
    node.keys(&["kind", "points"])?;
    let list = node.need("points", POINTS)?;
    let points = points(&list, size)?;
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
    inside(&list, "an outline whose centre is", ellipse.center, size)?;
    Ok(Stroke::Outline(Outline { points }))
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

fn inside(node: &Node, what: &str, [x, y]: [f64; 2], size: [u32; 2]) -> Result<(), Problem> {
    if Range::inside(size[0]).holds(x) && Range::inside(size[1]).holds(y) {
        return Ok(());
    }
    let allowed = format!("a centre on the canvas, from [0, 0] to [{}, {}]", size[0], size[1]);
    Err(node.found(format!("{what} [{x}, {y}]"), allowed))
}
