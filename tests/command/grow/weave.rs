//! Weaves: crossing lines grow as threads of their widths, distances and directions, where they were drawn.

use std::path::Path;

use crate::grow::folder::Folder;
use serde_json::{Value, json};

fn line(middle: [f64; 2], angle: f64, length: f64, width: f64) -> Value {
    let (s, c) = angle.to_radians().sin_cos();
    let end = |along: f64| [middle[0] + along * c, middle[1] + along * s];
    json!({"kind": "line", "from": end(-0.5 * length), "to": end(0.5 * length), "width": width})
}

/// A document with three lines side by side of each direction: angle, width, period.
fn weave(size: u32, directions: &[(f64, f64, f64)]) -> Value {
    let middle = 0.5 * f64::from(size);
    let mut strokes = Vec::new();
    for (angle, width, period) in directions {
        let (s, c) = angle.to_radians().sin_cos();
        for off in [-period, 0.0, *period] {
            strokes.push(line([middle - off * s, middle + off * c], *angle, 0.6 * f64::from(size), *width));
        }
    }
    let layer = json!({"name": "threads", "system": "weave", "strokes": strokes});
    json!({"format": "dapple", "version": 2, "size": [size, size], "layers": [layer]})
}

fn report(document: &Value) -> (Folder, Value) {
    let folder = Folder::with(document);
    folder.grow("--report r.json");
    let report = folder.json("r.json");
    (folder, report)
}

#[test]
fn threads_are_as_wide_and_far_apart_as_drawn_and_lie_where_they_were_drawn() {
    for directions in [[(10.0, 6.0, 24.0), (80.0, 8.0, 30.0)], [(150.0, 7.0, 28.0), (30.0, 7.0, 22.0)]] {
        let (_, report) = report(&weave(320, &directions));
        let layer = &report["layers"][0];
        assert_eq!(layer["system"], "weave");
        let threads = layer["threads"].as_array().unwrap();
        assert_eq!(threads.len(), 2);
        for (threads, (angle, width, period)) in threads.iter().zip(directions) {
            let asked = &threads["asked"];
            let near = |key: &str, value: f64| (asked[key].as_f64().unwrap() / value - 1.0).abs() < 0.02;
            assert!(near("width", width) && near("wavelength", period), "{threads}");
            assert!((asked["angle"].as_f64().unwrap() - angle).abs() < 0.5, "{threads}");
            let error = |key: &str| threads["error"][key].as_f64().unwrap().abs();
            // There are about ten threads: half a thread more or less is 5 %.
            assert!(error("width") < 0.04 && error("wavelength") < 0.05, "{threads}");
            assert!(error("angle") < 0.7 && error("angle_rms") < 2.0, "{threads}");
        }
        let drawn = layer["drawn"].as_array().unwrap();
        assert!(drawn.len() == 6 && drawn.iter().all(|line| line["there"] == true), "{drawn:?}");
    }
}

#[test]
fn the_picture_shows_the_threads_of_the_report() {
    let (folder, report) = report(&weave(256, &[(0.0, 7.0, 28.0), (70.0, 7.0, 24.0)]));
    folder.grow("--pattern p.png");
    let share = pattern_share(&folder.path("p.png"));
    let threads = report["layers"][0]["threads"].as_array().unwrap();
    let free: f64 = threads
        .iter()
        .map(|threads| {
            1.0 - threads["got"]["width"].as_f64().unwrap() / threads["got"]["wavelength"].as_f64().unwrap()
        })
        .product();
    assert!((share - (1.0 - free)).abs() < 0.02, "{share} for {}", 1.0 - free);
}

/// The share of the px of a pattern that threads cover.
fn pattern_share(path: &Path) -> f64 {
    let gray = image::open(path).unwrap().into_luma16();
    gray.pixels().filter(|px| px.0[0] >= 32_768).count() as f64 / f64::from(gray.width() * gray.height())
}

#[test]
fn a_single_line_of_each_direction_is_enough() {
    let mut document = weave(192, &[]);
    document["layers"][0]["strokes"] =
        json!([line([90.0, 100.0], 20.0, 120.0, 8.0), line([100.0, 96.0], 100.0, 120.0, 8.0)]);
    let (_, report) = report(&document);
    for threads in report["layers"][0]["threads"].as_array().unwrap() {
        let error = |key: &str| threads["error"][key].as_f64().unwrap().abs();
        assert!(error("width") < 0.05 && error("wavelength") < 0.05, "{threads}");
    }
}

#[test]
fn curved_lines_that_cross_are_followed() {
    let wave = |y: f64| {
        let at = |i: i32| [10.0 + 8.0 * f64::from(i), y + 12.0 * (0.15 * f64::from(i)).sin()];
        json!({"kind": "path", "points": (0..30).map(at).collect::<Vec<_>>(), "width": 7.0})
    };
    let mut strokes: Vec<Value> = [90.0, 116.0, 142.0].into_iter().map(wave).collect();
    strokes.extend([90.0, 118.0].map(|x| line([x, 128.0], 88.0, 200.0, 7.0)));
    let mut document = weave(256, &[]);
    document["layers"][0]["strokes"] = json!(strokes);
    let (_, report) = report(&document);
    let layer = &report["layers"][0];
    assert_eq!(layer["threads"].as_array().unwrap().len(), 2);
    let drawn = layer["drawn"].as_array().unwrap();
    assert!(drawn.iter().all(|line| line["there"] == true), "{drawn:?}");
    for threads in layer["threads"].as_array().unwrap() {
        assert!(threads["error"]["angle_rms"].as_f64().unwrap() < 4.0, "{threads}");
    }
}

#[test]
fn the_number_of_threads_of_the_computer_changes_no_byte() {
    let mut document = weave(128, &[(5.0, 6.0, 22.0), (70.0, 6.0, 26.0)]);
    document["edges"] = json!("wrap");
    let folder = Folder::with(&document);
    let grown = [1, 4].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
}

#[test]
fn lines_of_one_direction_are_refused_with_the_remedy() {
    let mut document = weave(128, &[(5.0, 6.0, 22.0)]);
    let folder = Folder::with(&document);
    folder.refuses("grow a.dapple -o a.png", 1, &["layers[0].strokes", "one direction", "draw lines across"]);
    folder.refuses("check a.dapple", 1, &["layers[0].strokes", "one direction"]);
    document["layers"][0]["strokes"] = json!([{"kind": "ellipse", "center": [50, 50], "radii": [9, 6]}]);
    let folder = Folder::with(&document);
    folder.refuses("grow a.dapple -o a.png", 1, &["layers[0].system", "ellipse"]);
}

#[test]
fn spots_grow_between_the_threads_of_a_weave_beneath_but_not_round_them() {
    let mut document = weave(256, &[(0.0, 8.0, 60.0), (90.0, 8.0, 60.0)]);
    let spot = json!({"kind": "ellipse", "center": [100, 100], "radii": [6, 5]});
    document["layers"].as_array_mut().unwrap().push(json!({"name": "spots", "strokes": [spot]}));
    let folder = Folder::with(&document);
    folder.grow("--labels l.png --report r.json");
    let labels = image::open(folder.path("l.png")).unwrap().into_luma8();
    let share = |label: u8| labels.pixels().filter(|px| px.0[0] == label).count() as f64 / 65_536.0;
    assert!(share(1) > 0.15 && share(2) > 0.015, "{} {}", share(1), share(2));
    document["layers"][1]["after"] = json!("inside");
    let folder = Folder::with(&document);
    folder.refuses(
        "grow a.dapple -o a.png",
        1,
        &["layers[1].after", "allowed: between", "pairs of morphogens"],
    );
}
