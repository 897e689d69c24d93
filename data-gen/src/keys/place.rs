//! Values at places of a JSON document.

use serde_json::{Map, Value};

/// Puts a value at a place (RFC 6901); null removes a key. Objects and lists that are missing on the way are made, and the place after the
/// last one of a list adds to it.
pub fn put(document: &mut Value, at: &str, value: &Value) -> Result<(), String> {
    if value.is_null() {
        remove(document, at);
        return Ok(());
    }
    let mut here = document;
    for key in at.split('/').skip(1) {
        here = step(here, key).ok_or_else(|| format!("{at}: there is no {key}"))?;
    }
    *here = value.clone();
    Ok(())
}

/// Removes the key at a place, if it is there.
fn remove(document: &mut Value, at: &str) {
    let Some((object, key)) = at.rsplit_once('/') else { return };
    if let Some(object) = document.pointer_mut(object).and_then(Value::as_object_mut) {
        object.remove(key);
    }
}

/// The value of a key or index, which is made if it is missing.
fn step<'a>(here: &'a mut Value, key: &str) -> Option<&'a mut Value> {
    let index = key.parse::<usize>().ok();
    if here.is_null() {
        *here = if index.is_some() { Value::Array(Vec::new()) } else { Value::Object(Map::new()) };
    }
    match here {
        Value::Object(object) => Some(object.entry(key).or_insert(Value::Null)),
        Value::Array(list) => {
            let index = index.filter(|index| *index <= list.len())?;
            if index == list.len() {
                list.push(Value::Null);
            }
            list.get_mut(index)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_value_is_put_where_nothing_was() {
        let mut document = json!({"layers": [{"seed": 3}]});
        put(&mut document, "/layers/0/options/keep", &json!(true)).unwrap();
        put(&mut document, "/layers/1", &json!({"system": "hair"})).unwrap();
        put(&mut document, "/layers/0/seed", &Value::Null).unwrap();
        put(&mut document, "/layers/0/maps/area", &Value::Null).unwrap();
        put(&mut document, "/layers/2", &Value::Null).unwrap();
        assert_eq!(document, json!({"layers": [{"options": {"keep": true}}, {"system": "hair"}]}));
        let error = put(&mut document, "/layers/4/seed", &json!(1)).unwrap_err();
        assert_eq!(error, "/layers/4/seed: there is no 4");
    }
}
