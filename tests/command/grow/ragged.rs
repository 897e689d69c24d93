//! Spots and stripes with ragged edges: they have the raggedness that is asked for, and keep their areas and distances.

use dapple_engine::grid::{Edges, Field};
use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// A document with three spots of 18 px, 62 px apart.
fn spots(system: &str, edges: &str) -> Value {
    let spot =
        |center: [f64; 2]| json!({"kind": "ellipse", "center": center, "radii": [20, 16], "angle": 30});
    json!({"format": "dapple", "version": 2, "size": [400, 400], "edges": edges, "layers": [{"system": system,
        "strokes": [spot([150.0, 150.0]), spot([212.0, 150.0]), spot([181.0, 204.0])], "options": {}}]})
}

/// A document with three lines of 14 px, 30 px apart.
fn stripes(edges: &str) -> Value {
    let line = |y: f64| json!({"kind": "line", "from": [120, y], "to": [280, y + 24.0], "width": 14});
    json!({"format": "dapple", "version": 2, "size": [400, 400], "edges": edges, "layers": [{
        "strokes": [line(150.0), line(180.0), line(210.0)], "options": {}}]})
}

/// The result of a document: its pattern, and the first region of its report.
fn grown(document: &Value, edges: Edges, more: &str) -> (Field, Value) {
    let folder = Folder::with(document);
    folder.grow(&format!("--pattern p.png --report r.json {more}"));
    (folder.pattern("p.png", edges), folder.json("r.json")["layers"][0]["regions"][0].clone())
}

fn with_ragged(mut document: Value, sigma: f64) -> Value {
    document["layers"][0]["options"]["ragged"] = json!(sigma);
    document
}

/// The share of a field that is above ½.
fn ink(field: &Field) -> f64 {
    field.values.iter().filter(|value| **value >= 0.5).count() as f64 / field.values.len() as f64
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn spots_get_the_asked_raggedness_and_keep_their_area_and_distance() {
    for system in ["meinhardt-spots", "turing-spots"] {
        let (plain, before) = grown(&spots(system, "wrap"), Edges::Wrap, "");
        assert!(before["got"]["raggedness"].is_null(), "{before}");
        for sigma in [0.1, 0.25] {
            let (ragged, region) = grown(&with_ragged(spots(system, "wrap"), sigma), Edges::Wrap, "");
            assert!((ink(&ragged) / ink(&plain) - 1.0).abs() < 5e-3, "{} {}", ink(&ragged), ink(&plain));
            assert!(number(&region["asked"], "raggedness") > 1.05, "{region}");
            assert!(number(&region["error"], "raggedness").abs() < 0.05, "{region}");
            assert_eq!(region["marks"], before["marks"], "{system}: {region}");
            assert_eq!(region["merged"], 0, "{system}: {region}");
            let change = |of: &str| number(&region["got"], of) / number(&before["got"], of) - 1.0;
            assert!(change("area").abs() < 0.02 && change("spacing").abs() < 0.01, "{system}: {region}");
            assert!((number(&region["got"], "aspect") - number(&before["got"], "aspect")).abs() < 0.13);
        }
    }
}

#[test]
fn stripes_get_ragged_without_loose_pieces_or_holes() {
    let (plain, _) = grown(&stripes("wrap"), Edges::Wrap, "");
    let (ragged, region) = grown(&with_ragged(stripes("wrap"), 0.3), Edges::Wrap, "");
    assert!((ink(&ragged) / ink(&plain) - 1.0).abs() < 5e-3, "{} {}", ink(&ragged), ink(&plain));
    assert!(number(&region["error"], "raggedness").abs() < 0.05, "{region}");
    assert!(number(&region["error"], "width").abs() < 0.01, "{region}");
    // Half of a disc with the width of the stripes, or of the gaps between them.
    let least = 0.4 * std::f64::consts::PI * 7.0 * 7.0;
    for above in [true, false] {
        let [before, after] = [&plain, &ragged].map(|field| smallest_piece(field, above));
        assert!(after as f64 >= least.min(0.8 * before as f64), "{above}: {before} {after}");
    }
}

/// The number of px in the smallest piece of a seamless pattern that is above ½, or below. It is counted px by px,
/// while the spline of the measurement may cross ½ between px.
fn smallest_piece(field: &Field, above: bool) -> usize {
    let [nx, ny] = [field.width, field.height];
    let mut left: Vec<bool> = field.values.iter().map(|value| (*value >= 0.5) == above).collect();
    let mut smallest = usize::MAX;
    for first in 0..left.len() {
        let (mut open, mut count) = (vec![first], 0);
        while let Some(px) = open.pop() {
            if std::mem::take(&mut left[px]) {
                count += 1;
                let (x, y) = (px % nx, px / nx);
                let beside = [[x + 1, y], [x + nx - 1, y], [x, y + 1], [x, y + ny - 1]];
                open.extend(beside.map(|[x, y]| y % ny * nx + x % nx));
            }
        }
        if count > 0 {
            smallest = smallest.min(count);
        }
    }
    smallest
}

#[test]
fn ragged_edges_are_the_same_with_any_number_of_threads_and_without_them_nothing_changes() {
    let folder = Folder::with(&with_ragged(spots("meinhardt-spots", "wrap"), 0.3));
    let grown = [1, 3].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
    let (none, _) = self::grown(&with_ragged(stripes("closed"), 0.0), Edges::Closed, "");
    let (plain, _) = self::grown(&stripes("closed"), Edges::Closed, "");
    assert_eq!(none, plain);
}

#[test]
fn a_layer_above_does_not_touch_ragged_marks_and_outlines_follow_them() {
    let mut document = with_ragged(spots("meinhardt-spots", "wrap"), 0.35);
    let small = json!({"system": "meinhardt-spots",
        "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [6, 6]}, {"kind": "ellipse", "center": [84, 60], "radii": [6, 6]}]});
    document["layers"].as_array_mut().unwrap().push(small);
    let folder = Folder::with(&document);
    folder.grow("--pattern p.png --layer 1 --labels l.png --svg o.svg");
    let (below, (_, labels)) = (folder.pattern("p.png", Edges::Wrap), folder.gray8("l.png"));
    let ours: Vec<usize> = (0..labels.len()).filter(|px| below.values[*px] > 0.55).collect();
    assert!(ours.len() > 20_000, "{}", ours.len());
    assert!(ours.iter().all(|px| labels[*px] == 1));
    let smooth = spots("meinhardt-spots", "wrap");
    let plain = Folder::with(&smooth);
    plain.grow("--svg o.svg");
    let length = |folder: &Folder| String::from_utf8(folder.bytes("o.svg")).unwrap().len();
    assert!(length(&folder) * 10 > length(&plain) * 12, "{} {}", length(&folder), length(&plain));
}

#[test]
fn the_raggedness_that_is_asked_for_is_listed_before_growing() {
    let folder = Folder::with(&with_ragged(stripes("closed"), 0.3));
    let output = folder.dapple("check a.dapple --json").assert().success().get_output().clone();
    let checked: Value = serde_json::from_slice(&output.stdout).unwrap();
    let asked = number(&checked["layers"][0]["regions"][0], "raggedness");
    let (_, region) = grown(&with_ragged(stripes("closed"), 0.3), Edges::Closed, "");
    assert!((number(&region["asked"], "raggedness") - asked).abs() < 1e-6, "{asked}: {region}");
}
