//! Ways to break a document that a schema can express.

use super::validator::Schema;
use serde_json::{Value, json};

/// A place in a document, and a value that is wrong there; without one the key is removed.
pub struct Break {
    /// The place, as a JSON pointer.
    pub place: String,
    /// The new value.
    pub value: Option<Value>,
}

impl Break {
    /// The document with the break.
    pub fn applied(&self, document: &Value) -> Value {
        let mut document = document.clone();
        let (parent, key) = self.place.rsplit_once('/').expect("a place within");
        let parent = document.pointer_mut(parent).expect("the place is there");
        match (parent, &self.value) {
            (Value::Object(object), None) => drop(object.remove(key)),
            (Value::Object(object), Some(value)) => drop(object.insert(key.to_owned(), value.clone())),
            (Value::Array(list), Some(value)) => {
                list[key.parse::<usize>().expect("an index")] = value.clone();
            }
            _ => panic!("{} is in no object", self.place),
        }
        document
    }
}

/// All breaks of `value` at `place` by `part` of the schema, and of everything in it.
pub fn breaks(schema: &Schema, part: &Value, value: &Value, place: &str) -> Vec<Break> {
    let part = schema.resolved(part);
    let mut found = Vec::new();
    if let Some(branches) = part["anyOf"].as_array() {
        let taken =
            branches.iter().find(|branch| schema.part_allows(branch, value)).expect("a valid document");
        return breaks(schema, taken, value, place);
    }
    let mut put = |place: String, value: Option<Value>| found.push(Break { place, value });
    if !place.is_empty() {
        for wrong in wrong_values(part, value) {
            put(place.to_owned(), Some(wrong));
        }
    }
    if let Some(object) = value.as_object() {
        put(format!("{place}/surplus"), Some(json!(1)));
        for name in part["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            put(format!("{place}/{name}"), None);
        }
        for (key, value) in object {
            let part = schema.property(part, key).expect("a valid document");
            found.extend(breaks(schema, part, value, &format!("{place}/{key}")));
        }
    }
    for (index, value) in value.as_array().into_iter().flatten().enumerate() {
        let item = part["prefixItems"].get(index).unwrap_or(&part["items"]);
        found.extend(breaks(schema, item, value, &format!("{place}/{index}")));
    }
    found
}

/// Values of another type, and beyond each limit of the part.
fn wrong_values(part: &Value, value: &Value) -> Vec<Value> {
    let mut wrong = vec![Value::Null, if value.is_boolean() { json!(1) } else { json!(true) }];
    wrong.extend(part["minimum"].as_f64().map(|least| json!(least - 1.0)));
    wrong.extend(part["maximum"].as_f64().map(|most| json!(most + (most.abs() * 1e-6).max(1.0))));
    wrong.extend(part["maxLength"].as_u64().map(|most| json!("x".repeat(most as usize + 1))));
    if part["type"] == "integer" {
        wrong.push(json!(1.5));
    }
    if value.is_string() && part["contentEncoding"].is_null() {
        wrong.push(json!("no such value, with more than one word"));
        wrong
            .retain(|wrong| !part["maxLength"].is_u64() || wrong != "no such value, with more than one word");
    }
    if let Some(list) = value.as_array() {
        if part["minItems"].as_u64().is_some_and(|least| least > 0) {
            wrong.push(json!([]));
        }
        if part["maxItems"].as_u64() == Some(list.len() as u64) {
            let more = [list.clone(), vec![list.last().cloned().unwrap_or_default()]].concat();
            wrong.push(Value::Array(more));
        }
    }
    wrong
}
