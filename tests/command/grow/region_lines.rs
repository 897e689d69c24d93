//! Lines side by side in documents with regions: stripes grow as far apart as they are drawn.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// The grown period of five level lines 10 px wide and 33 px apart, with one region.
fn grown_period(system: &str) -> f64 {
    let line = |k: i32| {
        let y = 120 + 33 * k;
        json!({"kind": "line", "from": [30, y], "to": [210, y], "width": 10})
    };
    let strokes: Vec<Value> = (-2..=2).map(line).collect();
    let layers = json!([{"system": system, "strokes": strokes}]);
    let folder = Folder::with(
        &json!({"format": "dapple", "version": 2, "size": [240, 240], "regions": [1, 1], "layers": layers}),
    );
    folder.grow("--report r.json");
    let layer = &folder.json("r.json")["layers"][0];
    let of_one = if layer["threads"].is_array() { &layer["threads"][0] } else { &layer["regions"][0] };
    let asked = of_one["asked"]["wavelength"].as_f64().unwrap_or_else(|| panic!("{system}: {layer}"));
    assert!((asked / 33.0 - 1.0).abs() < 0.01, "{system}: {asked} px asked");
    of_one["got"]["wavelength"].as_f64().unwrap_or_else(|| panic!("{system}: {layer}"))
}

#[test]
fn five_lines_33_px_apart_grow_33_px_apart_with_one_region() {
    for system in ["auto", "pair-stripes"] {
        let got = grown_period(system);
        assert!((got / 33.0 - 1.0).abs() < 0.06, "{system}: {got} px");
    }
}
