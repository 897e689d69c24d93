//! JSON output. Values that do not exist are left out.

use serde_json::{Map, Value};

use super::{Error, print};

/// Prints an object, indented.
///
/// # Errors
/// Stdout is closed or full.
pub fn print_json(object: Value) -> Result<(), Error> {
    print(&format!("{:#}\n", known(object)))
}

/// `value` without entries that are null: those that do not apply, and numbers that are infinite or not a number. A
/// list that contains such an entry is left out as a whole, because the position in a list has a meaning.
pub fn known(value: Value) -> Value {
    existing(value).unwrap_or(Value::Object(Map::new()))
}

fn existing(value: Value) -> Option<Value> {
    match value {
        Value::Null => None,
        Value::Array(items) => items.into_iter().map(existing).collect::<Option<Vec<_>>>().map(Value::Array),
        Value::Object(entries) => {
            let entries = entries.into_iter().filter_map(|(name, value)| Some((name, existing(value)?)));
            Some(Value::Object(entries.collect()))
        }
        value => Some(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_that_do_not_exist_are_left_out() {
        let object = json!({"a": f64::NAN, "b": [1.0, f64::INFINITY], "c": {"d": null, "e": 1}, "f": [{"g": null}], "h": []});
        assert_eq!(known(object).to_string(), r#"{"c":{"e":1},"f":[{}],"h":[]}"#);
    }
}
