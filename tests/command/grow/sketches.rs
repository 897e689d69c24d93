//! Strokes like those drawn by hand.

use crate::grow::folder::{Folder, document};
use dapple::document::Edges;
use dapple_engine::marks::turn;
use dapple_engine::measure;
use serde_json::{Value, json};

/// Points of an ellipse like one drawn by hand: slightly wrong, and not quite closed.
fn outline([x, y]: [f64; 2], radii: [f64; 2], degrees: f64) -> Value {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let points: Vec<[f64; 2]> = (0..28)
        .map(|k| {
            let turn = f64::from(k) * 6.1 / 28.0;
            let off = 1.0 + 0.04 * (3.0 * turn).sin();
            let [u, v] = [radii[0] * off * turn.cos(), radii[1] * off * turn.sin()];
            [x + u * cos - v * sin, y + u * sin + v * cos]
        })
        .collect();
    json!({"kind": "freehand", "points": points, "width": 2})
}

#[test]
fn spots_drawn_by_hand_grow() {
    let strokes = json!([
        outline([50.0, 50.0], [8.0, 4.5], 40.0),
        outline([80.0, 46.0], [8.0, 4.5], 45.0),
        outline([66.0, 75.0], [8.0, 4.5], 35.0),
    ]);
    let folder = Folder::with(&document([160, 160], &strokes));
    folder.grow("--pattern p.png --report r.json");
    let layer = folder.json("r.json")["layers"][0].clone();
    let asked = |key: &str| layer["regions"][0]["asked"][key].as_f64().unwrap();
    let drawn = 8.0 * 4.5 * std::f64::consts::PI;
    assert!((asked("area") / drawn - 1.0).abs() < 0.05 && turn(asked("angle"), 40.0).abs() < 2.0, "{layer}");
    let spots = measure::spots(&folder.pattern("p.png", Edges::Closed), 0.5);
    let areas: Vec<f64> = spots.iter().filter(|spot| spot.whole).map(|spot| spot.ellipse.area()).collect();
    let mean = areas.iter().sum::<f64>() / areas.len() as f64;
    assert!(areas.len() > 8 && (mean / drawn - 1.0).abs() < 0.06, "{} of {mean}", areas.len());
}

#[test]
fn stripes_drawn_by_hand_grow() {
    let points: Vec<[f64; 2]> =
        (0..20).map(|k| f64::from(k) * 4.0).map(|s| [20.0 + s, 100.0 - 0.8 * s + (0.3 * s).sin()]).collect();
    let strokes = json!([{"kind": "freehand", "points": points, "width": 5}]);
    let folder = Folder::with(&document([140, 140], &strokes));
    folder.grow("--pattern p.png");
    let got = measure::stripes(&folder.pattern("p.png", Edges::Closed), 0.5).unwrap();
    let drawn = (-0.8_f64).atan2(1.0).to_degrees();
    assert!((got.width / 5.0 - 1.0).abs() < 0.03 && turn(got.angle, drawn).abs() < 5.0, "{got:?}");
}
