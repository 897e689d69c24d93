//! The model that a document grows on (`"model"`), and marks that are drawn on it.

use std::fmt;

use crate::document::Problem;
use crate::document::choices::names;
use crate::document::limits::{self, Range};
use crate::document::node::Node;
use crate::document::shape::{ANY, Key, Object, Shape};
use crate::surface::BODIES;

/// A model on whose surface a document grows, and how the sketch is applied to it. All coordinates are those of the model's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Source of its triangles.
    pub source: BodySource,
    /// The longest side of its bounding box, in px of the sketch: [`limits::BODY_SIDE`].
    pub px: f64,
    /// The axis that points up in pictures.
    pub up: Axis,
    /// The axis along which +x of the sketch points, projected on the surface.
    pub along: Axis,
    /// Places on the model to which regions of the sketch apply; none = the sketch applies everywhere.
    pub pins: Vec<Pin>,
    /// Lines on it that +x of the sketch follows: polylines of at least two points.
    pub strokes: Vec<Vec<[f64; 3]>>,
    /// Names of the groups and materials that are grown on; none = all.
    pub only: Vec<String>,
}

impl Body {
    /// The longest side of a model for which no size is given, px.
    pub const PX: f64 = 900.0;

    /// A body with all defaults.
    #[must_use]
    pub fn new(source: BodySource) -> Self {
        let (pins, strokes, only) = (Vec::new(), Vec::new(), Vec::new());
        Self { source, px: Self::PX, up: Axis::Y, along: Axis::X, pins, strokes, only }
    }
}

/// Source of the triangles of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BodySource {
    /// The built-in body of this name, from [`BODIES`].
    BuiltIn(&'static str),
    /// A file beside the document.
    File {
        /// Its path, relative to the folder of the document.
        path: String,
        /// SHA-256 of its bytes when it was chosen; `None` = the contents are not checked.
        sha256: Option<[u8; 32]>,
    },
}

impl BodySource {
    /// Its name in documents: of a built-in body, or the path of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::BuiltIn(name) => name,
            Self::File { path, .. } => path,
        }
    }
}

/// A coordinate axis of a model, or the opposite of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// +x.
    X,
    /// +y.
    Y,
    /// +z.
    Z,
    /// −x.
    MinusX,
    /// −y.
    MinusY,
    /// −z.
    MinusZ,
}

impl Axis {
    /// The axes by their names in documents.
    pub const NAMES: [(&'static str, Self); 6] = [
        ("x", Self::X),
        ("y", Self::Y),
        ("z", Self::Z),
        ("-x", Self::MinusX),
        ("-y", Self::MinusY),
        ("-z", Self::MinusZ),
    ];

    /// Its name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, axis)| *axis == self).map_or("", |(name, _)| name)
    }

    /// The unit vector.
    #[must_use]
    pub fn vector(self) -> [f64; 3] {
        match self {
            Self::X => [1.0, 0.0, 0.0],
            Self::Y => [0.0, 1.0, 0.0],
            Self::Z => [0.0, 0.0, 1.0],
            Self::MinusX => [-1.0, 0.0, 0.0],
            Self::MinusY => [0.0, -1.0, 0.0],
            Self::MinusZ => [0.0, 0.0, -1.0],
        }
    }
}

/// A place on a body to which a region of the sketch applies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// Column and row of the region; [0, 0] of a sketch without regions.
    pub region: [u32; 2],
    /// The place; the nearest point of the surface is used.
    pub at: [f64; 3],
    /// Direction in which +x of the region points, projected on the surface; `None` = along [`Body::along`].
    pub toward: Option<[f64; 3]>,
}

/// A mark that is drawn on a body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyMark {
    /// A spot.
    Ellipse(BodyEllipse),
    /// A piece of a stripe.
    Path {
        /// At least two points.
        points: Vec<[f64; 3]>,
        /// Its width, px.
        width: f64,
    },
}

/// A spot that is drawn on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyEllipse {
    /// Its centre; the nearest point of the surface is used.
    pub at: [f64; 3],
    /// Normal of the surface there: tells the two sides of a thin sheet apart. `None` = either side.
    pub normal: Option<[f64; 3]>,
    /// Radii along the angle and across it, px.
    pub radii: [f64; 2],
    /// Its direction: degrees from the projected [`Body::along`], clockwise seen from outside.
    pub angle: f64,
}

impl fmt::Display for BodySource {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::BuiltIn(name) => write!(f, "the built-in model {name:?}"),
            Self::File { path, .. } => write!(f, "the model {path:?}"),
        }
    }
}

const IN_SPACE: Shape = Shape::Numbers(&[limits::MODEL; 3]);
const POLYLINE: Shape = Shape::List(&IN_SPACE, [2, ANY]);
const AXIS: Shape = Shape::Choice(|| names(&Axis::NAMES));
const NAME: Shape = Shape::Text([1, limits::MAX_NAME]);
const REGION: [u64; 2] = [0, limits::MAX_REGIONS as u64 - 1];

pub(super) static MODEL: Object = Object {
    name: "Model",
    keys: &[
        Key::new(
            "file",
            NAME,
            Key::REQUIRED,
            "the path of an `.obj`, `.ply`, `.stl`, `.glb` or `.gltf` file, relative to the folder of the document; or a model that is built in: `sphere`, `torus`, `cylinder`, `capsule`, `cube`, `animal`, `spindle`, `vase`, `shell`, `snake`, `egg`",
        ),
        Key::new(
            "sha256",
            Shape::Hexadecimal("", &[64]),
            Key::NONE,
            "of the bytes of the file, so that another file of that name is noticed; means nothing of a built-in model",
        ),
        Key::new(
            "px",
            Shape::Number(limits::BODY_SIDE),
            "900",
            "the longest side of its bounding box, in px of the sketch",
        ),
        Key::new("up", AXIS, "\"y\"", "which axis points up in pictures"),
        Key::new(
            "along",
            AXIS,
            "\"x\"",
            "the axis along which +x of the sketch points, projected on the surface",
        ),
        Key::new(
            "pins",
            Shape::List(&Shape::Object(&PIN), [0, limits::MAX_PINS]),
            "[]",
            "where on the model a region, or the whole sketch, holds; without pins the whole sketch holds everywhere",
        ),
        Key::new(
            "strokes",
            Shape::List(&Shape::Object(&STROKE), [0, limits::MAX_PINS]),
            "[]",
            "lines on the model that +x of the sketch follows: objects with `points`, two or more `[x, y, z]`",
        ),
        Key::new(
            "only",
            Shape::List(&NAME, [0, limits::MAX_PINS]),
            "[]",
            "the groups and materials that are grown on, by name; the others are shown as they are",
        ),
    ],
};

static PIN: Object = Object {
    name: "Pin",
    keys: &[
        Key::new(
            "region",
            Shape::Wholes(&[REGION; 2]),
            "[0, 0]",
            "column and row of the region that holds there, with one row and column of regions `[0, 0]`",
        ),
        Key::new("at", IN_SPACE, Key::REQUIRED, "the place; the nearest place of the surface is meant"),
        Key::new(
            "toward",
            IN_SPACE,
            Key::NONE,
            "where +x of the region points, projected on the surface; without it along the axis `along`",
        ),
    ],
};

static STROKE: Object = Object {
    name: "Stroke of a model",
    keys: &[Key::new("points", POLYLINE, Key::REQUIRED, "a line on the model that +x of the sketch follows")],
};

pub(super) static ELLIPSE_ON_MODEL: Object = Object {
    name: "Ellipse on the model",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["ellipse"]), Key::REQUIRED, "what it is"),
        Key::new("at", IN_SPACE, Key::REQUIRED, "its centre; the nearest place of the surface is meant"),
        Key::new(
            "normal",
            IN_SPACE,
            Key::NONE,
            "which way the surface faces there: tells the two sides of a thin sheet apart",
        ),
        Key::new(
            "radii",
            Shape::Numbers(&[Range::THICKNESS; 2]),
            Key::REQUIRED,
            "along the angle and across it, px, 0.01 to `px` of the model",
        ),
        Key::new(
            "angle",
            Shape::Number(Range::ANGLE),
            "0",
            "degrees from the projected axis `along`, clockwise seen from outside",
        ),
    ],
};

pub(super) static PATH_ON_MODEL: Object = Object {
    name: "Path on the model",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["line", "path"]), Key::REQUIRED, "what it is"),
        Key::new("points", POLYLINE, Key::REQUIRED, "its points in order, in the coordinates of the model"),
        Key::new("width", Shape::Number(Range::THICKNESS), "6", "its width, px"),
    ],
};

/// Reads the model of a document with `regions` columns and rows of regions.
pub(super) fn read(node: &Node, regions: [u32; 2]) -> Result<Body, Problem> {
    node.is(&MODEL)?;
    let source = source(node)?;
    let axis = |key, default| node.get(key).map_or(Ok(default), |node| node.choice(&Axis::NAMES));
    let body = Body {
        px: node.get("px").map_or(Ok(Body::PX), |node| node.number(&limits::BODY_SIDE))?,
        up: axis("up", Axis::Y)?,
        along: axis("along", Axis::X)?,
        pins: list(node, "pins", limits::MAX_PINS, "pins", |node| pin(node, regions))?,
        strokes: list(node, "strokes", limits::MAX_PINS, "strokes", stroke)?,
        only: list(node, "only", limits::MAX_PINS, "names of groups or materials", |node| {
            name(node, "the name of a group or a material")
        })?,
        source,
    };
    Ok(body)
}

/// Reads a list of at most `most` items; an empty one if the key is missing.
fn list<T>(
    node: &Node,
    key: &str,
    most: usize,
    what: &str,
    read: impl Fn(&Node) -> Result<T, Problem>,
) -> Result<Vec<T>, Problem> {
    let Some(list) = node.get(key) else { return Ok(Vec::new()) };
    let allowed = format!("a list of at most {most} {what}");
    let items: Vec<Node> = list.items(&allowed)?.collect();
    if items.len() > most {
        return Err(list.found(format!("{} {what}", items.len()), allowed));
    }
    items.iter().map(read).collect()
}

fn name(node: &Node, what: &str) -> Result<String, Problem> {
    let allowed = format!("{what}, of 1 to {} characters", limits::MAX_NAME);
    let name = node.text(&allowed)?;
    let fits = (1..=limits::MAX_NAME).contains(&name.chars().count());
    if fits { Ok(name.to_owned()) } else { Err(node.wrong(allowed)) }
}

fn source(node: &Node) -> Result<BodySource, Problem> {
    let what = format!(
        "the path of a model (.obj, .ply, .stl, .glb or .gltf) beside the document, or one of {}",
        BODIES.join(", ")
    );
    let file = node.need("file", &what)?;
    let path = name(&file, &what)?;
    let sha256 = node.get("sha256").map(|node| digest(&node)).transpose()?;
    Ok(match BODIES.iter().find(|built_in| **built_in == path) {
        Some(built_in) => BodySource::BuiltIn(built_in),
        None => BodySource::File { path, sha256 },
    })
}

/// 32 bytes as 64 hexadecimal digits.
fn digest(node: &Node) -> Result<[u8; 32], Problem> {
    const ALLOWED: &str =
        "the SHA-256 of the file, 64 hexadecimal digits; leave it out if you do not know it";
    let text = node.text(ALLOWED)?;
    let digits: Option<Vec<u8>> = text.chars().map(|c| c.to_digit(16).map(|digit| digit as u8)).collect();
    let digits = digits.filter(|digits| digits.len() == 64).ok_or_else(|| node.wrong(ALLOWED))?;
    Ok(std::array::from_fn(|i| digits[2 * i] << 4 | digits[2 * i + 1]))
}

fn pin(node: &Node, [columns, rows]: [u32; 2]) -> Result<Pin, Problem> {
    node.is(&PIN)?;
    let region = match node.get("region") {
        Some(node) => index(&node, [columns, rows])?,
        None => [0, 0],
    };
    let at = node.need("at", "[x, y, z] in the coordinates of the model")?.numbers([limits::MODEL; 3])?;
    let toward = node.get("toward").map(|node| direction(&node)).transpose()?;
    Ok(Pin { region, at, toward })
}

/// Column and row of a region.
fn index(node: &Node, [columns, rows]: [u32; 2]) -> Result<[u32; 2], Problem> {
    let allowed = format!("[column, row] of a region, from [0, 0] to [{}, {}]", columns - 1, rows - 1);
    let items: Vec<Node> = node.items(&allowed)?.collect();
    let [column, row] = items.as_slice() else { return Err(node.wrong(allowed)) };
    let [column, row] =
        [(column, columns), (row, rows)].map(|(node, count)| node.whole(0, u64::from(count) - 1));
    Ok([column? as u32, row? as u32])
}

/// A vector that is not zero.
fn direction(node: &Node) -> Result<[f64; 3], Problem> {
    let vector = node.numbers([limits::MODEL; 3])?;
    let length = vector.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if length < limits::SHORTEST {
        Err(node.wrong("a direction [x, y, z] that is not zero"))
    } else {
        Ok(vector)
    }
}

const POINTS: &str = "a list of points [x, y, z] in the coordinates of the model";

fn stroke(node: &Node) -> Result<Vec<[f64; 3]>, Problem> {
    node.is(&STROKE)?;
    points(&node.need("points", POINTS)?)
}

/// The points of a polyline, which are not all one point.
fn points(list: &Node) -> Result<Vec<[f64; 3]>, Problem> {
    let points: Vec<[f64; 3]> =
        list.items(POINTS)?.map(|point| point.numbers([limits::MODEL; 3])).collect::<Result<_, _>>()?;
    if points.len() < 2 {
        return Err(list.found(format!("{} points", points.len()), "at least 2 points"));
    }
    if points.iter().all(|point| *point == points[0]) {
        return Err(list.found("points that are all the same", "points at two places or more"));
    }
    Ok(points)
}

/// Whether a stroke of a layer is drawn on the model: its place has three coordinates.
pub(super) fn is_on_body(node: &Node) -> bool {
    let in_space =
        |list: Node| list.items("").is_ok_and(|mut points| points.next().is_some_and(|p| p.is_list_of(3)));
    let is_spot = node.get("at").is_some() || node.get("normal").is_some();
    is_spot || node.get("points").is_some_and(in_space)
}

/// A stroke of a layer on a model with a longest side of `px`.
pub(super) fn mark(node: &Node, px: f64) -> Result<BodyMark, Problem> {
    let thickness = Range { low: limits::MIN_LENGTH, high: px, unit: "px" };
    let kinds = [("ellipse", true), ("line", false), ("path", false)];
    if !node.need("kind", "ellipse, line or path")?.choice(&kinds)? {
        node.is(&PATH_ON_MODEL)?;
        let points = points(&node.need("points", POINTS)?)?;
        let width = node.get("width").map_or(Ok(super::Stroke::WIDTH), |node| node.number(&thickness))?;
        return Ok(BodyMark::Path { points, width });
    }
    node.is(&ELLIPSE_ON_MODEL)?;
    Ok(BodyMark::Ellipse(BodyEllipse {
        at: node.need("at", "[x, y, z] in the coordinates of the model")?.numbers([limits::MODEL; 3])?,
        normal: node.get("normal").map(|node| direction(&node)).transpose()?,
        radii: node.need("radii", "[along the angle, across it] in px")?.numbers([thickness; 2])?,
        angle: node.get("angle").map_or(Ok(0.0), |node| node.number(&Range::ANGLE))?,
    }))
}
