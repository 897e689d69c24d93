//! Stripes that cover more than half of their period: the simulation grows the gaps between them, as lines.

use crate::grow::folder::Folder;
use dapple_engine::grid::{Edges, Field};
use serde_json::{Value, json};

/// A document with free marks.
fn document(layers: &Value) -> Value {
    json!({"format": "dapple", "version": 2, "size": [300, 300], "layers": layers})
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Value {
    json!({"kind": "line", "from": from, "to": to, "width": width})
}

/// The first layer in the report of `document`, and its pattern; `more` are further arguments.
#[track_caller]
fn grown(document: &Value, more: &str) -> (Value, Field) {
    let folder = Folder::with(document);
    folder.grow(&format!("--pattern p.png --report r.json {more}"));
    let edges = if document["edges"] == "wrap" { Edges::Wrap } else { Edges::Closed };
    (folder.json("r.json")["layers"][0].clone(), folder.pattern("p.png", edges))
}

/// Asserts that each drawn stroke lies in a stripe along its whole length.
#[track_caller]
fn all_there(layer: &Value) {
    let drawn = layer["drawn"].as_array().unwrap();
    assert!(drawn.iter().all(|mark| mark["there"] == true && mark["off"] == 0.0), "{drawn:?}");
}

/// Asserts that the width of each region is within 0.5 % of the asked one, and its period within the share `period`.
#[track_caller]
fn met(layer: &Value, period: f64) {
    assert_eq!((&layer["system"], &layer["inverted"]), (&json!("meinhardt-lines"), &json!(true)));
    for region in layer["regions"].as_array().unwrap() {
        let error = |name: &str| region["error"][name].as_f64().unwrap();
        assert!(error("width").abs() < 0.005 && error("wavelength").abs() < period, "{region}");
    }
}

/// The rows at which the stripes of column `x` begin and end, among the rows `rows`, px.
fn edges(pattern: &Field, x: usize, rows: std::ops::Range<usize>) -> Vec<f64> {
    let value = |y: usize| f64::from(pattern.values[y * pattern.width + x]) - 0.5;
    let crossing = |y: usize| {
        let (here, next) = (value(y), value(y + 1));
        ((here < 0.0) != (next < 0.0)).then(|| y as f64 + 0.5 + here / (here - next))
    };
    rows.filter_map(crossing).collect()
}

#[test]
fn parallel_lines_16_wide_and_24_apart_grow_stripes_16_wide_and_24_apart_that_hold_every_stroke() {
    let rows = [108.0, 132.0, 156.0, 180.0];
    let strokes: Vec<Value> = rows.iter().map(|y| line([60.0, *y], [240.0, *y], 16.0)).collect();
    let (layer, pattern) = grown(&document(&json!([{"strokes": strokes}])), "");
    met(&layer, 0.04);
    all_there(&layer);
    for x in [90, 150, 210] {
        let edges = edges(&pattern, x, 96..192);
        assert_eq!(edges.len(), 8, "{edges:?}");
        for (stripe, drawn) in edges.chunks_exact(2).zip(rows) {
            let (width, middle) = (stripe[1] - stripe[0], 0.5 * (stripe[0] + stripe[1]));
            assert!((width / 16.0 - 1.0).abs() < 0.1, "{width} px wide at {x}");
            assert!((middle - drawn).abs() < 1.5, "at {middle} instead of {drawn}");
        }
    }
}

#[test]
fn a_duty_of_seven_tenths_or_four_fifths_grows_stripes_with_thin_gaps_on_both_kinds_of_edges() {
    for (duty, edges) in [(0.7, "wrap"), (0.8, "closed"), (0.55, "closed")] {
        let strokes = [line([60.0, 80.0], [180.0, 130.0], 14.0)];
        let mut document = document(&json!([{"strokes": strokes, "options": {"duty": duty}}]));
        document["edges"] = json!(edges);
        let (layer, pattern) = grown(&document, "");
        met(&layer, 0.06);
        all_there(&layer);
        let covered = pattern.values.iter().filter(|value| **value >= 0.5).count() as f64;
        let share = covered / pattern.values.len() as f64;
        assert!((share - duty).abs() < 0.03, "{duty} {edges}: {share} is covered");
    }
}

#[test]
fn concentric_arcs_side_by_side_grow_wide_stripes_along_each_of_them() {
    let arc = |radius: f64| {
        let point = |k: i32| {
            let (s, c) = f64::from(200 + 7 * k).to_radians().sin_cos();
            [150.0 + radius * c, 190.0 + radius * s]
        };
        json!({"kind": "path", "points": (0..=20).map(point).collect::<Vec<_>>(), "width": 13})
    };
    let arcs: Vec<Value> = [80.0, 100.0, 120.0, 140.0].map(arc).to_vec();
    let (layer, _) = grown(&document(&json!([{"strokes": arcs}])), "");
    assert_eq!(layer["inverted"], true);
    all_there(&layer);
    assert!(layer["regions"][0]["error"]["angle_rms"].as_f64().unwrap() < 6.0, "{layer}");
}

#[test]
fn each_region_has_its_own_wide_stripes() {
    let strokes = [line([30.0, 100.0], [120.0, 100.0], 14.0), line([190.0, 60.0], [270.0, 130.0], 9.0)];
    let mut document = document(&json!([{"strokes": strokes, "options": {"duty": 0.65}}]));
    document["regions"] = json!([2, 1]);
    let (layer, _) = grown(&document, "");
    assert_eq!(layer["regions"].as_array().unwrap().len(), 2);
    met(&layer, 0.08);
}

#[test]
fn wide_stripes_leave_ground_round_the_marks_beneath_and_keep_their_width_between_them() {
    let spot =
        |center: [f64; 2]| json!({"kind": "ellipse", "center": center, "radii": [18, 12], "angle": 30});
    let spots = [[70.0, 80.0], [150.0, 130.0], [230.0, 80.0]].map(spot);
    let lines = [230.0, 245.0, 260.0].map(|y| line([30.0, y], [270.0, y], 10.0));
    let folder = Folder::with(&document(&json!([{"strokes": spots}, {"strokes": lines}])));
    folder.grow("--pattern beneath.png --layer 1");
    folder.grow("--pattern above.png --layer 2 --report r.json");
    let report = folder.json("r.json");
    let above = &report["layers"][1];
    assert_eq!((&report["layers"][0]["inverted"], &above["inverted"]), (&json!(false), &json!(true)));
    let width = &above["regions"][0]["error"]["width"];
    assert!(width.as_f64().unwrap().abs() < 0.02, "{width}");
    let [beneath, above] = ["beneath.png", "above.png"].map(|name| folder.pattern(name, Edges::Closed));
    // Two px from a mark there is no stripe yet, because the gaps between stripes are 5 px wide.
    let mark = |x: usize, y: usize| beneath.values[y * 300 + x] >= 0.5;
    let near = |x: usize, y: usize| {
        [[2, 0], [0, 2], [4, 2], [2, 4]].iter().any(|[dx, dy]| mark(x + dx - 2, y + dy - 2))
    };
    let cells = (2..298).flat_map(|y| (2..298).map(move |x| (x, y)));
    let close = cells.clone().filter(|(x, y)| mark(*x, *y) || near(*x, *y));
    let inked = close.filter(|(x, y)| above.values[y * 300 + x] >= 0.5).count();
    assert_eq!(inked, 0);
    assert!(cells.filter(|(x, y)| above.values[y * 300 + x] >= 0.5).count() > 40_000);
}

#[test]
fn a_line_that_asks_for_thin_stripes_among_wide_ones_is_named_before_it_grows() {
    let wide = [150.0, 172.0, 194.0, 216.0, 238.0].map(|y| line([20.0, y], [280.0, y], 16.0));
    let thin = [30.0, 50.0].map(|y| line([20.0, y], [280.0, y], 6.0));
    let strokes = [wide.to_vec(), thin.to_vec()].concat();
    let folder = Folder::with(&document(&json!([{"strokes": strokes}])));
    let output = folder.dapple("check a.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("layer 1: gaps between its stripes grown by meinhardt-lines"), "{text}");
    assert!(text.contains("at [150, 30] this line asks for stripes that cover 3"), "{text}");
    assert!(text.contains("less than half or more than half; draw it on a layer of its own"), "{text}");
}

#[test]
fn a_lookup_of_wide_stripes_gives_the_parameters_of_the_gaps_and_says_so() {
    let folder = Folder::new();
    let looked_up = |duty: &str, width: &str| -> Value {
        let question =
            format!("lookup --system meinhardt-lines --angle 20 --width {width} --duty {duty} --json");
        let output = folder.dapple(&question).assert().success().get_output().clone();
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let (wide, thin) = (looked_up("0.75", "15"), looked_up("0.25", "5"));
    assert_eq!((&wide["inverted"], &thin["inverted"]), (&json!(true), &json!(false)));
    assert_eq!(wide["parameters"], thin["parameters"]);
    for key in ["width", "wavelength"] {
        let [asked, predicted] = ["asked", "predicted"].map(|part| wide[part][key].as_f64().unwrap());
        assert!((predicted / asked - 1.0).abs() < 0.02, "{wide}");
        let [low, high] = [0, 1].map(|end| wide["interval"][key][end].as_f64().unwrap());
        assert!(low < predicted && predicted < high, "{wide}");
    }
    for duty in ["0.18", "0.82"] {
        assert_eq!(looked_up(duty, "9")["coverage"], "inside", "{duty}");
    }
}
