//! Documents: what a `.dapple` file may contain, and the message about each invalid one.

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

/// Asserts that `document` is refused with a message with exactly this place, value and allowed values.
#[track_caller]
fn refused(document: &Value, place: &str, found: &str, allowed: &str) {
    let message = error_of_text(&document.to_string());
    assert_eq!(message, format!("bad.dapple: {place}: found {found}; allowed: {allowed}"));
}

/// Asserts that `text` is refused at this line and column with a message that begins with these words.
#[track_caller]
fn no_json(text: &str, line: usize, column: usize, found: &str) {
    let message = error_of_text(text);
    let start = format!("bad.dapple: line {line}, column {column}: found {found}");
    assert!(message.starts_with(&start), "{message}\nshould start with\n{start}");
    assert!(message.contains("; allowed: "), "{message}");
}

#[track_caller]
fn accepted(document: &Value) -> Document {
    Document::parse(&document.to_string(), "good.dapple").unwrap()
}
