//! The `points` of a layer: the settings of a field of points.

use super::*;
use dapple::point_fields::{Interpolation, Labels, Points, Progression, Towards};
use dapple::tone::ToneImage;

fn field(points: &Value) -> Value {
    json!({"format": "dapple", "version": 2, "size": [512, 256],
        "layers": [{"system": "points", "strokes": [], "points": points}]})
}

fn image() -> ToneImage {
    ToneImage::new([3, 2], vec![0, 50, 100, 150, 200, 250]).unwrap()
}

#[test]
fn points_are_written_as_they_were_read() {
    let png = json!({"png": image().base64()});
    let all = json!({"distance": [40.5, 8], "progression": png, "labels": {"kind": "image", "image": png, "passes": 4},
        "octaves": 3, "fold": true, "axis": 1.5, "shift": 0.25, "towards": 30, "share": 0.4});
    let document = accepted(&field(&all));
    let expected = Points {
        distance: Some([40.5, 8.0]),
        progression: Progression::Image(image()),
        labels: Labels::Image { image: image(), passes: 4 },
        octaves: 3,
        fold: true,
        interpolation: Interpolation::Smooth,
        axis: 1.5,
        shift: 0.25,
        towards: Towards::Angle(30.0),
        share: Some(0.4),
    };
    assert_eq!(document.layers[0].points.as_ref(), Some(&expected));
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    assert_eq!(written["layers"][0]["points"], all);
    let few =
        json!({"labels": {"kind": "values", "group": 3}, "interpolation": "nearest", "towards": "outward"});
    let written: Value = serde_json::from_str(&accepted(&field(&few)).to_json()).unwrap();
    assert_eq!(written["layers"][0]["points"], few);
}

#[test]
fn a_field_of_points_needs_neither_strokes_nor_points() {
    let mut bare = field(&json!({}));
    bare["layers"][0].as_object_mut().unwrap().remove("points");
    let document = accepted(&bare);
    assert!(document.layers[0].points.is_none() && !document.layers[0].is_blank());
    assert_eq!(document.layers[0].point_field(), Some(Points::default()));
}

#[test]
fn wrong_points_are_refused_with_what_is_allowed() {
    let refuses = |points: Value, place: &str, found: &str, allowed: &str| {
        refused(&field(&points), &format!("layers[0].points.{place}"), found, allowed);
    };
    refuses(json!({"octaves": 9}), "octaves", "9", "a whole number from 1 to 8");
    refuses(
        json!({"distance": [5, 1]}),
        "distance",
        "[5,1]",
        "a number from 2 to 100000 px, or a list of two such numbers",
    );
    let kinds = "values, random, image, space-giraffe, breadth-first, depth-first, round-robin, connected";
    refuses(json!({"labels": {"kind": "bfs"}}), "labels.kind", "\"bfs\"", kinds);
    refuses(
        json!({"labels": {"kind": "random", "size": 3}}),
        "labels",
        "the unknown key \"size\"",
        "kind, dark",
    );
    let rays = "a list of two whole numbers from 3 to 60, the second no less";
    for wrong in [json!([20, 10]), json!([2, 10]), json!([3, 61])] {
        let labels = json!({"kind": "space-giraffe", "rays": wrong});
        refuses(json!({"labels": labels}), "labels.rays", &wrong.to_string(), rays);
    }
    refuses(
        json!({"share": 0.4, "interpolation": "nearest"}),
        "share",
        "0.4",
        "no share: cells of dark and light points have no level that could be moved; leave it out, or set \"interpolation\" to \"smooth\"",
    );
    accepted(&field(&json!({"share": 0.4, "interpolation": "nearest", "labels": {"kind": "values"}})));
    let png =
        "a gray PNG of 8 bits and at most 1024 px a side in base64 (docs/points.md says how to make one)";
    let message = error_of_text(&field(&json!({"progression": {"png": "?"}})).to_string());
    assert!(message.contains("layers[0].points.progression.png") && message.ends_with(png), "{message}");
}

#[test]
fn points_are_allowed_only_with_their_system_and_with_ellipses() {
    let mut other = with("/layers/0/points", json!({}));
    refused(
        &other,
        "layers[0].points",
        "points",
        "no points. Only fields of points have this: set \"system\" to \"points\"",
    );
    other["layers"][0]["system"] = json!("points");
    accepted(&other);
    let line = json!({"kind": "line", "from": [10, 10], "to": [90, 60], "width": 8});
    other["layers"][0]["strokes"] = json!([line]);
    let message = error_of_text(&other.to_string());
    assert!(message.contains("layers[0].system: found \"points\""), "{message}");
    assert!(message.ends_with("This system grows spots; this layer holds lines"), "{message}");
}
