//! Documents at the limits of what is allowed: which of them grow, and which are refused.

use std::time::Duration;

use crate::grow::folder::{Folder, document};
use serde_json::{Value, json};

/// Asserts that `document` grows within two minutes to a picture of the right size.
#[track_caller]
fn grows(document: &Value) {
    let folder = Folder::with(document);
    let mut command = folder.dapple("grow a.dapple -o a.png --pattern p.png --report r.json");
    let output = command.timeout(Duration::from_secs(120)).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{document}: {message}");
    for name in ["a.png", "p.png"] {
        let picture = image::open(folder.path(name)).unwrap();
        assert_eq!(document["size"], json!([picture.width(), picture.height()]), "{name}");
    }
    assert!(folder.json("r.json")["layers"][0]["steps"].as_u64().unwrap() > 0);
}

/// Asserts that `document` is refused with a message of one line that contains these words, and that no file is left.
#[track_caller]
fn is_refused(document: &Value, words: &[&str]) {
    Folder::with(document).refuses("grow a.dapple -o a.png --pattern p.png --report r.json", 1, words);
}

/// Asserts that `document` grows, or is refused for this reason.
#[track_caller]
fn grows_or_is_refused(document: &Value, reason: &str) {
    let folder = Folder::with(document);
    let output = folder.dapple("grow a.dapple -o a.png").timeout(Duration::from_secs(120)).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    match output.status.code() {
        Some(0) => assert!(image::open(folder.path("a.png")).is_ok(), "{document}"),
        code => assert!(code == Some(1) && message.contains(reason), "{document}: {code:?} {message}"),
    }
}

fn ellipse(center: [f64; 2], radii: [f64; 2]) -> Value {
    json!([{"kind": "ellipse", "center": center, "radii": radii, "angle": 30}])
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Value {
    json!([{"kind": "line", "from": from, "to": to, "width": width}])
}

#[test]
fn marks_as_large_as_the_canvas_grow_and_those_that_leave_no_ground_are_refused() {
    for edges in ["closed", "wrap"] {
        let mut line_of_60 = document([100, 60], &line([0.0, 0.0], [100.0, 60.0], 60.0));
        line_of_60["edges"] = json!(edges);
        // A period of the stripes is twice as long as the side of the canvas.
        if edges == "closed" {
            grows(&line_of_60);
        } else {
            is_refused(&line_of_60, &["grew no marks", "draw smaller marks"]);
        }
        let mut across = document([100, 100], &ellipse([1.0, 99.0], [100.0, 25.0]));
        across["edges"] = json!(edges);
        // On a seamless canvas the mark meets itself.
        if edges == "closed" {
            grows(&across);
        } else {
            is_refused(&across, &["marks without any ground", "draw smaller marks"]);
        }
        let covering = [
            document([100, 100], &ellipse([50.0, 50.0], [100.0, 100.0])),
            document([100, 60], &line([0.0, 0.0], [100.0, 60.0], 100.0)),
        ];
        for mut document in covering {
            document["edges"] = json!(edges);
            grows_or_is_refused(&document, "marks without any ground");
        }
        let mut document = document([100, 100], &ellipse([50.0, 50.0], [400.0, 300.0]));
        document["edges"] = json!(edges);
        is_refused(&document, &["layers[0].strokes[0].radii[0]", "found 400", "from 0.01 to 100 px"]);
    }
}

#[test]
fn a_spot_on_a_canvas_of_one_px_grows_or_is_refused() {
    for edges in ["closed", "wrap"] {
        for strokes in [ellipse([0.5, 0.5], [1.0, 0.5]), ellipse([0.5, 0.5], [0.2, 0.15])] {
            let mut document = document([1, 1], &strokes);
            document["edges"] = json!(edges);
            grows_or_is_refused(&document, "marks without any ground");
        }
    }
}

#[test]
fn a_canvas_of_a_few_rows_grows() {
    grows(&document([700, 3], &ellipse([100.0, 1.0], [7.0, 4.0])));
    grows(&document([3, 350], &ellipse([1.0, 100.0], [7.0, 4.0])));
    grows(&document([2000, 3], &line([0.0, 1.0], [30.0, 2.0], 5.0)));
    grows(&document([2000, 1], &line([0.0, 0.5], [30.0, 0.5], 1.0)));
}

#[test]
fn marks_finer_than_a_px_grow() {
    grows(&document([60, 60], &ellipse([30.0, 30.0], [0.01, 0.01])));
    grows(&document([60, 60], &ellipse([30.0, 30.0], [30.0, 0.05])));
    grows(&document([60, 60], &line([10.0, 10.0], [10.1, 10.0], 0.02)));
}

#[test]
fn as_many_regions_as_px_grow_and_more_are_refused() {
    let mut document = document([6, 5], &ellipse([3.0, 3.0], [2.0, 1.0]));
    document["regions"] = json!([6, 5]);
    grows(&document);
    document["regions"] = json!([8, 8]);
    is_refused(&document, &["regions[0]", "found 8", "from 1 to 6"]);
}

#[test]
fn marks_of_very_different_sizes_grow() {
    let marks = json!([
        {"kind": "ellipse", "center": [30, 30], "radii": [3, 3], "angle": 0},
        {"kind": "ellipse", "center": [90, 30], "radii": [30, 20], "angle": 90},
    ]);
    let mut document = document([120, 60], &marks);
    document["regions"] = json!([2, 1]);
    grows(&document);
}
