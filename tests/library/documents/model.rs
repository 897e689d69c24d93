//! The model on which a document grows.

use super::*;
use dapple::document::{Axis, Body, BodyEllipse, BodyMark, BodySource, Pin};

/// The shortest document on this model.
fn on(model: Value) -> Value {
    with("/model", model)
}

fn with_mark(mark: &Value) -> Value {
    let mut document = on(json!({"file": "sphere"}));
    document["layers"][0]["strokes"] = json!([mark]);
    document
}

#[test]
fn a_model_and_marks_on_it_are_read_as_they_were_written() {
    let digest = "00112233445566778899aabbccddeeff".repeat(2);
    let mut document = on(json!({
        "file": "models/horse.obj", "sha256": digest, "px": 700.5, "up": "z", "along": "-y",
        "pins": [{"region": [1, 0], "at": [0.5, 1, -2], "toward": [1, 0, 0]}, {"at": [1, 2, 3]}],
        "strokes": [{"points": [[0, 1, 0], [0, 2, 0]]}], "only": ["body"]
    }));
    document["regions"] = json!([2, 1]);
    document["layers"][0]["strokes"] = json!([
        {"kind": "ellipse", "at": [0, 1, 0], "normal": [0, 0, 2], "radii": [12, 6], "angle": 30},
        {"kind": "ellipse", "center": [64, 64], "radii": [12, 6]},
        {"kind": "line", "points": [[0, 1, 0], [0, 2, 0]], "width": 4}
    ]);
    let read = accepted(&document);
    let body = read.model.as_ref().expect("a model");
    assert_eq!(
        (body.source.name(), body.px, body.up, body.along),
        ("models/horse.obj", 700.5, Axis::Z, Axis::MinusY)
    );
    assert!(
        matches!(&body.source, BodySource::File { sha256: Some(digest), .. } if digest[1] == 0x11 && digest[31] == 0xff)
    );
    assert_eq!(body.pins[0], Pin { region: [1, 0], at: [0.5, 1.0, -2.0], toward: Some([1.0, 0.0, 0.0]) });
    assert_eq!(body.pins[1], Pin { region: [0, 0], at: [1.0, 2.0, 3.0], toward: None });
    let layer = &read.layers[0];
    let spot =
        BodyEllipse { at: [0.0, 1.0, 0.0], normal: Some([0.0, 0.0, 2.0]), radii: [12.0, 6.0], angle: 30.0 };
    let stripe = BodyMark::Path { points: vec![[0.0, 1.0, 0.0], [0.0, 2.0, 0.0]], width: 4.0 };
    assert_eq!((layer.strokes.len(), &layer.on_model), (1, &vec![BodyMark::Ellipse(spot), stripe]));
    assert_eq!(Document::parse(&read.to_json(), "again").unwrap(), read);
}

#[test]
fn a_layer_may_have_marks_only_on_the_model() {
    let document = accepted(&with_mark(&json!({"kind": "ellipse", "at": [0, 1, 0], "radii": [12, 6]})));
    assert!(document.layers[0].strokes.is_empty() && !document.layers[0].is_blank());
}

#[test]
fn a_built_in_model_is_known_by_its_name_and_has_no_digest() {
    let digest = "0".repeat(64);
    let document = accepted(&on(json!({"file": "torus", "sha256": digest})));
    assert_eq!(document.model, Some(Body::new(BodySource::BuiltIn("torus"))));
}

#[test]
fn impossible_values_of_a_model_are_refused_with_their_place() {
    let digest = "the SHA-256 of the file, 64 hexadecimal digits; leave it out if you do not know it";
    refused(&on(json!({"file": "a.obj", "sha256": "12xz"})), "model.sha256", "\"12xz\"", digest);
    refused(&on(json!({"file": "egg", "px": 0})), "model.px", "0", "a number from 1 to 65536 px");
    let pin = |pin: Value| on(json!({"file": "egg", "pins": [pin]}));
    let allowed = "[column, row] of a region, from [0, 0] to [0, 0]";
    refused(&pin(json!({"region": [1], "at": [0, 0, 0]})), "model.pins[0].region", "[1]", allowed);
    let one = "a whole number from 0 to 0";
    refused(&pin(json!({"region": [1, 0], "at": [0, 0, 0]})), "model.pins[0].region[0]", "1", one);
    let nowhere = pin(json!({"at": [0, 0, 0], "toward": [0, 0, 0]}));
    refused(&nowhere, "model.pins[0].toward", "[0,0,0]", "a direction [x, y, z] that is not zero");
    let point = on(json!({"file": "egg", "strokes": [{"points": [[1, 1, 1], [1, 1, 1]]}]}));
    refused(
        &point,
        "model.strokes[0].points",
        "points that are all the same",
        "points at two places or more",
    );
    let wide = json!({"kind": "ellipse", "at": [0, 1, 0], "radii": [12, 6000]});
    refused(&with_mark(&wide), "layers[0].strokes[0].radii[1]", "6000", "a number from 0.01 to 900 px");
}

#[test]
fn a_mark_in_space_needs_a_model() {
    let mark = with_stroke(&json!({"kind": "ellipse", "at": [0, 1, 0], "radii": [12, 6]}));
    let message = error_of_text(&mark.to_string());
    assert!(message.contains("layers[0].strokes[0]") && message.contains("\"at\""), "{message}");
}
