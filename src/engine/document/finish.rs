//! The finish of a texture (`"finish"`), and the layer of hair that says in which direction it lies (`"system": "hair"`).

use crate::document::choices::names;
use crate::document::limits::Range;
use crate::document::node::{Node, number};
use crate::document::shape::{ANY, Key, Object, Shape};
use crate::document::{Kind, Problem, Stroke, strokes};
use crate::finish;
use crate::finish::Finish;
use serde_json::{Map, Value, json};

/// The system of a layer whose strokes are directions of a finish; nothing is grown from it.
pub(in crate::document) const HAIR: &str = "hair";
/// The size of a finish.
const SIZE: Range = Range { low: Finish::SIZES[0], high: Finish::SIZES[1], unit: "px" };

/// The mottling of a finish.
const MOTTLING: Range = Range { low: Finish::MOTTLING[0], high: Finish::MOTTLING[1], unit: "" };

/// The material of a texture, and its direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Finishing {
    /// The material.
    pub finish: Finish,
    /// The direction of hair and scales.
    pub flow: FlowChoice,
}

/// The direction in which hair and scales lie, from head to tail.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum FlowChoice {
    /// Across the stripes, where the lowest visible layer has such; otherwise [`Self::HEAD_TO_TAIL`].
    #[default]
    Usual,
    /// This everywhere, degrees from +x towards +y; not axial.
    Angle(f64),
    /// Along these lines, paths and open freehand strokes, from their first point to their last one; in between as stripes turn
    /// between drawn lines.
    Strokes(Vec<Stroke>),
}

impl FlowChoice {
    /// The direction from head to tail where nothing says it, degrees: hair of cats lies so on photographs of their left side.
    pub const HEAD_TO_TAIL: f64 = 190.0;

    /// The number of strokes of hair.
    #[must_use]
    pub fn strokes(&self) -> usize {
        match self {
            Self::Usual | Self::Angle(_) => 0,
            Self::Strokes(strokes) => strokes.len(),
        }
    }
}

impl From<Finish> for Finishing {
    fn from(finish: Finish) -> Self {
        Self { finish, flow: FlowChoice::Usual }
    }
}

pub(super) static FINISH: Object = Object {
    name: "Finish",
    keys: &[
        Key::new("kind", Shape::Choice(|| names(&finish::Kind::NAMES)), Key::REQUIRED, "the material"),
        Key::new(
            "size",
            Shape::Number(SIZE),
            "10",
            "the size of its parts, of fur the mean length of a hair, px; each kind has a default of its own",
        ),
        Key::new(
            "mottle",
            Shape::Number(MOTTLING),
            "0",
            "how much its tone varies slowly and finely, standard deviation ÷ tone",
        ),
        Key::new(
            "flow",
            Shape::Number(Range::ANGLE),
            Key::NONE,
            "the direction of hair or scales from head to tail, degrees from +x towards +y, not axial; only with fur, fish-scales and reptile-scales. Without it: across the stripes where the lowest visible layer has such, otherwise 190",
        ),
    ],
};

pub(super) static HAIR_LAYER: Object = Object {
    name: "Layer of hair",
    keys: &[
        Key::new(
            "system",
            Shape::Choice(|| vec![HAIR]),
            Key::REQUIRED,
            "directions of the finish: nothing grows from it",
        ),
        Key::new(
            "strokes",
            Shape::List(&strokes::STROKE, [1, ANY]),
            Key::REQUIRED,
            "lines, paths and open freehand strokes that hair or scales follow from the first point to the last one",
        ),
    ],
};

/// The finish of a document.
pub(super) fn read(node: &Node) -> Result<Finishing, Problem> {
    node.is(&FINISH)?;
    let kind = node.need("kind", "the name of a finish, such as \"fur\"")?.choice(&finish::Kind::NAMES)?;
    let size = node.get("size").map_or(Ok(kind.usual_size()), |node| node.number(&SIZE))?;
    let flow = match node.get("flow") {
        None => FlowChoice::Usual,
        Some(node) => {
            let angle = node.number(&Range::ANGLE)?;
            if !kind.has_flow() {
                return Err(node.found(format!("a direction of {}", kind.name()), with_flow()));
            }
            FlowChoice::Angle(angle)
        }
    };
    let mottle = node.get("mottle").map_or(Ok(0.0), |node| node.number(&MOTTLING))?;
    Ok(Finishing { finish: Finish { kind, size, mottle }, flow })
}

/// The kinds that have a direction, in words.
fn with_flow() -> String {
    let named = finish::Kind::NAMES.iter().filter(|(_, kind)| kind.has_flow()).map(|(name, _)| *name);
    format!("only with {}", named.collect::<Vec<_>>().join(", "))
}

/// Whether a layer is one of hair.
pub(super) fn is_hair(layer: &Node) -> bool {
    layer.get("system").is_some_and(|node| node.text("").is_ok_and(|name| name == HAIR))
}

/// The strokes of a layer of hair on a canvas of `size` px.
pub(super) fn hair(layer: &Node, size: [u32; 2]) -> Result<Vec<Stroke>, Problem> {
    layer.is(&HAIR_LAYER)?;
    let allowed = "lines, paths and open freehand strokes, from the head to the tail";
    let list = layer.need("strokes", allowed)?;
    let found = strokes::on_canvas_of(&list, size)?;
    for (item, stroke) in list.items(allowed)?.zip(&found) {
        let mark = stroke.mark().ok_or_else(|| item.found("a stroke that is no line", allowed))?;
        if Kind::from(&mark) != Kind::Line {
            return Err(item.found("an ellipse", allowed));
        }
    }
    if found.is_empty() { Err(list.found("no strokes", allowed)) } else { Ok(found) }
}

/// What a document grows on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ground {
    /// The flat canvas.
    Canvas,
    /// The surface of a model.
    Model,
    /// The flat map of a surface.
    Map,
}

/// The finish of a document on this ground with these layers of `hair`, each with its place.
pub(super) fn combined(
    finish: Option<Finishing>,
    hair: Option<(String, Vec<Stroke>)>,
    ground: Ground,
) -> Result<Option<Finishing>, Problem> {
    let Some(finish) = finish else {
        return match hair {
            None => Ok(None),
            Some((place, _)) => {
                let found = "a layer of hair in a document without a finish";
                Err(Problem::new(place, found, format!("\"finish\", {}", with_flow())))
            }
        };
    };
    fits(&finish, ground)?;
    match hair {
        None => Ok(Some(finish)),
        Some((place, _)) if ground == Ground::Model => {
            let found = "a layer of hair, whose strokes on the canvas have no place on the model";
            Err(Problem::new(place, found, "\"flow\" of the finish, and \"strokes\" of the model"))
        }
        Some((place, _)) if finish.flow != FlowChoice::Usual => {
            Err(Problem::new(place, "a layer of hair beside finish.flow", "one of the two"))
        }
        Some((_, strokes)) => Ok(Some(Finishing { flow: FlowChoice::Strokes(strokes), ..finish })),
    }
}

/// Refuses a finish that cannot be on this ground.
fn fits(Finishing { finish, .. }: &Finishing, ground: Ground) -> Result<(), Problem> {
    let kind = finish.kind;
    match ground {
        Ground::Canvas => Ok(()),
        Ground::Model => kind.on_models().map_err(|why| {
            let found = format!("{} on a model: {why}", kind.name());
            Problem::new("finish.kind", found, on_models())
        }),
        Ground::Map => {
            let found =
                "a finish on the map of a surface, on which its parts would be stretched where that is steep";
            Err(Problem::new("finish", found, "a document without \"model\", or without \"finish\""))
        }
    }
}

/// The kinds that can be on a model, in words.
fn on_models() -> String {
    let named =
        finish::Kind::NAMES.iter().filter(|(_, kind)| kind.on_models().is_ok()).map(|(name, _)| *name);
    named.collect::<Vec<_>>().join(", ")
}

/// The finish as JSON.
pub(super) fn written(finishing: &Finishing) -> Value {
    let mut map = Map::new();
    map.insert("kind".into(), json!(finishing.finish.kind.name()));
    map.insert("size".into(), number(finishing.finish.size));
    if finishing.finish.mottle > 0.0 {
        map.insert("mottle".into(), number(finishing.finish.mottle));
    }
    if let FlowChoice::Angle(angle) = finishing.flow {
        map.insert("flow".into(), number(angle));
    }
    Value::Object(map)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;

    /// A document with this finish, and with a second layer.
    fn parsed(finish: &str, layer: &str) -> Result<Document, String> {
        let spot = r#"{"strokes": [{"kind": "ellipse", "center": [30, 30], "radii": [8, 5]}]}"#;
        let text = format!(
            r#"{{"format": "dapple", "version": 2, "size": [96, 96], {finish} "layers": [{spot} {layer}]}}"#
        );
        Document::parse(&text, "a").map_err(|error| error.to_string())
    }

    const HAIR: &str =
        r#", {"system": "hair", "strokes": [{"kind": "line", "from": [90, 10], "to": [10, 20]}]}"#;

    #[test]
    fn a_finish_is_read_and_written() {
        for finish in [
            r#""finish": {"kind": "fur"},"#,
            r#""finish": {"kind": "twill", "size": 4.5, "mottle": 0.1},"#,
            "",
        ] {
            let document = parsed(finish, "").unwrap();
            assert_eq!(document.finish.is_some(), !finish.is_empty());
            assert_eq!(Document::parse(&document.to_json(), "b").unwrap(), document);
        }
        let angled = parsed(r#""finish": {"kind": "fur", "size": 20, "flow": -100},"#, "").unwrap();
        assert_eq!(angled.finish.as_ref().unwrap().flow, FlowChoice::Angle(-100.0));
        assert_eq!(Document::parse(&angled.to_json(), "b").unwrap(), angled);
    }

    #[test]
    fn the_strokes_of_a_layer_of_hair_are_directions_and_no_layer() {
        let document = parsed(r#""finish": {"kind": "fur"},"#, HAIR).unwrap();
        assert_eq!(document.layers.len(), 1);
        let flow = &document.finish.as_ref().unwrap().flow;
        assert!(matches!(flow, FlowChoice::Strokes(strokes) if strokes.len() == 1), "{flow:?}");
        assert_eq!(Document::parse(&document.to_json(), "b").unwrap(), document);
        let link = document.fragment().unwrap();
        assert_eq!(Document::from_link(&link).unwrap().finish, document.finish);
    }

    #[test]
    fn strokes_of_hair_are_kept_with_a_finish_without_a_direction() {
        let document = parsed(r#""finish": {"kind": "cloth"},"#, HAIR).unwrap();
        assert_eq!(document.finish.as_ref().unwrap().flow.strokes(), 1);
        assert_eq!(Document::parse(&document.to_json(), "b").unwrap(), document);
    }

    #[test]
    fn what_a_finish_cannot_be_is_refused_with_the_reason() {
        let ellipse =
            r#", {"system": "hair", "strokes": [{"kind": "ellipse", "center": [30, 30], "radii": [8, 5]}]}"#;
        for (finish, layer, words) in [
            (r#""finish": {"kind": "feathers"},"#, "", "fish-scales"),
            (r#""finish": {},"#, "", "no key \"kind\""),
            (r#""finish": {"kind": "fur", "size": 100},"#, "", "from 2 to 64 px"),
            (r#""finish": {"kind": "cloth", "flow": 30},"#, "", "only with fur"),
            (r#""finish": {"kind": "fur", "mottle": 0.5},"#, "", "from 0 to 0.3"),
            (r#""finish": {"kind": "fur", "flow": 30},"#, HAIR, "one of the two"),
            (r#""finish": {"kind": "cloth"}, "model": {"file": "sphere"},"#, "", "allowed: fur, fish-scales"),
            (r#""finish": {"kind": "fur"}, "model": {"file": "sphere"},"#, HAIR, "no place on the model"),
            ("", HAIR, "without a finish"),
            (r#""finish": {"kind": "fur"},"#, ellipse, "found an ellipse"),
        ] {
            let error = parsed(finish, layer).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }
}
