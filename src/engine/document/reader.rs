//! A JSON value → a checked document, key by key.

use crate::document::body;
use crate::document::choices::names;
use crate::document::finish;
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::limits;
use crate::document::limits::Range;
use crate::document::maps;
use crate::document::migrate::NEWEST;
use crate::document::node::Node;
use crate::document::option_key;
use crate::document::parametric;
use crate::document::points;
use crate::document::shape::{ANY, Key, Object, Shape};
use crate::document::strokes;
use crate::document::tone;
use crate::document::warp;
use crate::document::{
    After, Body, Colours, Document, Growth, Kind, Layer, Problem, Starred, Stop, Stroke, SystemChoice,
};
use crate::grid::Edges;

pub(super) const EDGES: [(&str, Edges); 2] = [("closed", Edges::Closed), ("wrap", Edges::Wrap)];

const NAME: Shape = Shape::Text([0, limits::MAX_NAME]);
const SEED: Shape = Shape::Whole([0, u64::MAX]);
const REGIONS: [u64; 2] = [1, limits::MAX_REGIONS as u64];
const SIDE: [u64; 2] = [1, limits::MAX_SIDE as u64];
const MODELS: Shape = Shape::AnyOf(&[
    Shape::Object(&body::MODEL),
    Shape::Object(&parametric::HEIGHTS),
    Shape::Object(&parametric::SURFACE),
]);
const LAYERS: Shape = Shape::AnyOf(&[Shape::Object(&LAYER), Shape::Object(&finish::HAIR_LAYER)]);

/// A document of the newest version or an older one.
pub(super) static DOCUMENT: Object = Object {
    name: "Document",
    keys: &[
        Key::new("format", Shape::Choice(|| vec!["dapple"]), Key::REQUIRED, "the format"),
        Key::new(
            "version",
            Shape::Whole([1, NEWEST]),
            Key::REQUIRED,
            "the version of the format, now 2; see older versions",
        ),
        Key::new("name", NAME, "\"\"", "its name"),
        Key::new(
            "size",
            Shape::Wholes(&[SIDE; 2]),
            Key::REQUIRED,
            "width and height of the canvas, px, 1 to 65536 each",
        ),
        Key::new(
            "regions",
            Shape::Wholes(&[REGIONS; 2]),
            Key::NONE,
            "columns and rows, 1 to 64 each, no more than px; without them each mark sets what grows around it",
        ),
        Key::new(
            "edges",
            Shape::Choice(|| names(&EDGES)),
            "\"closed\"",
            "what lies beyond the border: nothing, or the other side (a seamless tile, whose longer side is at most 256 times the shorter one)",
        ),
        Key::new("seed", SEED, "1", "of all random numbers"),
        Key::new("dpi", Shape::Number(limits::DPI), "300", "for print"),
        Key::new("growth", Shape::Object(&GROWTH), "{}", "how it is grown"),
        Key::new(
            "model",
            MODELS,
            Key::NONE,
            "the model that it grows on, instead of the flat canvas; or the surface of which the canvas is the flat map",
        ),
        Key::new(
            "warp",
            Shape::Object(&warp::WARP),
            Key::NONE,
            "how the grown marks are bent; not with a `model` that is grown on",
        ),
        Key::new(
            "finish",
            Shape::Object(&finish::FINISH),
            Key::NONE,
            "the material that the texture is made of; on a `model` fur, scales, skin, leather or ink",
        ),
        // Beside them there may be one layer of hair.
        Key::new(
            "layers",
            Shape::List(&LAYERS, [1, limits::MAX_LAYERS + 1]),
            Key::REQUIRED,
            "the layers, the lowest first",
        ),
        Key::new(
            "starred",
            Shape::List(&Shape::Object(&STARRED), [0, limits::MAX_STARRED]),
            "[]",
            "other textures that are kept with the document: objects with a `name` and a `document`, which is written without `format`, `version` and `starred`",
        ),
    ],
};

static STARRED: Object = Object {
    name: "Starred texture",
    keys: &[
        Key::new("name", NAME, "\"\"", "short name of the difference from the sketch"),
        Key::new("document", Shape::Object(&KEPT), Key::REQUIRED, "its document, which keeps no others"),
    ],
};

/// A document that another one keeps: its format and version are those of the other.
static KEPT: Object = Object { name: "Kept document", keys: DOCUMENT.keys.split_at(2).1.split_at(11).0 };

static GROWTH: Object = Object {
    name: "Growth",
    keys: &[Key::new("refine", Shape::Flag, "true", "whether what has grown is measured and corrected")],
};

static LAYER: Object = Object {
    name: "Layer",
    keys: &[
        Key::new("name", NAME, "\"layer 1\"", "its name"),
        Key::new(
            "system",
            Shape::Choice(|| names(&SystemChoice::names())),
            "\"auto\"",
            "the reaction-diffusion system; `auto` picks by the marks: ellipses grow spots, or patches or cells where they are denser than spots grow, lines stripes, and lines that cross a weave; with `stripes` lines that cross stay stripes; `weave` grows threads along lines of two to five directions, and `maze` straight pieces of these directions that do not cross, `pair-stripes` stripes that end in tips, and `stucco` dots and worms; `cells` grows cells side by side; `patches` grows blotches, and `auto` takes it where outlines are drawn, `after` is `\"between\"` and nothing is irregular; `streaks` grows ragged stripes with ends along the drawn lines, and `cracks` a net as wide as these; `points` grows noise, cells and clusters of scattered points, with nothing drawn; `turing-growth` grows dots, worms or holes by a growth that a picture drives",
        ),
        Key::new(
            "after",
            Shape::Choice(|| names(&After::NAMES)),
            "\"between\"",
            "how it meets the marks beneath: between them (stripes pass under stripes that they cross, by more than 35° in the mean), between them but rarer the farther away, as rings around them, as a net between them, inside each",
        ),
        Key::new("visible", Shape::Flag, "true", "whether it is painted; a hidden layer still grows"),
        Key::new(
            "seed",
            SEED,
            Key::NONE,
            "its own seed; without one it is derived from the document's (SplitMix64)",
        ),
        Key::new(
            "strokes",
            Shape::List(&STROKES, [0, ANY]),
            Key::REQUIRED,
            "what was drawn: ellipses and outlines, or lines and paths, both only with the system `cells`; none only where there is a `tone` or the system is `points` or `turing-growth`",
        ),
        Key::new(
            "far_spacing",
            Shape::Number(limits::FAR_SPACING),
            Key::NONE,
            "of free ellipses: the distance that was wanted far from all of them before they were last changed, px. The window writes it; it stays while what is drawn agrees with it",
        ),
        Key::new("options", Shape::Object(&option_key::OPTIONS), "{}", "see below"),
        Key::new(
            "tone",
            Shape::Object(&tone::TONE),
            Key::NONE,
            "a picture that drives the pattern, of the lowest layer",
        ),
        Key::new(
            "points",
            Shape::Object(&points::FIELD),
            Key::NONE,
            "what a field of points is made of, with `\"system\": \"points\"`",
        ),
        Key::new(
            "maps",
            Shape::Object(&maps::MAPS),
            "{}",
            "pictures and noise by which what is asked for varies from place to place",
        ),
        Key::new(
            "colours",
            Shape::Object(&COLOURS),
            Key::NONE,
            "see below; without them the default colours of the layer",
        ),
    ],
};

/// A stroke on the canvas or on the model.
const STROKES: Shape = Shape::AnyOf(&[
    strokes::STROKE,
    Shape::Object(&body::ELLIPSE_ON_MODEL),
    Shape::Object(&body::PATH_ON_MODEL),
]);
const BEND: Shape = Shape::Numbers(&HANDLES);
const HANDLES: [Range; 4] = [limits::BEND_X, limits::BEND_Y, limits::BEND_X, limits::BEND_Y];

static COLOURS: Object = Object {
    name: "Colours",
    keys: &[
        Key::new(
            "stops",
            Shape::List(&Shape::Object(&STOP), [1, ANY]),
            Key::REQUIRED,
            "colours at pattern values, ascending; two at one value make a hard step",
        ),
        Key::new(
            "bends",
            Shape::List(&BEND, [0, ANY]),
            "[]",
            "between stops i and i + 1 a cubic Bezier curve x1, y1, x2, y2 as in CSS (x 0 to 1, y −2 to 3); missing ones are straight",
        ),
        Key::new(
            "ground",
            Shape::Hexadecimal("#", &[3, 6]),
            "\"#ffffff\"",
            "the second colour of the ground, sRGB; `maps.ground` says where",
        ),
        Key::new(
            "halo",
            Shape::Number(limits::HALO),
            "1",
            "how far the colours of stops below 0.5 reach from the edge of a mark: 1 = as the stops say; 0.05 = the ground has its own colour up to the edge",
        ),
    ],
};

static STOP: Object = Object {
    name: "Stop",
    keys: &[
        Key::new("at", Shape::Number(limits::STOP), Key::REQUIRED, "the pattern value"),
        Key::new(
            "colour",
            Shape::Hexadecimal("#", &[3, 6, 8]),
            Key::REQUIRED,
            "the colour, sRGB, and with two more digits its opacity, `00` = transparent",
        ),
    ],
};

/// The document that `root`, of the newest version, holds.
pub(super) fn document(root: &Node) -> Result<Document, Problem> {
    root.is(&DOCUMENT)?;
    let default = Document::default();
    let size = root.need("size", "[width, height] in px")?.counts([limits::MAX_SIDE; 2])?;
    let most = size.map(|side| side.min(limits::MAX_REGIONS));
    let regions = root.get("regions").map(|node| node.counts(most)).transpose()?;
    let node = root.get("model");
    let parametric = node.as_ref().map_or(Ok(None), parametric::read)?;
    let body = node.filter(|_| parametric.is_none());
    let model = body.map(|node| body::read(&node, regions.unwrap_or([1, 1]))).transpose()?;
    let (layers, hair) = layers(&root.need("layers", "a list of layers")?, size, model.as_ref())?;
    let finish = root.get("finish").map(|node| finish::read(&node)).transpose()?;
    let ground = match (&model, &parametric) {
        (Some(_), _) => finish::Ground::Model,
        (None, Some(_)) => finish::Ground::Map,
        (None, None) => finish::Ground::Canvas,
    };
    Ok(Document {
        name: name(root)?.unwrap_or(default.name),
        size,
        regions,
        edges: root.get("edges").map_or(Ok(default.edges), |node| node.choice(&EDGES))?,
        seed: seed(root)?.unwrap_or(default.seed),
        dpi: root.get("dpi").map_or(Ok(default.dpi), |node| node.number(&limits::DPI))?,
        growth: root.get("growth").map_or(Ok(default.growth), |node| growth(&node))?,
        warp: root.get("warp").map(|node| warp::read(&node, model.is_some())).transpose()?,
        finish: finish::combined(finish, hair, ground)?,
        layers,
        model,
        parametric,
        starred: root.get("starred").map_or(Ok(Vec::new()), |node| starred(&node))?,
    })
}

/// Reads textures that are kept beside the document's own; these keep no others.
fn starred(node: &Node) -> Result<Vec<Starred>, Problem> {
    let allowed = format!("a list of at most {} objects with name and document", limits::MAX_STARRED);
    let one = |node: Node| {
        node.is(&STARRED)?;
        let inner = node.need("document", "a document")?;
        let document = document(&inner)?;
        if !document.starred.is_empty() {
            return Err(inner.found("the key \"starred\"", "a document without it"));
        }
        Ok(Starred { name: name(&node)?.unwrap_or_default(), document })
    };
    let all: Vec<Starred> = node.items(&allowed)?.map(one).collect::<Result<_, _>>()?;
    match all.len() {
        n if n > limits::MAX_STARRED => Err(node.found(format!("{n} objects"), allowed)),
        _ => Ok(all),
    }
}

fn name(node: &Node) -> Result<Option<String>, Problem> {
    let Some(node) = node.get("name") else { return Ok(None) };
    let allowed = format!("a text of at most {} characters", limits::MAX_NAME);
    let name = node.text(&allowed)?;
    if name.chars().count() > limits::MAX_NAME { Err(node.wrong(allowed)) } else { Ok(Some(name.to_owned())) }
}

fn seed(node: &Node) -> Result<Option<u64>, Problem> {
    node.get("seed").map(|node| node.whole(0, u64::MAX)).transpose()
}

fn growth(node: &Node) -> Result<Growth, Problem> {
    node.is(&GROWTH)?;
    let refine = node.get("refine").map_or(Ok(Growth::default().refine), |node| node.flag())?;
    Ok(Growth { refine })
}

/// The layers, and the place and the strokes of that of hair.
type Layers = (Vec<Layer>, Option<(String, Vec<Stroke>)>);

fn layers(node: &Node, size: [u32; 2], model: Option<&Body>) -> Result<Layers, Problem> {
    let allowed = format!("a list of 1 to {} layers", limits::MAX_LAYERS);
    let (mut layers, mut hair) = (Vec::new(), None);
    for node in node.items(&allowed)? {
        if !finish::is_hair(&node) {
            layers.push(layer(&node, layers.len(), size, model)?);
        } else if hair.replace((node.place(), finish::hair(&node, size)?)).is_some() {
            return Err(node.found("a second layer of hair", "one"));
        }
    }
    match layers.len() {
        0 => Err(node.found("no layers", allowed)),
        n if n > limits::MAX_LAYERS => Err(node.found(format!("{n} layers"), allowed)),
        _ => Ok((layers, hair)),
    }
}

fn layer(node: &Node, index: usize, size: [u32; 2], model: Option<&Body>) -> Result<Layer, Problem> {
    node.is(&LAYER)?;
    let default = Layer::default();
    let system = node.get("system").map_or(Ok(default.system), |node| node.choice(&SystemChoice::names()))?;
    let tone = node.get("tone").map(|node| tone::read(&node)).transpose()?;
    let may_be_none = tone.is_some() || system.is_known(|system| system.grows_blank);
    let strokes = node.need("strokes", "a list of strokes")?;
    let (strokes, on_model) = strokes::strokes(&strokes, (size, model), system, may_be_none)?;
    let marks = Kind::of_layer(strokes.iter().filter_map(Stroke::kind));
    let layer = Layer {
        name: name(node)?.unwrap_or_else(|| format!("layer {}", index + 1)),
        system,
        after: node.get("after").map_or(Ok(default.after), |node| node.choice(&After::NAMES))?,
        visible: node.get("visible").map_or(Ok(default.visible), |node| node.flag())?,
        seed: seed(node)?,
        strokes,
        on_model,
        far_spacing: node.get("far_spacing").map(|node| node.number(&limits::FAR_SPACING)).transpose()?,
        options: node.get("options").map_or(Ok(default.options), |node| option_key::read(&node))?,
        tone,
        points: node.get("points").map(|node| points::read(&node)).transpose()?,
        maps: node.get("maps").map_or(Ok(default.maps), |node| maps::read(&node))?,
        colours: node.get("colours").map(|node| colours(&node)).transpose()?,
    };
    let combination = Combination::new(&layer, marks, Beneath::Unknown);
    combination.problem_on_reading(&node.place()).map_or(Ok(layer), Err)
}

/// The colours of a layer or a palette.
pub(super) fn colours(node: &Node) -> Result<Colours, Problem> {
    node.is(&COLOURS)?;
    let stops = stops(&node.need("stops", "a list of colour stops")?)?;
    let bends = node.get("bends").map_or(Ok(Vec::new()), |node| bends(&node, stops.len() - 1))?;
    let ground = node.get("ground").map_or(Ok(Colours::GROUND), |node| opaque(&node))?;
    let halo = node.get("halo").map_or(Ok(1.0), |node| node.number(&limits::HALO))?;
    Ok(Colours { stops, bends, ground, halo })
}

/// Reads at least one stop; the places of stops ascend.
fn stops(node: &Node) -> Result<Vec<Stop>, Problem> {
    let mut stops: Vec<Stop> = Vec::new();
    for item in node.items("a list of colour stops")? {
        item.is(&STOP)?;
        let place = item.need("at", "a pattern value from 0 to 1")?;
        let at = place.number(&limits::STOP)?;
        if let Some(before) = stops.last().filter(|before| at < before.at) {
            let allowed = format!("no less than the stop before it, {}: stops ascend", before.at);
            return Err(place.wrong(allowed));
        }
        let [red, green, blue, alpha] = colour(&item.need("colour", "a colour such as \"#3b2314\"")?)?;
        stops.push(Stop { at, colour: [red, green, blue], alpha });
    }
    if stops.is_empty() { Err(node.found("no stops", "at least one colour stop")) } else { Ok(stops) }
}

/// `#rrggbb` or `#rgb`.
fn opaque(node: &Node) -> Result<[u8; 3], Problem> {
    const ALLOWED: &str = "#rrggbb or #rgb in hexadecimal digits";
    let has_opacity = node.text(ALLOWED)?.len() > 7;
    let [red, green, blue, _] =
        colour(node).map_err(|problem| Problem { allowed: ALLOWED.to_owned(), ..problem })?;
    if has_opacity { Err(node.wrong(ALLOWED)) } else { Ok([red, green, blue]) }
}

/// `#rrggbb`, `#rgb`, or with opacity `#rrggbbaa`.
fn colour(node: &Node) -> Result<[u8; 4], Problem> {
    const ALLOWED: &str = "#rrggbb or #rgb in hexadecimal digits; #rrggbbaa with opacity";
    let text = node.text(ALLOWED)?;
    let digits: Option<Vec<u8>> = text
        .strip_prefix('#')
        .and_then(|hex| hex.chars().map(|c| c.to_digit(16).map(|digit| digit as u8)).collect());
    match digits.as_deref() {
        Some([r, g, b]) => Ok([r * 17, g * 17, b * 17, u8::MAX]),
        Some([a, b, c, d, e, f]) => Ok([a * 16 + b, c * 16 + d, e * 16 + f, u8::MAX]),
        Some([a, b, c, d, e, f, g, h]) => Ok([a * 16 + b, c * 16 + d, e * 16 + f, g * 16 + h]),
        _ => Err(node.wrong(ALLOWED)),
    }
}

/// Reads the bends, at most one for each of the `gaps` between stops.
fn bends(node: &Node, gaps: usize) -> Result<Vec<[f64; 4]>, Problem> {
    let bends = node.items("a list of bends [x1, y1, x2, y2]")?;
    let bends: Vec<_> = bends.map(|bend| bend.numbers(HANDLES)).collect::<Result<_, _>>()?;
    if bends.len() > gaps {
        let found = format!("{} bends for {} stops", bends.len(), gaps + 1);
        return Err(node.found(found, format!("at most {gaps}: one between each stop and the next")));
    }
    Ok(bends)
}
