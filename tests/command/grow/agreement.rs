//! `dapple check` and `dapple grow` agree on a document, and no picture is blank without a note.

use crate::grow::folder::{Folder, document};
use serde_json::{Value, json};

/// One ellipse that covers the whole of a small tile.
fn covering() -> Value {
    let ellipse = json!([{"kind": "ellipse", "center": [1, 99], "radii": [100, 25], "angle": 30}]);
    let mut document = document([100, 100], &ellipse);
    document["edges"] = json!("wrap");
    document
}

/// A field of points, on a canvas of 60 × 40 px.
fn field(points: &Value) -> Value {
    json!({"format": "dapple", "version": 2, "size": [60, 40],
        "layers": [{"name": "field", "system": "points", "strokes": [], "points": points}]})
}

#[test]
fn check_refuses_a_small_document_that_would_be_all_marks_with_the_message_of_grow() {
    let folder = Folder::with(&covering());
    let said = |arguments: &str| {
        let output = folder.dapple(arguments).assert().code(1).get_output().clone();
        String::from_utf8(output.stderr).unwrap()
    };
    let message = said("check a.dapple");
    assert!(message.starts_with("error: a.dapple: layer 1 grew marks without any ground"), "{message}");
    assert_eq!(message, said("grow a.dapple -o a.png"));
    let output = folder.dapple("check a.dapple --json").assert().code(1).get_output().clone();
    let checked: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(checked["valid"], false);
    assert_eq!(checked["layers"].as_array().unwrap().len(), 1);
}

#[test]
fn check_refuses_a_document_that_does_not_fit_into_memory_with_file_and_layer() {
    let dots = json!([{"kind": "ellipse", "center": [5, 5], "radii": [0.01, 0.01], "angle": 0}]);
    let folder = Folder::with(&document([65_536, 65_536], &dots));
    let words = ["a.dapple: layer 1 cannot be grown on this machine", "cells", "GB are free"];
    folder.refuses("check a.dapple", 1, &words);
    folder.refuses("grow a.dapple -o a.png", 1, &words);
}

#[test]
fn a_field_of_one_value_is_refused_with_the_advice_for_its_labels() {
    for (labels, advice) in [
        (json!({"kind": "random", "dark": 0}), "\"dark\" nearer to 0.5"),
        (json!({"kind": "connected", "start": 1, "rings": 8}), "another \"start\""),
    ] {
        let folder = Folder::with(&field(&json!({"distance": 8, "labels": labels})));
        for arguments in ["check a.dapple", "grow a.dapple -o a.png"] {
            folder.refuses(arguments, 1, &["a.dapple: layer 1 is of one value everywhere", advice]);
        }
    }
}

#[test]
fn a_field_whose_values_hardly_differ_is_noted_with_the_advice_for_its_labels() {
    let labels = json!({"kind": "values"});
    let folder = Folder::with(&field(&json!({"distance": 10_000, "labels": labels})));
    let output = folder.dapple("grow a.dapple -o a.png --report r.json").assert().success();
    let said = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    for word in ["field: it is of one value everywhere", "smaller \"distance\"", "of one colour everywhere"] {
        assert!(said.contains(word), "{word} in {said}");
    }
    let report = folder.json("r.json");
    let notes = report["layers"][0]["notes"].as_array().unwrap();
    assert!(notes.iter().any(|note| note.as_str().unwrap().contains("one value everywhere")), "{notes:?}");
}

#[test]
fn a_picture_of_one_colour_is_noted_though_its_layer_has_a_pattern() {
    let ellipse = json!([{"kind": "ellipse", "center": [30, 30], "radii": [6, 5], "angle": 0}]);
    let mut document = document([60, 60], &ellipse);
    document["layers"][0]["colours"] = json!({"stops": [{"at": 0, "colour": "#aa5500"}]});
    let folder = Folder::with(&document);
    let output = folder.dapple("grow a.dapple -o a.png").assert().success().get_output().clone();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("the picture is of one colour everywhere"), "{said}");
    assert!(!said.contains("one value everywhere"), "{said}");
}
