//! Flat maps of heights: marks that have the drawn attributes on the terrain.

use dapple_engine::grid::Edges;
use image::{ImageBuffer, Luma};
use serde_json::{Value, json};

use crate::grow::folder::{Folder, document};

/// Writes a picture of a slope of 1 along x: 240 px high at the right edge of a canvas of 240 px.
fn slope(folder: &Folder) {
    let heights =
        ImageBuffer::from_fn(240, 20, |x, _| Luma([(65_535.0 * (f64::from(x) + 0.5) / 240.0) as u16]));
    heights.save(folder.path("slope.png")).unwrap();
}

/// A document with round spots of 141 px², 28 px apart, on heights.
fn spots(model: &Value) -> Value {
    let at = |row: u32, column: u32| {
        let x = 60.0 + 28.0 * (f64::from(column) + 0.5 * f64::from(row % 2));
        json!({"kind": "ellipse", "center": [x, 60.0 + 24.25 * f64::from(row)], "radii": [6.7, 6.7]})
    };
    let strokes: Vec<Value> = (0..4).flat_map(|row| (0..4).map(move |column| at(row, column))).collect();
    let mut document = document([240, 240], &json!(strokes));
    document["version"] = json!(2);
    document["model"] = model.clone();
    document["regions"] = json!([1, 1]);
    document
}

fn on_slope() -> Folder {
    let folder = Folder::with(&spots(&json!({"height": "slope.png", "scale": 240})));
    slope(&folder);
    folder
}

#[test]
fn on_a_slope_the_map_has_spots_that_are_narrow_along_it_and_round_on_the_surface() {
    let folder = on_slope();
    folder.grow("--pattern p.png --report r.json -q");
    let measured = folder.measured("p.png");
    let got = |key: &str| measured[key].as_f64().unwrap_or_else(|| panic!("{key} of {measured}"));
    let root = 2.0_f64.sqrt();
    assert!((got("area") * root / 141.0 - 1.0).abs() < 0.02, "{measured}");
    assert!((got("aspect") * root - 1.0).abs() < 0.03, "{measured}");
    assert!((got("angle") - 90.0).abs() < 2.0, "{measured}");
    let region = folder.json("r.json")["layers"][0]["regions"][0].clone();
    let of = |key: &str, value: &str| region[key][value].as_f64().unwrap_or_else(|| panic!("{region}"));
    assert!((of("asked", "area") - 141.0).abs() < 0.1 && (of("asked", "aspect") - 1.0).abs() < 1e-6);
    assert!((of("got", "area") / 141.0 - 1.0).abs() < 0.01 && of("got", "aspect") > 0.97, "{region}");
    assert!(of("error", "spacing").abs() < 0.02, "{region}");
}

#[test]
fn a_picture_of_a_flat_map_grows_again_beside_its_heights() {
    let folder = on_slope();
    folder.grow("-q");
    folder.dapple("grow a.png -o b.png --threads 1 -q").assert().success();
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
}

#[test]
fn stripes_across_a_slope_are_narrower_on_the_map() {
    let width = |model: Option<Value>| {
        let line = |x: i32| json!({"kind": "line", "from": [x, 40], "to": [x, 200], "width": 8});
        let mut document = document([240, 240], &json!([line(100), line(116)]));
        if let Some(model) = model {
            document["model"] = model;
            document["version"] = json!(2);
        }
        document["regions"] = json!([1, 1]);
        let folder = Folder::with(&document);
        slope(&folder);
        folder.grow("--pattern p.png -q");
        // The measurement takes the narrower phase as the stripes; the share of ink shows which phase that is.
        let ink = folder.pattern("p.png", Edges::Closed).values;
        let share = ink.iter().map(|value| f64::from(*value)).sum::<f64>() / ink.len() as f64;
        share * folder.measured("p.png")["wavelength"].as_f64().expect("stripes")
    };
    let [flat, on_slope] = [width(None), width(Some(json!({"height": "slope.png", "scale": 240})))];
    assert!((flat / on_slope / 2.0_f64.sqrt() - 1.0).abs() < 0.03, "{flat} {on_slope}");
}

#[test]
fn missing_heights_and_layers_that_cannot_grow_on_them_are_refused_by_check_and_grow() {
    let folder = Folder::with(&spots(&json!({"height": "none.png", "scale": 240})));
    for command in ["check a.dapple", "grow a.dapple -o a.png -q"] {
        folder.refuses(command, 1, &["a.dapple", "model.height", "none.png", "beside the document"]);
    }
    slope(&folder);
    let mut weave = spots(&json!({"height": "slope.png", "scale": 240}));
    weave["layers"][0]["system"] = json!("patches");
    folder.write("a.dapple", &weave.to_string());
    for command in ["check a.dapple", "grow a.dapple -o a.png -q"] {
        folder.refuses(command, 1, &["layers[0].system", "patches", "heights", "spots or stripes"]);
    }
    folder.write("a.dapple", &spots(&json!({"surface": "torus"})).to_string());
    folder.refuses("check a.dapple", 1, &["model.surface", "torus", "240 × 240", "wider than high"]);
}
