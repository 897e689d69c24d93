//! A document → JSON that people can read: short things on one line, keys in the order of `docs/format.md`.

use crate::document::node::number;
use crate::document::{
    Body, BodyEllipse, BodyMark, BodySource, Colours, Document, FlowChoice, Interpolation, Labels, Layer,
    LayerMap, MapSource, ParametricSurface, Pin, Points, Progression, Starred, Stop, Stroke, Tone, Towards,
    choices, finish, migrate, option_key, reader, warp,
};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// Longest line of a list or an object that is written on one line.
const LINE: usize = 100;

/// The whole document, without what is derived from other values (a layer's seed, its colours).
pub(super) fn value(document: &Document) -> Value {
    let edges = reader::EDGES.iter().find(|(_, edges)| *edges == document.edges).map(|(name, _)| name);
    let mut map = Map::new();
    map.insert("format".into(), json!("dapple"));
    map.insert("version".into(), json!(migrate::NEWEST));
    map.insert("name".into(), json!(document.name));
    map.insert("size".into(), json!(document.size));
    if let Some(regions) = document.regions {
        map.insert("regions".into(), json!(regions));
    }
    map.insert("edges".into(), json!(edges));
    map.insert("seed".into(), json!(document.seed));
    map.insert("dpi".into(), number(document.dpi));
    map.insert("growth".into(), json!({"refine": document.growth.refine}));
    if let Some(body) = &document.model {
        map.insert("model".into(), model(body));
    }
    if let Some(surface) = &document.parametric {
        map.insert("model".into(), parametric(surface));
    }
    if let Some(warp) = &document.warp {
        map.insert("warp".into(), warp::written(warp));
    }
    if let Some(finishing) = &document.finish {
        map.insert("finish".into(), finish::written(finishing));
    }
    map.insert("layers".into(), document.layers.iter().map(layer).chain(hair(document)).collect());
    if !document.starred.is_empty() {
        let one = |starred: &Starred| json!({"name": starred.name, "document": inner(&starred.document)});
        map.insert("starred".into(), document.starred.iter().map(one).collect());
    }
    Value::Object(map)
}

/// A document inside another one, which has the format and the version of the outer one.
fn inner(document: &Document) -> Value {
    let mut value = value(document);
    if let Value::Object(map) = &mut value {
        map.shift_remove("format");
        map.shift_remove("version");
    }
    value
}

fn parametric(surface: &ParametricSurface) -> Value {
    match surface {
        ParametricSurface::Heights(relief) => json!({"height": relief.path, "scale": number(relief.scale)}),
        ParametricSurface::Torus => json!({"surface": surface.name()}),
    }
}

/// The layer of hair, if there is one.
fn hair(document: &Document) -> Option<Value> {
    let FlowChoice::Strokes(strokes) = &document.finish.as_ref()?.flow else { return None };
    Some(json!({"system": finish::HAIR, "strokes": strokes.iter().map(stroke).collect::<Vec<_>>()}))
}

fn layer(layer: &Layer) -> Value {
    let mut map = Map::new();
    map.insert("name".into(), json!(layer.name));
    map.insert("system".into(), json!(layer.system.name()));
    map.insert("after".into(), json!(layer.after.name()));
    map.insert("visible".into(), json!(layer.visible));
    if let Some(seed) = layer.seed {
        map.insert("seed".into(), json!(seed));
    }
    let strokes = layer.strokes.iter().map(stroke).chain(layer.on_model.iter().map(body_mark));
    map.insert("strokes".into(), strokes.collect());
    if let Some(spacing) = layer.far_spacing {
        map.insert("far_spacing".into(), number(spacing));
    }
    map.insert("options".into(), option_key::written(&layer.options));
    if let Some(driven) = &layer.tone {
        map.insert("tone".into(), tone(driven));
    }
    if let Some(made) = &layer.points {
        map.insert("points".into(), points(made));
    }
    if !layer.maps.is_empty() {
        let named = layer.maps.iter().map(|(key, one)| (key.name().to_owned(), layer_map(one)));
        map.insert("maps".into(), Value::Object(named.collect()));
    }
    if let Some(set) = &layer.colours {
        map.insert("colours".into(), colours(set));
    }
    Value::Object(map)
}

/// The keys of a model that are not at their defaults.
fn model(body: &Body) -> Value {
    let mut map = Map::new();
    map.insert("file".into(), json!(body.source.name()));
    if let BodySource::File { sha256: Some(digest), .. } = &body.source {
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        map.insert("sha256".into(), json!(digits));
    }
    map.insert("px".into(), number(body.px));
    map.insert("up".into(), json!(body.up.name()));
    map.insert("along".into(), json!(body.along.name()));
    if !body.pins.is_empty() {
        map.insert("pins".into(), body.pins.iter().map(pin).collect());
    }
    if !body.strokes.is_empty() {
        let strokes = body.strokes.iter().map(|points| json!({"points": in_space(points)}));
        map.insert("strokes".into(), strokes.collect());
    }
    if !body.only.is_empty() {
        map.insert("only".into(), json!(body.only));
    }
    Value::Object(map)
}

fn pin(pin: &Pin) -> Value {
    let mut map = Map::new();
    map.insert("region".into(), json!(pin.region));
    map.insert("at".into(), numbers(&pin.at));
    if let Some(toward) = &pin.toward {
        map.insert("toward".into(), numbers(toward));
    }
    Value::Object(map)
}

fn in_space(points: &[[f64; 3]]) -> Value {
    points.iter().map(|point| numbers(point)).collect()
}

/// A mark on the model.
fn body_mark(mark: &BodyMark) -> Value {
    let mut map = Map::new();
    match mark {
        BodyMark::Ellipse(BodyEllipse { at, normal, radii, angle }) => {
            map.insert("kind".into(), json!("ellipse"));
            map.insert("at".into(), numbers(at));
            if let Some(normal) = normal {
                map.insert("normal".into(), numbers(normal));
            }
            map.insert("radii".into(), numbers(radii));
            map.insert("angle".into(), number(*angle));
        }
        BodyMark::Path { points, width } => {
            map.insert("kind".into(), json!("path"));
            map.insert("points".into(), in_space(points));
            map.insert("width".into(), number(*width));
        }
    }
    Value::Object(map)
}

fn tone(tone: &Tone) -> Value {
    json!({
        "image": {"png": tone.image.base64()}, "range": numbers(&tone.range), "drives": tone.drives.names(),
        "sketch": number(tone.sketch), "equalise": tone.equalise
    })
}

/// The keys of points that are not at their defaults.
fn points(points: &Points) -> Value {
    let default = Points::default();
    let mut map = Map::new();
    if let Some(distance) = points.distance {
        map.insert("distance".into(), one_or_two(distance));
    }
    let progression = match &points.progression {
        Progression::Across => None,
        Progression::Down => Some(json!("down")),
        Progression::Outward => Some(json!("outward")),
        Progression::Image(image) => Some(json!({"png": image.base64()})),
    };
    if let Some(progression) = progression {
        map.insert("progression".into(), progression);
    }
    map.insert("labels".into(), labels(&points.labels));
    if points.octaves != default.octaves {
        map.insert("octaves".into(), json!(points.octaves));
    }
    if points.fold {
        map.insert("fold".into(), json!(true));
    }
    if points.interpolation != default.interpolation {
        map.insert(
            "interpolation".into(),
            json!(choices::name_in(&Interpolation::NAMES, points.interpolation)),
        );
    }
    for (key, value, usual) in [("axis", points.axis, default.axis), ("shift", points.shift, default.shift)] {
        if value != usual {
            map.insert(key.into(), number(value));
        }
    }
    match points.towards {
        Towards::Random => {}
        Towards::Outward => {
            map.insert("towards".into(), json!("outward"));
        }
        Towards::Angle(angle) => {
            map.insert("towards".into(), number(angle));
        }
    }
    if let Some(share) = points.share {
        map.insert("share".into(), number(share));
    }
    Value::Object(map)
}

fn labels(labels: &Labels) -> Value {
    let kind = labels.name();
    match labels {
        Labels::Values { group } => json!({"kind": kind, "group": group}),
        Labels::Random { dark } => json!({"kind": kind, "dark": one_or_two(*dark)}),
        Labels::Image { image, passes } => {
            json!({"kind": kind, "image": {"png": image.base64()}, "passes": passes})
        }
        Labels::SpaceGiraffe { rays } => json!({"kind": kind, "rays": rays}),
        Labels::BreadthFirst { size } | Labels::DepthFirst { size } => json!({"kind": kind, "size": size}),
        Labels::RoundRobin { size, rings } => json!({"kind": kind, "size": size, "rings": rings}),
        Labels::Connected { start, rings } => json!({"kind": kind, "start": number(*start), "rings": rings}),
    }
}

/// Two numbers, or one number if they are equal.
fn one_or_two(both: [f64; 2]) -> Value {
    if both[0] == both[1] { number(both[0]) } else { numbers(&both) }
}

fn layer_map(map: &LayerMap) -> Value {
    let range = numbers(&map.range);
    match &map.source {
        MapSource::Image { image, factor } => {
            let mut value = json!({"image": {"png": image.base64()}, "range": range});
            if *factor {
                value["factor"] = json!(true);
            }
            value
        }
        MapSource::Noise { size, octaves } => {
            json!({"noise": {"size": number(*size), "octaves": octaves, "range": range}})
        }
    }
}

fn stroke(stroke: &Stroke) -> Value {
    match stroke {
        Stroke::Ellipse(e) => json!({
            "kind": "ellipse", "center": numbers(&e.center), "radii": numbers(&e.radii), "angle": number(e.angle)
        }),
        Stroke::Fitted { ellipse, outline } => json!({
            "kind": "ellipse", "center": numbers(&ellipse.center), "radii": numbers(&ellipse.radii),
            "angle": number(ellipse.angle),
            "outline": outline.points.iter().map(|point| numbers(point)).collect::<Vec<_>>()
        }),
        Stroke::Line(l) => json!({
            "kind": "line", "from": numbers(&l.from), "to": numbers(&l.to), "width": number(l.width)
        }),
        Stroke::Path(path) => json!({
            "kind": "path",
            "points": path.points.iter().map(|point| numbers(point)).collect::<Vec<_>>(),
            "width": number(path.width)
        }),
        Stroke::Freehand { points, width } => json!({
            "kind": "freehand",
            "points": points.iter().map(|point| numbers(point)).collect::<Vec<_>>(),
            "width": number(*width)
        }),
        Stroke::Outline(outline) => json!({
            "kind": "outline",
            "points": outline.points.iter().map(|point| numbers(point)).collect::<Vec<_>>()
        }),
    }
}

pub(super) fn colours(colours: &Colours) -> Value {
    let stops = colours.stops.iter().map(|stop| json!({"at": number(stop.at), "colour": stop.hex()}));
    let bends = colours.bends.iter().map(|bend| numbers(bend));
    let mut value = json!({"stops": stops.collect::<Vec<_>>(), "bends": bends.collect::<Vec<_>>()});
    if colours.ground != Colours::GROUND {
        value["ground"] = json!(Stop::opaque(0.0, colours.ground).hex());
    }
    if colours.halo < 1.0 {
        value["halo"] = number(colours.halo);
    }
    value
}

fn numbers(numbers: &[f64]) -> Value {
    numbers.iter().map(|x| number(*x)).collect()
}

/// The JSON text of `value`, ending with a newline.
pub(super) fn text(value: &Value) -> String {
    let mut out = String::new();
    several_lines(&mut out, value, 0);
    out.push('\n');
    out
}

/// Writes `value` on several lines; those of its parts that fit on one line are written on one.
fn several_lines(out: &mut String, value: &Value, indent: usize) {
    match value {
        Value::Object(map) if !map.is_empty() => {
            out.push('{');
            for (i, (key, value)) in map.iter().enumerate() {
                new_line(out, i, indent + 2);
                let _ = write!(out, "{}: ", json!(key));
                part(out, value, indent + 2, key.chars().count() + 4);
            }
            close(out, indent, '}');
        }
        Value::Array(items) if !items.is_empty() => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                new_line(out, i, indent + 2);
                part(out, item, indent + 2, 0);
            }
            close(out, indent, ']');
        }
        value => line(out, value),
    }
}

/// Writes a part of an object or list; a layer always takes several lines, so that all layers look alike.
fn part(out: &mut String, value: &Value, indent: usize, used: usize) {
    let mut short = String::new();
    if value.get("strokes").is_none() && !long(value) {
        line(&mut short, value);
    }
    if short.is_empty() || indent + used + short.chars().count() > LINE {
        several_lines(out, value, indent);
    } else {
        out.push_str(&short);
    }
}

/// Whether a value is certainly too long for one line, so that this need not be tried.
fn long(value: &Value) -> bool {
    match value {
        Value::Array(items) => items.len() > LINE || items.iter().any(Value::is_object),
        Value::Object(map) => map.values().any(long),
        _ => false,
    }
}

fn new_line(out: &mut String, i: usize, indent: usize) {
    out.push_str(if i == 0 { "\n" } else { ",\n" });
    out.extend(std::iter::repeat_n(' ', indent));
}

fn close(out: &mut String, indent: usize, bracket: char) {
    out.push('\n');
    out.extend(std::iter::repeat_n(' ', indent));
    out.push(bracket);
}

/// Writes `value` on one line, with a space after each comma and colon.
fn line(out: &mut String, value: &Value) {
    match value {
        Value::Object(map) => {
            out.push('{');
            for (i, (key, value)) in map.iter().enumerate() {
                let _ = write!(out, "{}{}: ", if i == 0 { "" } else { ", " }, json!(key));
                line(out, value);
            }
            out.push('}');
        }
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { ", " });
                line(out, item);
            }
            out.push(']');
        }
        value => {
            let _ = write!(out, "{value}");
        }
    }
}
