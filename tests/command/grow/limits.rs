//! The memory and time that a document needs are known before it grows. Too much of either is refused by `check` and
//! `grow` alike, and nothing aborts.

use std::time::Duration;

use crate::grow::folder::{Folder, document};
use serde_json::{Value, json};

/// The address space that the program may use, kB.
const MEMORY: u32 = 2_000_000;

/// Runs `dapple` with this limit of the address space; returns the exit code and stderr.
#[track_caller]
fn limited(folder: &Folder, arguments: &str) -> (Option<i32>, String) {
    let program = assert_cmd::cargo::cargo_bin!("dapple").display().to_string();
    // This limit of the address space is for the process alone.
    let limit = if cfg!(target_os = "linux") { format!("ulimit -v {MEMORY};") } else { String::new() };
    let mut command = assert_cmd::Command::new("sh");
    command.args(["-c", &format!("{limit} exec '{program}' {arguments}")]).current_dir(folder.path(""));
    let output = command.timeout(Duration::from_secs(60)).output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// Asserts that `check` and `grow` refuse `document` with one line that contains these words.
#[track_caller]
fn is_refused(document: &Value, words: &[&str]) {
    let folder = Folder::with(document);
    for arguments in ["check a.dapple", "grow a.dapple -o a.png --threads 1"] {
        let (code, message) = limited(&folder, arguments);
        assert_eq!(code, Some(1), "{arguments}: {message}");
        assert!(message.starts_with("error: ") && message.trim_end().lines().count() == 1, "{message}");
        for word in words {
            assert!(message.contains(word), "{arguments}: {word} in {message}");
        }
    }
    assert_eq!(folder.names(), ["a.dapple"]);
}

/// Asserts that `check` accepts `document` and `grow` grows it.
#[track_caller]
fn grows(document: &Value) {
    let folder = Folder::with(document);
    for arguments in ["check a.dapple", "grow a.dapple -o a.png --threads 1 --quiet"] {
        let (code, message) = limited(&folder, arguments);
        assert_eq!(code, Some(0), "{arguments}: {message}");
    }
    assert!(folder.names().contains(&"a.png".to_owned()));
}

fn on_tile(size: [u32; 2], layer: &Value) -> Value {
    json!({"format": "dapple", "version": 2, "size": size, "edges": "wrap", "layers": [layer]})
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Value {
    json!({"kind": "line", "from": from, "to": to, "width": width})
}

fn ellipse(center: [f64; 2], radii: [f64; 2]) -> Value {
    json!({"kind": "ellipse", "center": center, "radii": radii, "angle": 30})
}

#[test]
fn points_farther_apart_than_a_tile_is_long_are_refused_with_the_distance_that_is_allowed() {
    for (size, distance) in [([16, 16], 100_000), ([4, 4], 10_000), ([16, 16], 12)] {
        let field = json!({"system": "points", "strokes": [], "points": {"distance": distance}});
        let found = format!("found {distance}");
        is_refused(&on_tile(size, &field), &["layers[0].points.distance", &found, "half the diagonal"]);
    }
    let field = json!({"system": "points", "strokes": [], "points": {"distance": 4}});
    grows(&on_tile([16, 16], &field));
}

#[test]
fn noise_far_larger_than_a_tile_grows() {
    let noise = json!({"noise": {"size": 100_000, "range": [1, 1.1]}});
    let strokes = json!([line([0.0, 2.0], [2.0, 2.0], 1.0)]);
    grows(&on_tile([16, 16], &json!({"system": "stripes", "strokes": strokes, "maps": {"spacing": noise}})));
}

#[test]
fn points_of_very_different_distances_are_refused_where_they_do_not_fit_into_memory() {
    // Beyond closed edges, the frame is as wide as the largest distances, and is filled with points at the smallest
    // ones.
    let points = json!({"distance": [2, 100_000], "octaves": 8, "labels": {"kind": "space-giraffe", "rays": [60, 60]}});
    let mut field = on_tile([185, 191], &json!({"system": "points", "strokes": [], "points": points}));
    field["edges"] = json!("closed");
    is_refused(&field, &["layer 1", "GB of memory", "differ less"]);
}

#[test]
fn patches_larger_than_a_tile_beside_small_ones_cover_it_and_nothing_aborts() {
    let strokes = json!([
        ellipse([219.0, 61.0], [400.0, 400.0]),
        ellipse([385.0, 21.0], [386.0, 380.0]),
        ellipse([338.0, 30.0], [161.0, 161.0]),
        ellipse([206.0, 24.0], [8.0, 1.7]),
        ellipse([12.0, 59.0], [14.0, 3.0]),
        ellipse([360.0, 89.0], [16.0, 8.0]),
    ]);
    let document =
        on_tile([400, 100], &json!({"system": "patches", "strokes": strokes, "options": {"keep": false}}));
    let folder = Folder::with(&document);
    let (code, message) = limited(&folder, "grow a.dapple -o a.png --threads 1 --quiet");
    assert!(code == Some(1) && message.contains("without any ground"), "{code:?} {message}");
}

#[test]
fn lines_that_differ_too_much_in_width_are_refused_with_the_time_that_they_would_take() {
    let mut strokes = vec![
        line([73.06, 69.13], [74.07, 69.24], 12.50),
        line([163.58, -16.54], [209.48, 22.12], 12.50),
        line([6.56, -24.79], [54.71, 148.66], 12.50),
        line([123.43, -36.24], [65.23, 134.10], 8.33),
        line([156.08, 94.95], [11.86, 202.68], 6.25),
        line([104.07, 181.59], [104.09, 181.60], 6.25),
        line([155.59, 133.92], [155.59, 133.95], 6.25),
        line([7.93, 37.87], [7.11, 38.48], 6.25),
    ];
    let of = |strokes: &[Value]| {
        let mut document = document([200, 186], &json!(strokes));
        document["version"] = json!(2);
        document["regions"] = json!([3, 3]);
        document["layers"][0]["system"] = json!("pair-stripes");
        document
    };
    grows(&of(&strokes));
    strokes.push(line([151.77, 76.38], [152.04, 77.36], 200.0));
    is_refused(
        &of(&strokes),
        &["layer 1", "200×186 px may take about 10 s", "differ less in size", "--minutes"],
    );
}

/// A maze with lines of a quarter of a px and of a hundredth of a px.
fn fine_maze() -> Value {
    let strokes = json!([line([0.0, 1.7], [0.8, 1.7], 0.25), line([0.4, 2.8], [0.4, 2.9], 0.01)]);
    let mut maze = document([4, 3], &strokes);
    maze["version"] = json!(2);
    maze["layers"][0]["system"] = json!("maze");
    maze
}

#[test]
fn a_maze_of_lines_far_finer_than_a_px_is_refused_on_a_small_canvas() {
    is_refused(&fine_maze(), &["layer 1", "4×3 px may take about 5 s", "draw larger marks"]);
}

#[test]
fn a_growth_that_takes_longer_than_the_limit_is_accepted_with_more_minutes() {
    let folder = Folder::with(&fine_maze());
    let (code, message) = limited(&folder, "check a.dapple --minutes 2");
    assert_eq!(code, Some(0), "{message}");
    assert_eq!(limited(&folder, "check a.dapple --minutes 0").0, Some(2));
}
