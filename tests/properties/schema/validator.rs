//! Validation by the keywords of JSON Schema (2020-12) that the schema of documents uses. Any other keyword stops the test.

use serde_json::Value;

/// Keywords that allow and refuse nothing.
const NOTES: [&str; 8] = [
    "$schema",
    "$defs",
    "title",
    "description",
    "default",
    "contentEncoding",
    "contentMediaType",
    "properties",
];

/// A schema with its definitions.
pub struct Schema(pub Value);

impl Schema {
    /// Whether the whole schema allows `value`.
    pub fn allows(&self, value: &Value) -> bool {
        self.part_allows(&self.0, value)
    }

    /// Whether a part of the schema allows `value`.
    pub fn part_allows(&self, part: &Value, value: &Value) -> bool {
        let keywords = part.as_object().expect("a schema is an object");
        keywords.iter().all(|(keyword, argument)| self.keyword(part, keyword, argument, value))
    }

    /// The definition that a part refers to, or the part itself.
    pub fn resolved<'a>(&'a self, part: &'a Value) -> &'a Value {
        let Some(reference) = part["$ref"].as_str() else { return part };
        let name = reference.strip_prefix("#/$defs/").expect("a definition").replace("%20", " ");
        let found = &self.0["$defs"][&name];
        assert!(found.is_object(), "{reference} is not defined");
        found
    }

    /// The part that allows the value of `key` in an object.
    pub fn property<'a>(&'a self, part: &'a Value, key: &str) -> Option<&'a Value> {
        self.resolved(part)["properties"].get(key)
    }

    fn keyword(&self, part: &Value, keyword: &str, argument: &Value, value: &Value) -> bool {
        let number = || argument.as_f64().expect("a number");
        let at_least = |count: Option<usize>| count.is_none_or(|count| count as f64 >= number());
        let at_most = |count: Option<usize>| count.is_none_or(|count| count as f64 <= number());
        let items = value.as_array().map(Vec::len);
        let characters = value.as_str().map(|text| text.chars().count());
        match keyword {
            "$ref" => self.part_allows(self.resolved(part), value),
            "type" => is_of(argument.as_str().expect("one type"), value),
            "const" => value == argument,
            "enum" => argument.as_array().expect("a list").contains(value),
            "anyOf" => argument.as_array().expect("a list").iter().any(|one| self.part_allows(one, value)),
            "minimum" => value.as_f64().is_none_or(|found| found >= number()),
            "maximum" => value.as_f64().is_none_or(|found| found <= number()),
            "minItems" => at_least(items),
            "maxItems" => at_most(items),
            "minLength" => at_least(characters),
            "maxLength" => at_most(characters),
            "pattern" => value.as_str().is_none_or(|text| matches(argument.as_str().expect("a text"), text)),
            "items" => {
                value.as_array().is_none_or(|list| list.iter().all(|one| self.part_allows(argument, one)))
            }
            "prefixItems" => {
                let parts = argument.as_array().expect("a list").iter();
                value
                    .as_array()
                    .is_none_or(|list| parts.zip(list).all(|(part, one)| self.part_allows(part, one)))
            }
            "required" => {
                let mut names = argument.as_array().expect("a list").iter().filter_map(Value::as_str);
                value.as_object().is_none_or(|object| names.all(|name| object.contains_key(name)))
            }
            "additionalProperties" => {
                assert_eq!(argument, false);
                value.as_object().is_none_or(|object| {
                    object.iter().all(|(key, value)| {
                        part["properties"].get(key).is_some_and(|part| self.part_allows(part, value))
                    })
                })
            }
            note => {
                assert!(NOTES.contains(&note), "the keyword {note} is not evaluated");
                true
            }
        }
    }
}

fn is_of(kind: &str, value: &Value) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        _ => panic!("the type {kind} is not evaluated"),
    }
}

/// Whether a text matches `^PREFIX([0-9a-fA-F]{N}|…)$`.
fn matches(pattern: &str, text: &str) -> bool {
    let (prefix, rest) = pattern.strip_prefix('^').and_then(|rest| rest.split_once('(')).expect("a prefix");
    let counts = rest.strip_suffix(")$").expect("an end").split('|');
    let mut counts = counts.map(|one| {
        let count = one.strip_prefix("[0-9a-fA-F]{").and_then(|one| one.strip_suffix('}'));
        count.and_then(|count| count.parse::<usize>().ok()).expect("a number of digits")
    });
    let digits = text.strip_prefix(prefix).filter(|text| text.chars().all(|c| c.is_ascii_hexdigit()));
    digits.is_some_and(|digits| counts.any(|count| digits.len() == count))
}
