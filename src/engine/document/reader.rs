//! A JSON value → a checked document, key by key.

use crate::document::body;
use crate::document::finish;
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::limits;
use crate::document::limits::Range;
use crate::document::maps;
use crate::document::node::Node;
use crate::document::option_key;
use crate::document::parametric;
use crate::document::points;
use crate::document::strokes;
use crate::document::tone;
use crate::document::{
    After, Body, Colours, Document, Growth, Kind, Layer, Problem, Starred, Stop, Stroke, SystemChoice,
};
use crate::grid::Edges;

pub(super) const EDGES: [(&str, Edges); 2] = [("closed", Edges::Closed), ("wrap", Edges::Wrap)];

/// The document that `root`, of the newest version, holds.
pub(super) fn document(root: &Node) -> Result<Document, Problem> {
    root.keys(&[
        "format", "version", "name", "size", "regions", "edges", "seed", "dpi", "growth", "model", "finish",
        "layers", "starred",
    ])?;
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
    let on_model = model.is_some() || parametric.is_some();
    Ok(Document {
        name: name(root)?.unwrap_or(default.name),
        size,
        regions,
        edges: root.get("edges").map_or(Ok(default.edges), |node| node.choice(&EDGES))?,
        seed: seed(root)?.unwrap_or(default.seed),
        dpi: root.get("dpi").map_or(Ok(default.dpi), |node| node.number(&limits::DPI))?,
        growth: root.get("growth").map_or(Ok(default.growth), |node| growth(&node))?,
        finish: finish::combined(finish, hair, on_model)?,
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
        node.keys(&["name", "document"])?;
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
    node.keys(&["refine"])?;
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
    node.keys(&[
        "name",
        "system",
        "after",
        "visible",
        "seed",
        "strokes",
        "far_spacing",
        "options",
        "tone",
        "points",
        "maps",
        "colours",
    ])?;
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
    node.keys(&["stops", "bends"])?;
    let stops = stops(&node.need("stops", "a list of colour stops")?)?;
    let bends = node.get("bends").map_or(Ok(Vec::new()), |node| bends(&node, stops.len() - 1))?;
    Ok(Colours { stops, bends })
}

/// Reads at least one stop; the places of stops ascend.
fn stops(node: &Node) -> Result<Vec<Stop>, Problem> {
    let mut stops: Vec<Stop> = Vec::new();
    for item in node.items("a list of colour stops")? {
        item.keys(&["at", "colour"])?;
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
    const HANDLES: [Range; 4] = [limits::BEND_X, limits::BEND_Y, limits::BEND_X, limits::BEND_Y];
    let bends = node.items("a list of bends [x1, y1, x2, y2]")?;
    let bends: Vec<_> = bends.map(|bend| bend.numbers(HANDLES)).collect::<Result<_, _>>()?;
    if bends.len() > gaps {
        let found = format!("{} bends for {} stops", bends.len(), gaps + 1);
        return Err(node.found(found, format!("at most {gaps}: one between each stop and the next")));
    }
    Ok(bends)
}
