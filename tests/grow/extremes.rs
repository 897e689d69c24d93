//! Documents at the edge of what may be asked: grown or refused, never a panic.

use crate::folder::{Folder, document};
use serde_json::{Value, json};

/// Grows it; a picture of the right size, or one line that says why not.
#[track_caller]
fn grown_or_refused(document: &Value) {
    let folder = Folder::with(document);
    let mut command = folder.dapple("grow a.dapple -o a.png --pattern p.png --report r.json");
    let output = command.timeout(std::time::Duration::from_secs(120)).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(!message.contains("panicked"), "{document}: {message}");
    match output.status.code() {
        Some(0) => {
            let picture = image::open(folder.path("a.png")).unwrap();
            assert_eq!(document["size"], json!([picture.width(), picture.height()]));
            assert!(folder.json("r.json")["layers"][0]["steps"].as_u64().unwrap() > 0);
        }
        Some(1) => {
            assert!(message.starts_with("error: "), "{document}: {message}");
            assert_eq!(folder.names(), ["a.dapple"]);
        }
        code => panic!("{document}: exit code {code:?}: {message}"),
    }
}

fn ellipse(center: [f64; 2], radii: [f64; 2]) -> Value {
    json!([{"kind": "ellipse", "center": center, "radii": radii, "angle": 30}])
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Value {
    json!([{"kind": "line", "from": from, "to": to, "width": width}])
}

#[test]
fn marks_as_large_as_the_canvas_or_larger_do_not_panic() {
    for edges in ["closed", "wrap"] {
        let documents = [
            document([100, 100], &ellipse([50.0, 50.0], [100.0, 100.0])),
            document([100, 100], &ellipse([1.0, 99.0], [100.0, 25.0])),
            document([100, 100], &ellipse([50.0, 50.0], [400.0, 300.0])),
            document([100, 60], &line([0.0, 0.0], [100.0, 60.0], 60.0)),
            document([100, 60], &line([0.0, 0.0], [100.0, 60.0], 100.0)),
        ];
        for mut document in documents {
            document["edges"] = json!(edges);
            grown_or_refused(&document);
        }
    }
}

#[test]
fn a_canvas_of_one_px_does_not_panic() {
    for edges in ["closed", "wrap"] {
        for strokes in [ellipse([0.5, 0.5], [1.0, 0.5]), line([0.0, 0.0], [1.0, 1.0], 1.0)] {
            let mut document = document([1, 1], &strokes);
            document["edges"] = json!(edges);
            grown_or_refused(&document);
        }
    }
}

#[test]
fn a_canvas_of_one_row_does_not_panic() {
    grown_or_refused(&document([700, 3], &ellipse([100.0, 1.0], [7.0, 4.0])));
    grown_or_refused(&document([3, 700], &ellipse([1.0, 100.0], [7.0, 4.0])));
    grown_or_refused(&document([2000, 3], &line([0.0, 1.0], [30.0, 2.0], 5.0)));
    grown_or_refused(&document([2000, 1], &line([0.0, 0.5], [30.0, 0.5], 1.0)));
}

#[test]
fn marks_finer_than_a_px_do_not_panic() {
    grown_or_refused(&document([60, 60], &ellipse([30.0, 30.0], [0.01, 0.01])));
    grown_or_refused(&document([60, 60], &ellipse([30.0, 30.0], [30.0, 0.05])));
    grown_or_refused(&document([60, 60], &line([10.0, 10.0], [10.1, 10.0], 0.02)));
}

#[test]
fn more_regions_than_px_do_not_panic() {
    let mut document = document([6, 5], &ellipse([3.0, 3.0], [2.0, 1.0]));
    document["regions"] = json!([8, 8]);
    grown_or_refused(&document);
}

#[test]
fn marks_of_very_different_sizes_do_not_panic() {
    let marks = json!([
        {"kind": "ellipse", "center": [30, 30], "radii": [3, 3], "angle": 0},
        {"kind": "ellipse", "center": [90, 30], "radii": [30, 20], "angle": 90},
    ]);
    let mut document = document([120, 60], &marks);
    document["regions"] = json!([2, 1]);
    grown_or_refused(&document);
}
