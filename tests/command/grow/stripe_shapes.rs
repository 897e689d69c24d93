//! Stripes whose width varies along them, which open into two, and which are ragged although no system of stripes grew them: what was
//! asked for stays.

use dapple_engine::grid::{Edges, Field};
use dapple_engine::measure::{Regions, widths};
use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// A seamless document with two lines of 12 px, 32 px apart, and these options.
fn stripes(system: &str, options: &Value) -> Value {
    let line = |y: f64| json!({"kind": "line", "from": [80, y], "to": [240, y + 30.0], "width": 12});
    json!({"format": "dapple", "version": 2, "size": [320, 320], "edges": "wrap", "layers": [{
        "system": system, "strokes": [line(120.0), line(152.6)], "options": options}]})
}

const SYSTEMS: [&str; 4] = ["meinhardt-stripes", "meinhardt-lines", "pair-stripes", "streaks"];

/// The pattern, and the first region of the report.
fn grown(document: &Value) -> (Field, Value) {
    let folder = Folder::with(document);
    folder.grow("--pattern p.png --report r.json");
    (folder.pattern("p.png", Edges::Wrap), folder.json("r.json")["layers"][0]["regions"][0].clone())
}

fn ink(field: &Field) -> f64 {
    field.values.iter().filter(|value| **value >= 0.5).count() as f64 / field.values.len() as f64
}

/// The share of px that are in a mark of one of two patterns alone.
fn moved(one: &Field, other: &Field) -> f64 {
    let differ = one.values.iter().zip(&other.values).filter(|(a, b)| (**a >= 0.5) != (**b >= 0.5));
    differ.count() as f64 / one.values.len() as f64
}

#[test]
fn varied_stripes_keep_what_was_asked_and_their_ink() {
    for system in SYSTEMS {
        let (plain, before) = grown(&stripes(system, &json!({})));
        for options in [json!({"vary": 0.4}), json!({"double": 0.4}), json!({"vary": 0.3, "double": 0.3})] {
            let (varied, region) = grown(&stripes(system, &options));
            assert_eq!(region["got"], before["got"], "{system} {options}");
            assert!((ink(&varied) / ink(&plain) - 1.0).abs() < 0.01, "{system} {options}: {}", ink(&varied));
            assert!(moved(&varied, &plain) > 0.03, "{system} {options}: {}", moved(&varied, &plain));
        }
    }
}

#[test]
fn streaks_and_stripes_with_tips_get_the_asked_raggedness() {
    for system in ["pair-stripes", "streaks"] {
        let (plain, _) = grown(&stripes(system, &json!({})));
        let raggedness = |sigma: f64| {
            let (ragged, _) = grown(&stripes(system, &json!({"ragged": sigma})));
            assert!((ink(&ragged) / ink(&plain) - 1.0).abs() < 0.01, "{system}: {}", ink(&ragged));
            let [before, after] = [&plain, &ragged].map(|field| widths(field, 0.5, Regions::ONE)[0].unwrap());
            (before / after).powi(2)
        };
        let [some, more] = [0.2, 0.4].map(raggedness);
        assert!(some > 1.15 && more > some + 0.15, "{system}: {some} {more}");
    }
}

#[test]
fn shapes_are_the_same_with_any_number_of_threads_and_none_change_nothing() {
    let folder = Folder::with(&stripes("pair-stripes", &json!({"vary": 0.4, "double": 0.3, "ragged": 0.2})));
    let grown = [1, 3].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
    let none = stripes("streaks", &json!({"vary": 0, "double": 0, "ragged": "drawn"}));
    assert_eq!(self::grown(&none), self::grown(&stripes("streaks", &json!({}))));
}

#[test]
fn a_layer_above_keeps_off_the_varied_stripes() {
    let mut document = stripes("pair-stripes", &json!({"vary": 0.5, "double": 0.4}));
    let small = json!({"system": "meinhardt-spots",
        "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [4, 4]}, {"kind": "ellipse", "center": [76, 60], "radii": [4, 4]}]});
    document["layers"].as_array_mut().unwrap().push(small);
    let folder = Folder::with(&document);
    folder.grow("--pattern p.png --layer 1 --labels l.png");
    let (below, (_, labels)) = (folder.pattern("p.png", Edges::Wrap), folder.gray8("l.png"));
    let ours: Vec<usize> = (0..labels.len()).filter(|px| below.values[*px] > 0.6).collect();
    assert!(ours.len() > 20_000, "{}", ours.len());
    assert!(ours.iter().all(|px| labels[*px] == 1));
    assert!(labels.iter().filter(|label| **label == 2).count() > 500);
}

#[test]
fn what_does_not_vary_along_lines_refuses_these_options() {
    for system in ["cracks", "weave"] {
        let folder = Folder::with(&stripes(system, &json!({"vary": 0.3})));
        folder.refuses("grow a.dapple -o a.png", 1, &["options.vary", "does not take this option"]);
    }
    let folder = Folder::with(&stripes("stripes", &json!({"vary": 0.9})));
    folder.refuses("check a.dapple", 1, &["options.vary", "0.9", "from 0 to 0.8"]);
}
