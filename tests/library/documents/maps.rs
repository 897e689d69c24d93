//! The `maps` of a layer: pictures and noise by which its attributes vary.

use super::*;
use dapple::editor::session::Session;
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::ToneImage;

fn image() -> ToneImage {
    ToneImage::new([3, 2], vec![0, 50, 100, 150, 200, 250]).unwrap()
}

fn varied(maps: &Value) -> Value {
    let mut document = least();
    document["layers"][0]["maps"] = maps.clone();
    document
}

fn picture(range: [f64; 2]) -> Value {
    json!({"image": {"png": image().base64()}, "range": range})
}

fn noise(size: i32, range: [f64; 2]) -> Value {
    json!({"noise": {"size": size, "octaves": 3, "range": range}})
}

#[test]
fn maps_are_written_as_they_were_read() {
    let mut turned = picture([-30.5, 60.0]);
    turned["factor"] = json!(true);
    let maps = json!({"area": picture([80.5, 300.25]), "spacing": noise(40, [0.5, 1.5]), "direction": turned,
        "aspect": noise(7, [0.5, 1.5]), "colour": noise(90, [-0.5, 0.25])});
    let document = accepted(&varied(&maps));
    let area = LayerMap { source: MapSource::Image { image: image(), factor: false }, range: [80.5, 300.25] };
    assert_eq!(document.layers[0].maps.get(MapKey::Area), Some(&area));
    assert_eq!(document.layers[0].maps.iter().count(), 5);
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    assert_eq!(accepted(&written), document);
    assert_eq!(written["layers"][0]["maps"]["spacing"], maps["spacing"]);
    assert_eq!(written["layers"][0]["maps"]["direction"]["factor"], json!(true));
    let none: Value = serde_json::from_str(&accepted(&varied(&json!({}))).to_json()).unwrap();
    assert!(none["layers"][0].get("maps").is_none());
}

#[test]
fn a_tone_and_a_map_of_one_picture_keep_every_px() {
    let mut document = varied(&json!({"colour": picture([-0.5, 0.25])}));
    document["layers"][0]["tone"] = json!({"image": {"png": image().base64()}});
    let document = accepted(&document);
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    let layer = accepted(&written).layers[0].clone();
    assert_eq!(layer.tone.as_ref().map(|tone| &tone.image), Some(&image()));
    let map = layer.maps.get(MapKey::Colour).expect("a map");
    assert!(matches!(&map.source, MapSource::Image { image: found, .. } if *found == image()));
}

#[test]
fn wrong_maps_are_refused_with_the_remedy() {
    let refuses = |maps: Value, place: &str, found: &str, allowed: &str| {
        refused(&varied(&maps), &format!("layers[0].maps.{place}"), found, allowed);
    };
    let png =
        "a gray PNG of 8 bits and at most 1024 px a side in base64 (dapple grow --map embeds any picture so)";
    let text = json!({"area": {"image": {"png": "?"}, "range": [80, 300]}});
    let message = error_of_text(&varied(&text).to_string());
    assert!(message.contains("layers[0].maps.area.image.png") && message.ends_with(png), "{message}");
    refuses(
        json!({"area": picture([0.0, 300.0])}),
        "area.range[0]",
        "0.0",
        "a number from 1 to 100000000 px²",
    );
    refuses(
        json!({"area": noise(40, [0.5, 300.0])}),
        "area.noise.range[1]",
        "300.0",
        "a number from 0.1 to 10",
    );
    refuses(json!({"colour": picture([0.0, 2.0])}), "colour.range[1]", "2.0", "a number from -0.5 to 0.5");
    refuses(json!({"area": noise(1, [0.5, 3.0])}), "area.noise.size", "1", "a number from 2 to 100000 px");
    let either = "an object {\"image\": …, \"range\": […]} or {\"noise\": …}, not both";
    refuses(json!({"area": {}}), "area", "no key \"image\"", either);
    let mut both = noise(40, [0.5, 1.0]);
    both["range"] = json!([1, 2]);
    refuses(json!({"area": both}), "area", "the unknown key \"range\"", either);
    let keys = "area, spacing, direction, aspect, duty, colour, growth (did you mean colour?)";
    refused(&varied(&json!({"color": {}})), "layers[0].maps", "the unknown key \"color\"", keys);
}

#[test]
fn maps_that_the_layer_cannot_follow_are_refused_with_the_reason() {
    let refuses = |document: &Value, place: &str, why: &str| {
        let message = error_of_text(&document.to_string());
        assert!(
            message.contains(place)
                && message.contains("found a map; allowed: no map.")
                && message.contains(why),
            "{message}"
        );
    };
    refuses(
        &varied(&json!({"duty": noise(40, [0.5, 1.0])})),
        "layers[0].maps.duty",
        "Only stripes have a duty",
    );
    let mut cells = varied(&json!({"area": noise(40, [0.5, 1.0])}));
    cells["layers"][0]["system"] = json!("cells");
    accepted(&cells);
    cells["layers"][0]["maps"] = json!({"spacing": noise(40, [0.5, 1.0])});
    refuses(&cells, "layers[0].maps.spacing", "The distance of cells follows from their area");
    let line = json!({"kind": "line", "from": [10, 10], "to": [50, 10], "width": 5});
    for (system, key, reason) in [
        ("cracks", "direction", "Cracks run in all directions"),
        ("stucco", "direction", "Blotches of stucco have no direction"),
        ("stucco", "duty", "`options.decay`"),
    ] {
        let mut lines = varied(&json!({key: noise(40, [0.5, 1.0])}));
        lines["layers"][0]["system"] = json!(system);
        lines["layers"][0]["strokes"] = json!([line]);
        refuses(&lines, &format!("layers[0].maps.{key}"), reason);
        lines["layers"][0]["maps"] = json!({"spacing": noise(40, [0.5, 1.0])});
        accepted(&lines);
    }
    let mut points = varied(&json!({"direction": noise(40, [0.0, 90.0])}));
    points["layers"][0]["system"] = json!("points");
    refuses(&points, "layers[0].maps.direction", "field of points");
    points["layers"][0]["maps"] = json!({"area": noise(40, [0.5, 1.0])});
    accepted(&points);
    points["layers"][0]["points"] = json!({"labels": {"kind": "breadth-first"}});
    refuses(&points, "layers[0].maps.area", "Only labels that are random or by a picture have a probability");
    let mut turing = varied(&json!({"spacing": noise(40, [0.5, 1.0])}));
    turing["layers"][0]["system"] = json!("turing-spots");
    refuses(&turing, "layers[0].maps.spacing", "follows from their area, which can have a map");
    let mut painted = varied(&json!({"colour": noise(40, [-0.5, 0.5])}));
    painted["layers"][0]["system"] = json!("cells");
    accepted(&painted);
}

#[test]
fn a_map_moves_drawn_marks_unless_they_are_to_be_kept() {
    let maps = json!({"area": noise(40, [0.5, 1.0])});
    let mut document = varied(&maps);
    assert!(accepted(&least()).keeps_marks(0) && !accepted(&document).keeps_marks(0));
    document["layers"][0]["options"] = json!({"keep": true});
    assert!(accepted(&document).keeps_marks(0));
    assert!(accepted(&varied(&json!({"colour": noise(40, [-0.5, 0.5])}))).keeps_marks(0));
}

#[test]
fn the_window_saves_maps_and_copies_marks_without_them() {
    let document =
        accepted(&varied(&json!({"area": picture([80.0, 300.0]), "colour": noise(90, [-0.5, 0.25])})));
    let mut session = Session::open(document.clone(), None);
    session.select_all();
    assert_eq!(session.document().layers[0].maps, document.layers[0].maps);
    let copied = Document::parse(&session.copy().expect("marks"), "a copy").unwrap();
    assert!(copied.layers[0].maps.is_empty());
}
