//! Documents: what a `.dapple` file may contain, and the message about each invalid file.

use assert_cmd::Command;
use dapple::document::Edges;
use dapple::document::{
    After, Colours, Document, DocumentError, DutyChoice, Growth, Layer, Starred, Stop, Stroke, SystemChoice,
};
use dapple::document::{Ellipse, Line};
use proptest::prelude::*;
use serde_json::{Value, json};

mod content;
mod crossing;
mod files;
mod format;
mod keep;
mod maps;
mod model;
mod no_json;
mod options;
mod outlines;
mod points;
mod properties;
mod read;
mod shown;
mod tone;
mod values;

/// The shortest valid document.
fn least() -> Value {
    json!({
        "format": "dapple", "version": 2, "size": [512, 256],
        "layers": [{"strokes": [{"kind": "ellipse", "center": [64, 64], "radii": [12, 6], "angle": 30}]}]
    })
}

/// The shortest document with `stroke` as its only one.
fn with_stroke(stroke: &Value) -> Value {
    with("/layers/0/strokes", json!([stroke]))
}

/// The shortest document with another `value` at a JSON pointer, whose last key may be new.
fn with(pointer: &str, value: Value) -> Value {
    let mut document = least();
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    match document.pointer_mut(parent).unwrap() {
        Value::Object(map) => drop(map.insert(key.to_owned(), value)),
        Value::Array(list) => list[key.parse::<usize>().unwrap()] = value,
        _ => panic!("no container at {parent}"),
    }
    document
}

fn error_of_text(text: &str) -> String {
    Document::parse(text, "bad.dapple").unwrap_err().to_string()
}

/// The values that a text names: numbers, quoted texts, lists in brackets, items of a list, and a text of one word. The
/// words between them are left out.
fn named(text: &str) -> Vec<&str> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let is_item = |index: usize| words[index].ends_with(',') || index > 0 && words[index - 1].ends_with(',');
    let is_name = |index: usize| {
        let word = words[index];
        words.len() == 1
            || word.contains(|c: char| c.is_ascii_digit() || "\"[]{}#".contains(c))
            || ["true", "false"].contains(&word)
            || is_item(index)
    };
    let ends = |c: char| ",;:.?()".contains(c);
    let kept = (0..words.len()).filter(|index| is_name(*index));
    kept.map(|index| words[index].trim_matches(ends)).filter(|word| !word.is_empty()).collect()
}

/// Asserts that `message` is about this place of `bad.dapple`, and names the values in `found` and `allowed`, in this
/// order.
#[track_caller]
fn names(message: &str, place: &str, found: &str, allowed: &str) {
    let rest = message.strip_prefix(&format!("bad.dapple: {place}: "));
    let parts = rest.and_then(|rest| rest.split_once("; allowed: "));
    let (value, remedy) = parts.unwrap_or_else(|| panic!("{place}, value and remedy in {message}"));
    for (text, expected) in [(value, found), (remedy, allowed)] {
        let mut left = text;
        for name in named(expected) {
            let at = left.find(name).unwrap_or_else(|| panic!("{name} of {expected:?} in {message}"));
            left = &left[at + name.len()..];
        }
    }
    assert!(!remedy.is_empty(), "a remedy in {message}");
}

/// Asserts that `document` is refused with a message that names this place, the value and the allowed values.
#[track_caller]
fn refused(document: &Value, place: &str, found: &str, allowed: &str) {
    names(&error_of_text(&document.to_string()), place, found, allowed);
}

/// Asserts that `text` is refused with a message that names this line, this column and the characters that were found
/// there.
#[track_caller]
fn no_json(text: &str, line: usize, column: usize, found: &str) {
    names(&error_of_text(text), &format!("line {line}, column {column}"), found, "");
}

#[test]
fn the_values_in_a_message_are_separated_from_its_words() {
    assert_eq!(named("a number from 0.01 to 512 px"), ["0.01", "512"]);
    assert_eq!(named("the unknown key \"speed\""), ["\"speed\""]);
    assert_eq!(named("level, direction, spacing (did you mean level?)"), ["level", "direction", "spacing"]);
    assert_eq!(named("[1,2]"), ["[1,2]"]);
    assert_eq!(named("refine"), ["refine"]);
    assert_eq!(named("no strokes"), [""; 0]);
}

#[track_caller]
fn accepted(document: &Value) -> Document {
    Document::parse(&document.to_string(), "good.dapple").unwrap()
}
