//! Version 1 → 2: regions became optional, the duty became that of the drawn lines, and open strokes may bend.
//!
//! What version 1 took as its default is written out, so that the document keeps its meaning.

use serde_json::{Map, Value, json};

use crate::document::finish::HAIR;
use crate::document::{LayerOptions, Stroke};
use crate::marks::Mark;
use crate::sketch::recognise_straight;

/// The document of version 2 that means what `document` meant in version 1.
pub(super) fn migrate(mut document: Value) -> Value {
    let Some(root) = document.as_object_mut() else { return document };
    let regions = root.entry("regions").or_insert_with(|| json!([1, 1]));
    let is_one_region = *regions == json!([1, 1]);
    for layer in root.get_mut("layers").and_then(Value::as_array_mut).into_iter().flatten() {
        // Layers of hair have no options.
        if let Some(layer) = layer.as_object_mut()
            && layer.get("system").is_none_or(|system| system != HAIR)
        {
            migrate_layer(layer, is_one_region);
        }
    }
    document
}

fn migrate_layer(layer: &mut Map<String, Value>, is_one_region: bool) {
    let is_between = layer.get("after").is_none_or(|after| after == "between");
    let mut holds_lines = false;
    for stroke in layer.get_mut("strokes").and_then(Value::as_array_mut).into_iter().flatten() {
        if let Some(line) = straight(stroke) {
            *stroke = line;
        }
        holds_lines |= stroke["kind"] == "line";
    }
    let options = layer.entry("options").or_insert_with(|| json!({}));
    let Some(options) = options.as_object_mut() else { return };
    if is_between {
        let is_regular = options.get("irregular").is_none_or(|irregular| irregular.as_f64() == Some(0.0));
        options.entry("keep").or_insert_with(|| json!(is_one_region && is_regular));
    }
    if is_between && holds_lines {
        options.entry("duty").or_insert_with(|| json!(LayerOptions::DUTY));
    }
}

/// The line that an open freehand stroke was in version 1; `None` for any other stroke, and of one that is not allowed.
fn straight(stroke: &Value) -> Option<Value> {
    if stroke["kind"] != "freehand" {
        return None;
    }
    let points = stroke["points"].as_array()?;
    let points: Vec<[f64; 2]> = points.iter().map(point).collect::<Option<_>>()?;
    let width = stroke.get("width").map_or(Some(Stroke::WIDTH), Value::as_f64)?;
    let Some(Mark::Line(line)) = recognise_straight(&points, width) else { return None };
    let mut migrated = json!({"kind": "line", "from": line.from, "to": line.to});
    if let Some(width) = stroke.get("width") {
        migrated["width"] = width.clone();
    }
    Some(migrated)
}

fn point(point: &Value) -> Option<[f64; 2]> {
    let [x, y] = &point.as_array()?[..] else { return None };
    Some([x.as_f64()?, y.as_f64()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_version_1_took_as_default_is_written_out() {
        let old = json!({"layers": [
            {"strokes": [{"kind": "line", "from": [1, 1], "to": [9, 9]}]},
            {"strokes": [{"kind": "ellipse"}], "options": {"irregular": 0.5}},
            {"strokes": [{"kind": "line"}], "after": "around", "options": {"broken": 0.3}},
        ]});
        let new = migrate(old);
        assert_eq!(new["regions"], json!([1, 1]));
        let options = [0, 1, 2].map(|layer| new["layers"][layer]["options"].clone());
        let wanted = [
            json!({"keep": true, "duty": 0.5}),
            json!({"irregular": 0.5, "keep": false}),
            json!({"broken": 0.3}),
        ];
        assert_eq!(options, wanted);
    }

    #[test]
    fn what_was_said_stays_as_it_was_said() {
        let said = json!({"regions": [3, 2], "layers": [
            {"strokes": [{"kind": "line"}], "options": {"duty": 0.3, "keep": true}},
            {"strokes": 5, "options": {"duty": 0.4}},
            {"strokes": [], "options": 7},
            "no layer",
        ]});
        let migrated = migrate(said.clone());
        assert_eq!(migrated["regions"], said["regions"]);
        assert_eq!(migrated["layers"][0], said["layers"][0]);
        assert_eq!(migrated["layers"][1]["options"], json!({"duty": 0.4, "keep": false}));
        assert_eq!(migrate(json!([1])), json!([1]));
    }

    #[test]
    fn an_open_stroke_becomes_the_line_that_it_was_and_a_closed_one_stays() {
        let bent = json!({"kind": "freehand", "points": [[10, 10], [40, 30], [70, 10]], "width": 4});
        let square = json!({"kind": "freehand", "points": [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]});
        let new = migrate(json!({"layers": [{"strokes": [bent]}, {"strokes": [square]}]}));
        let line = &new["layers"][0]["strokes"][0];
        assert_eq!([&line["kind"], &line["width"]], [&json!("line"), &json!(4)]);
        assert!(line["from"][1] == line["to"][1], "{line}");
        assert_eq!(new["layers"][0]["options"]["duty"], 0.5);
        assert_eq!(new["layers"][1]["strokes"][0], square);
        assert!(new["layers"][1]["options"].get("duty").is_none());
    }
}
