//! The JSON Schema of documents, made from the tables of the reader.

use crate::document::limits::Range;
use crate::document::reader::DOCUMENT;
use crate::document::shape::{ANY, Key, Object, Shape};
use serde_json::{Map, Value, json};

/// The dialect of the schema.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";
const TITLE: &str = "a dapple document (.dapple)";
const ABOUT: &str = "Lengths are px, x to the right, y down; angles are degrees from +x towards +y, axial. What a schema cannot say is \
                     checked by `dapple check`: that marks are on the canvas, and which options go with which marks and systems.";

/// The JSON Schema (2020-12) of documents, as text.
///
/// What it refuses, [`Document::parse`](crate::document::Document::parse) refuses. What depends on several values is not in it.
///
/// ```
/// let schema = dapple_engine::document::schema();
/// assert!(schema.contains("\"$defs\""));
/// ```
#[must_use]
pub fn schema() -> String {
    let mut definitions = Map::new();
    let Value::Object(document) = object(&DOCUMENT, &mut definitions) else { return String::new() };
    let mut whole = Map::new();
    whole.insert("$schema".into(), json!(DIALECT));
    whole.insert("title".into(), json!(TITLE));
    whole.insert("description".into(), json!(ABOUT));
    whole.extend(document.into_iter().filter(|(key, _)| key != "title"));
    whole.insert("$defs".into(), Value::Object(definitions));
    // Numbers, texts, lists and objects can always be written.
    serde_json::to_string_pretty(&whole).unwrap_or_default() + "\n"
}

/// The schema of an object; those of the objects in it are added to `definitions`.
fn object(object: &Object, definitions: &mut Map<String, Value>) -> Value {
    let mut properties = Map::new();
    for key in object.keys {
        let mut property = shape(&key.shape, definitions);
        property.insert("description".into(), json!(key.meaning));
        if let Ok(default) = serde_json::from_str::<Value>(key.default) {
            property.insert("default".into(), default);
        }
        properties.insert(key.name.to_owned(), Value::Object(property));
    }
    let required = object.keys.iter().filter(|key| key.default == Key::REQUIRED).map(|key| key.name);
    json!({"title": object.name, "type": "object", "properties": properties,
        "required": required.collect::<Vec<_>>(), "additionalProperties": false})
}

fn shape(of: &Shape, definitions: &mut Map<String, Value>) -> Map<String, Value> {
    let value = match of {
        Shape::Choice(names) => match &names()[..] {
            [one] => json!({"const": one}),
            several => json!({"enum": several}),
        },
        Shape::Text(length) => with_length(json!({"type": "string"}), ["minLength", "maxLength"], *length),
        Shape::Hexadecimal(prefix, counts) => {
            let digits: Vec<String> = counts.iter().map(|count| format!("[0-9a-fA-F]{{{count}}}")).collect();
            json!({"type": "string", "pattern": format!("^{prefix}({})$", digits.join("|"))})
        }
        Shape::Png => json!({"type": "string", "contentEncoding": "base64", "contentMediaType": "image/png"}),
        Shape::Flag => json!({"type": "boolean"}),
        Shape::Number(range) => number(range),
        Shape::Whole(range) => whole(range),
        Shape::Numbers(ranges) => tuple(&ranges.iter().map(number).collect::<Vec<Value>>()),
        Shape::Wholes(ranges) => tuple(&ranges.iter().map(whole).collect::<Vec<Value>>()),
        Shape::List(item, length) => {
            let list = json!({"type": "array", "items": shape(item, definitions)});
            with_length(list, ["minItems", "maxItems"], *length)
        }
        Shape::Object(of) => {
            if !definitions.contains_key(of.name) {
                // Its place, before the objects in it.
                definitions.insert(of.name.to_owned(), Value::Null);
                let defined = object(of, definitions);
                definitions.insert(of.name.to_owned(), defined);
            }
            json!({"$ref": format!("#/$defs/{}", of.name.replace(' ', "%20"))})
        }
        Shape::AnyOf(shapes) => {
            json!({"anyOf": shapes.iter().map(|one| shape(one, definitions)).collect::<Vec<_>>()})
        }
    };
    if let Value::Object(map) = value { map } else { Map::new() }
}

/// A list of one value for each of these schemas.
fn tuple(items: &[Value]) -> Value {
    let count = items.len();
    json!({"type": "array", "prefixItems": items, "minItems": count, "maxItems": count})
}

fn number(range: &Range) -> Value {
    let mut schema = json!({"type": "number"});
    if *range != Range::ANGLE {
        schema["minimum"] = crate::document::node::number(range.low);
        schema["maximum"] = crate::document::node::number(range.high);
    }
    schema
}

fn whole([low, high]: &[u64; 2]) -> Value {
    json!({"type": "integer", "minimum": low, "maximum": high})
}

/// Adds the least and the largest length, where they are limits.
fn with_length(mut schema: Value, [least, most]: [&str; 2], [low, high]: [usize; 2]) -> Value {
    if low > 0 {
        schema[least] = json!(low);
    }
    if high != ANY {
        schema[most] = json!(high);
    }
    schema
}
