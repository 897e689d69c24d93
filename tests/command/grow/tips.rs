//! Stripes with tips, stucco, and threads that lie over and under each other.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

fn document(layer: &Value, edges: &str) -> Value {
    json!({"format": "dapple", "version": 2, "size": [320, 320], "edges": edges, "layers": [layer]})
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Value {
    json!({"kind": "line", "from": from, "to": to, "width": width})
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn stripes_with_tips_have_the_drawn_width_period_and_direction() {
    for (duty, edges) in [(0.25, "wrap"), (0.5, "closed"), (0.7, "wrap")] {
        let layer = json!({"system": "pair-stripes", "options": {"duty": duty},
            "strokes": [line([100.0, 80.0], [160.0, 200.0], 6.0)]});
        let folder = Folder::with(&document(&layer, edges));
        folder.grow("--report r.json");
        let threads = &folder.json("r.json")["layers"][0]["threads"][0];
        let error = &threads["error"];
        assert!(number(error, "width").abs() < 0.03, "{duty}: {error}");
        assert!(number(error, "wavelength").abs() < 0.06, "{duty}: {error}");
        assert!(number(error, "angle").abs() < 2.5, "{duty}: {error}");
        assert!((number(&threads["asked"], "wavelength") - 6.0 / duty).abs() < 0.1, "{threads}");
    }
}

#[test]
fn stucco_has_the_width_of_the_drawn_marks_and_decay_turns_worms_into_dots() {
    let marks = [
        json!({"kind": "ellipse", "center": [100, 100], "radii": [12, 5], "angle": 20}),
        line([100.0, 100.0], [150.0, 120.0], 10.0),
    ];
    let mut covered = Vec::new();
    for (decay, mark) in [(0.3, &marks[0]), (0.8, &marks[1])] {
        let layer = json!({"system": "stucco", "options": {"decay": decay}, "strokes": [mark]});
        let folder = Folder::with(&document(&layer, "wrap"));
        folder.grow("--report r.json --pattern p.png");
        let blotches = &folder.json("r.json")["layers"][0]["blotches"];
        assert!((number(blotches, "asked") - 10.0).abs() < 1e-9, "{blotches}");
        assert!((number(blotches, "got") / 10.0 - 1.0).abs() < 0.06, "{decay}: {blotches}");
        let (_, values) = folder.gray16("p.png");
        covered.push(values.iter().filter(|value| **value > 0x8000).count());
    }
    assert!(covered[0] > covered[1], "{covered:?}");
}

/// The pattern of threads 12 px wide along x and along y, with this order of crossings.
fn woven(over: &str) -> ([usize; 2], Vec<u16>) {
    let strokes = [
        line([60.0, 100.0], [260.0, 100.0], 12.0),
        line([60.0, 140.0], [260.0, 140.0], 12.0),
        line([100.0, 60.0], [100.0, 260.0], 12.0),
        line([140.0, 60.0], [140.0, 260.0], 12.0),
    ];
    let layer = json!({"system": "weave", "options": {"over": over}, "strokes": strokes});
    let folder = Folder::with(&document(&layer, "closed"));
    folder.grow("--pattern p.png");
    folder.gray16("p.png")
}

#[test]
fn threads_lie_over_and_under_and_keep_their_edges() {
    let ([width, _], level) = woven("level");
    let (_, plain) = woven("plain");
    for (level, plain) in level.iter().zip(&plain) {
        assert_eq!(*level > 0x8000, *plain > 0x8000, "edges move");
        assert!(plain <= level, "nothing is higher than without an order");
    }
    // Beside a crossing, on the centre lines of the two threads: the one below is lower.
    let at = |x: usize, y: usize| f64::from(plain[y * width + x]) / 65535.0;
    let beside = |[x, y]: [usize; 2]| {
        let along_x = at(x - 8, y) + at(x + 8, y);
        let along_y = at(x, y - 8) + at(x, y + 8);
        along_x - along_y
    };
    let [one, next, below] = [[100, 100], [140, 100], [100, 140]].map(beside);
    assert!(one.abs() > 0.3 && next.abs() > 0.3, "{one} {next}");
    assert!(one * next < 0.0 && one * below < 0.0, "one over, one under: {one} {next} {below}");
}
