//! Cells have the size, shape, direction and distance that were drawn, and drawn outlines are cells among them.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

fn ellipse(center: [f64; 2], radii: [f64; 2], angle: f64) -> Value {
    json!({"kind": "ellipse", "center": center, "radii": radii, "angle": angle})
}

/// A document with one ellipse of this area (px²), aspect and direction, and lines of `gap` px.
fn document(size: [u32; 2], edges: &str, [area, aspect, angle, gap]: [f64; 4]) -> Value {
    let major = (area / std::f64::consts::PI / aspect).sqrt();
    let mark = ellipse(size.map(|side| 0.5 * f64::from(side)), [major, aspect * major], angle);
    json!({"format": "dapple", "version": 2, "size": size, "edges": edges,
        "layers": [{"system": "cells", "strokes": [mark], "options": {"keep": false, "gap": gap}}]})
}

fn layer(folder: &Folder, more: &str) -> Value {
    folder.grow(&format!("--report r.json {more}"));
    folder.json("r.json")["layers"][0].clone()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn cells_have_the_drawn_area_aspect_direction_and_lines() {
    for (size, edges, wanted) in [
        ([400, 400], "wrap", [1500.0, 0.55, 30.0, 6.0]),
        ([420, 360], "closed", [900.0, 0.7, 110.0, 5.0]),
        ([300, 300], "wrap", [420.0, 0.8, 70.0, 7.0]),
        ([700, 500], "wrap", [3600.0, 0.6, 0.0, 8.0]),
    ] {
        let found = layer(&Folder::with(&document(size, edges, wanted)), "");
        assert_eq!(found["system"], "cells");
        let region = &found["regions"][0];
        let [area, aspect, _, gap] = wanted;
        // About as many cells as fit; cells that a closed edge cuts are not counted.
        let cell = (area.sqrt() + 0.93 * gap).powi(2);
        let fit = f64::from(size[0] * size[1]) / cell;
        let marks = number(region, "marks");
        assert!(
            marks < 1.1 * fit && marks > if edges == "wrap" { 0.9 } else { 0.6 } * fit,
            "{marks} of {fit}"
        );
        let error = |key: &str| number(&region["error"], key).abs();
        assert!(error("area") < 0.03, "{wanted:?}: {region}");
        assert!(error("aspect") < 0.1 && (aspect > 0.75 || error("angle") < 6.0), "{wanted:?}: {region}");
        let got = number(&found["gap"], "got");
        assert!((got / gap - 1.0).abs() < 0.12, "{wanted:?}: {got}");
    }
}

#[test]
fn drawn_outlines_are_cells_among_the_others() {
    let outline = |points: &[[f64; 2]]| json!({"kind": "outline", "points": points});
    let strokes = [
        outline(&[
            [170., 178.],
            [195., 170.],
            [222., 174.],
            [230., 200.],
            [224., 224.],
            [196., 230.],
            [172., 220.],
        ]),
        outline(&[
            [244., 185.],
            [270., 178.],
            [298., 187.],
            [300., 219.],
            [276., 233.],
            [248., 227.],
            [240., 209.],
        ]),
        ellipse([235.0, 280.0], [34.0, 26.0], 20.0),
    ];
    for edges in ["wrap", "closed"] {
        let document = json!({"format": "dapple", "version": 2, "size": [420, 420], "edges": edges,
            "layers": [{"system": "cells", "strokes": strokes}]});
        let found = layer(&Folder::with(&document), "");
        for mark in found["drawn"].as_array().expect("marks") {
            assert!(mark["there"] == true && number(mark, "off") < 0.1, "{mark}");
            let [asked, got] = ["asked", "got"].map(|key| number(&mark[key], "area"));
            assert!((got / asked - 1.0).abs() < 0.06, "{mark}");
        }
        // The lines are as wide as the gaps between the drawn outlines: 10 to 16 px.
        assert!((9.0..17.0).contains(&number(&found["gap"], "asked")), "{}", found["gap"]);
        assert!(number(&found["regions"][0]["error"], "area").abs() < 0.05, "{}", found["regions"][0]);
    }
}

#[test]
fn lines_are_as_wide_on_a_larger_canvas() {
    let strokes = [ellipse([90.0, 90.0], [18.0, 15.0], 0.0), ellipse([132.0, 90.0], [18.0, 15.0], 0.0)];
    let document = json!({"format": "dapple", "version": 2, "size": [220, 200], "edges": "wrap",
        "layers": [{"system": "cells", "strokes": strokes, "options": {"keep": false}}]});
    let folder = Folder::with(&document);
    for size in ["", "--size 440x400"] {
        let found = layer(&folder, size);
        // 42 − 2 · 18 px.
        assert!((number(&found["gap"], "asked") - 6.0).abs() < 1e-6, "{size}: {}", found["gap"]);
        assert!((number(&found["regions"][0]["got"], "area") / 848.2 - 1.0).abs() < 0.03, "{size}");
    }
}

#[test]
fn a_line_drawn_beside_the_ellipses_gives_the_lines_between_cells_their_width() {
    // The ellipses are 6 px apart; the line is 8 px wide, the freehand stroke 10 px.
    let ellipses = [ellipse([90.0, 90.0], [18.0, 15.0], 0.0), ellipse([132.0, 90.0], [18.0, 15.0], 0.0)];
    let stroke: Vec<[f64; 2]> = (0..12).map(|k| [30.0 + 8.0 * f64::from(k), 150.0]).collect();
    let lines = [
        json!({"kind": "line", "from": [40, 130], "to": [120, 160], "width": 8}),
        json!({"kind": "freehand", "points": stroke, "width": 10}),
    ];
    let strokes: Vec<Value> = lines.into_iter().chain(ellipses).collect();
    let mut document = json!({"format": "dapple", "version": 2, "size": [360, 360], "edges": "wrap",
        "layers": [{"system": "cells", "strokes": strokes}]});
    let folder = Folder::with(&document);
    let check = folder.dapple("check a.dapple --json").assert().success().get_output().stdout.clone();
    let check: Value = serde_json::from_slice(&check).expect("JSON");
    let checked = &check["layers"][0];
    assert_eq!((number(checked, "gap"), number(checked, "kept")), (9.0, 2.0), "{checked}");
    assert_eq!(checked["regions"][0]["marks"], 2, "lines are no cells: {checked}");
    let found = layer(&folder, "");
    assert_eq!(number(&found["gap"], "asked"), 9.0);
    let got = number(&found["gap"], "got");
    assert!((got / 9.0 - 1.0).abs() < 0.1, "{got}");
    assert!(number(&found["regions"][0]["error"], "area").abs() < 0.05, "{found}");
    // The cells that are kept are the drawn strokes.
    let marks: Vec<&Value> =
        found["drawn"].as_array().expect("marks").iter().map(|mark| &mark["mark"]).collect();
    assert_eq!(marks, [2, 3]);
    // The option takes precedence.
    document["layers"][0]["options"] = json!({"gap": 5});
    let found = layer(&Folder::with(&document), "");
    assert_eq!(number(&found["gap"], "asked"), 5.0);
}

#[test]
fn a_closed_freehand_stroke_is_a_cell_as_the_pen_drew_it() {
    // An egg with a flat end, which no ellipse is.
    let point = |k: usize| {
        let (s, c) = (std::f64::consts::TAU * k as f64 / 80.0).sin_cos();
        [150.0 + 40.0 * c.min(0.5) + 0.3 * (7.0 * c).sin(), 150.0 + 34.0 * s]
    };
    let points: Vec<[f64; 2]> = (0..80).map(point).collect();
    let document = json!({"format": "dapple", "version": 2, "size": [320, 300], "edges": "wrap",
        "layers": [{"system": "cells", "strokes": [{"kind": "freehand", "points": points}], "options": {"gap": 8}}]});
    let folder = Folder::with(&document);
    let found = layer(&folder, "--pattern p.png");
    let mark = &found["drawn"][0];
    assert!(mark["there"] == true && number(mark, "off") < 0.08, "{mark}");
    let ([width, _], values) = folder.gray16("p.png");
    let is_cell = |x: usize, y: usize| values[y * width + x] >= 32_768;
    // The cell reaches the flat end at x = 170 and no farther; the ellipse with the same moments would.
    assert!(is_cell(166, 150) && is_cell(166, 128) && !is_cell(174, 150), "not the flat end");
}

#[test]
fn regions_have_cells_of_their_own_size() {
    let strokes = [ellipse([60.0, 150.0], [10.0, 10.0], 0.0), ellipse([540.0, 150.0], [32.0, 26.0], 20.0)];
    let document = json!({"format": "dapple", "version": 2, "size": [600, 300], "regions": [2, 1],
        "layers": [{"system": "cells", "strokes": strokes, "options": {"gap": 5, "keep": false}}]});
    let found = layer(&Folder::with(&document), "");
    let regions = found["regions"].as_array().expect("regions");
    for region in regions {
        assert!(number(&region["error"], "area").abs() < 0.05, "{region}");
    }
    assert!(number(&regions[1]["got"], "area") > 3.0 * number(&regions[0]["got"], "area"));
}

#[test]
fn cells_keep_clear_of_the_layers_beneath() {
    let spots = json!({"name": "spots", "strokes": [ellipse([60.0, 60.0], [9.0, 8.0], 0.0), ellipse([130.0, 60.0], [9.0, 8.0], 0.0)]});
    let cells = json!({"name": "cells", "system": "cells", "strokes": [ellipse([150.0, 150.0], [14.0, 12.0], 0.0)],
        "options": {"keep": false, "gap": 4}});
    let document = json!({"format": "dapple", "version": 2, "size": [300, 300], "edges": "wrap", "layers": [spots, cells]});
    let folder = Folder::with(&document);
    folder.grow("--labels l.png --svg o.svg");
    let ([width, height], labels) = folder.gray8("l.png");
    let share = |label: u8| labels.iter().filter(|px| **px == label).count() as f64 / labels.len() as f64;
    assert!(share(1) > 0.02 && share(2) > 0.4, "{} {}", share(1), share(2));
    let at = |x: usize, y: usize| labels[(y % height) * width + x % width];
    let touching = (0..labels.len()).filter(|px| {
        let (x, y) = (px % width, px / width);
        [at(x + 1, y), at(x, y + 1)].iter().any(|beside| at(x, y) + beside == 3 && at(x, y) * beside == 2)
    });
    let touching = touching.count();
    assert!(touching < 12, "{touching} px touch");
    assert!(String::from_utf8(folder.bytes("o.svg")).expect("text").contains("<path"));
}

#[test]
fn the_number_of_threads_of_the_computer_changes_no_byte_of_cells() {
    let folder = Folder::with(&document([220, 180], "wrap", [500.0, 0.7, 20.0, 5.0]));
    let grown = [1, 3].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
}

#[test]
fn what_cells_cannot_have_is_reported_with_the_reason() {
    let lines = json!({"format": "dapple", "version": 2, "size": [200, 200],
        "layers": [{"system": "cells", "strokes": [{"kind": "line", "from": [10, 10], "to": [60, 10]}]}]});
    Folder::with(&lines).refuses("check a.dapple", 1, &["layers[0].system", "spots", "lines"]);
    // A line beside the ellipses is allowed for cells only.
    let mut both = lines;
    both["layers"][0]["strokes"].as_array_mut().expect("strokes").push(ellipse(
        [100.0, 90.0],
        [9.0, 8.0],
        0.0,
    ));
    Folder::with(&both).dapple("check a.dapple").assert().success();
    both["layers"][0]["system"] = json!("patches");
    Folder::with(&both).refuses("check a.dapple", 1, &["layers[0].strokes[1]", "a layer of their own"]);
    let mut spots = document([200, 200], "wrap", [500.0, 0.8, 0.0, 5.0]);
    spots["layers"][0]["system"] = json!("auto");
    Folder::with(&spots).refuses("check a.dapple", 1, &["layers[0].options.gap", "cells"]);
    spots["layers"][0]["system"] = json!("cells");
    spots["layers"][0]["options"] = json!({"ragged": 0.2});
    Folder::with(&spots).refuses("check a.dapple", 1, &["layers[0].options.ragged", "patches"]);
    spots["layers"][0]["options"] = json!({"gap": 0.2});
    Folder::with(&spots).refuses("check a.dapple", 1, &["layers[0].options.gap", "1 to 1000 px"]);
    // Lines that leave no room are made thinner, and a note says so.
    spots["layers"][0]["options"] = json!({"gap": 15});
    let folder = Folder::with(&spots);
    let output = folder.dapple("check a.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(
        text.contains("leave no room for cells of 500 px²") && text.contains("lines of 8.1 px"),
        "{text}"
    );
}
