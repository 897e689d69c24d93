//! Every command reports attributes that cannot be reached, with numbers and with lengths in px.

use assert_cmd::Command;
use serde_json::{Value, json};
use std::path::Path;

fn dapple(arguments: &[&str], folder: &Path) -> std::process::Output {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    command.current_dir(folder).args(arguments).assert().success().get_output().clone()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A document with four round ellipses of `radius` px, `pitch` px apart in a square.
fn document(radius: f64, pitch: f64) -> Value {
    let ellipse = |x: f64, y: f64| json!({"kind": "ellipse", "center": [20.0 + x * pitch, 20.0 + y * pitch], "radii": [radius, 0.8 * radius], "angle": 0});
    let strokes = [ellipse(0.0, 0.0), ellipse(1.0, 0.0), ellipse(0.0, 1.0), ellipse(1.0, 1.0)];
    json!({
        "format": "dapple", "version": 1, "size": [120, 120],
        "layers": [{"name": "spots", "system": "meinhardt-spots", "strokes": strokes}]
    })
}

#[test]
fn check_names_drawn_marks_that_are_too_close_to_others() {
    let folder = tempfile::tempdir().unwrap();
    let mut document = document(10.0, 50.0);
    let strokes = document["layers"][0]["strokes"].as_array_mut().unwrap();
    let checked = |document: &Value| {
        std::fs::write(folder.path().join("a.dapple"), document.to_string()).unwrap();
        text(&dapple(&["check", "a.dapple"], folder.path()).stdout)
    };
    strokes.push(json!({"kind": "ellipse", "center": [24, 73], "radii": [10, 8], "angle": 0}));
    let said = checked(&document);
    assert!(
        said.contains("1 of 5 drawn marks will not grow: at (24, 73): closer to another drawn mark"),
        "{said}"
    );
    document["layers"][0]["strokes"].as_array_mut().unwrap().pop();
    let said = checked(&document);
    assert!(!said.contains("will not grow"), "{said}");
}

#[test]
fn check_lookup_and_grow_report_what_cannot_be_reached() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("dense.dapple"), document(10.0, 22.0).to_string()).unwrap();
    let checked = text(&dapple(&["check", "dense.dapple"], folder.path()).stdout);
    let said = checked.lines().map(str::trim).find(|line| line.starts_with("spacing")).unwrap();
    assert!(
        said.contains(" is too small for spots of this size: the smallest distance of their centres is "),
        "{said}"
    );
    assert!(said.ends_with(" px, which grows instead"), "{said}");

    let grown = dapple(&["grow", "dense.dapple", "-o", "a.png", "--report", "r.json"], folder.path());
    assert!(text(&grown.stderr).contains(said), "{}", text(&grown.stderr));
    let report: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("r.json")).unwrap()).unwrap();
    let region = &report["layers"][0]["regions"][0];
    assert!(region["notes"].as_array().unwrap().contains(&json!(said)), "{region}");

    let asked = &region["asked"];
    let [area, aspect, angle, spacing] = ["area", "aspect", "angle", "spacing"]
        .map(|attribute| asked[attribute].as_f64().unwrap().to_string());
    let question = [
        "lookup",
        "--system",
        "meinhardt-spots",
        "--area",
        &area,
        "--aspect",
        &aspect,
        "--angle",
        &angle,
        "--spacing",
        &spacing,
    ];
    assert!(text(&dapple(&question, folder.path()).stdout).contains(said));
    let json: Value =
        serde_json::from_slice(&dapple(&[&question[..], &["--json"]].concat(), folder.path()).stdout)
            .unwrap();
    assert!(json["notes"].as_array().unwrap().contains(&json!(said)), "{json}");
}

#[test]
fn lengths_that_cannot_be_reached_are_reported_in_px() {
    let folder = tempfile::tempdir().unwrap();
    let question = |area: &str| {
        let arguments =
            ["lookup", "--system", "turing-spots", "--area", area, "--aspect", "0.6", "--angle", "0"];
        text(&dapple(&arguments, folder.path()).stdout)
    };
    let said = question("0.5");
    let note = said.lines().find(|line| line.starts_with("note:")).unwrap();
    assert!(note.contains("area 0.5 px² is too small: the smallest possible is "), "{note}");
    assert!(note.contains(" px², which grows instead"), "{note}");
    assert!(!question("300").contains("note:"));
}
