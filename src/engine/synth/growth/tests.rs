use super::*;
use crate::document::{After, Document, ToneImage};
use crate::synth::check::check;
use crate::synth::layer_report::report;

/// A small document of each system that a document can name, of a tone, and of layers on top of each other.
fn documents() -> Vec<(String, Document)> {
    const SPOTS: &str = r#"{"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30},
        {"kind": "ellipse", "center": [58, 34], "radii": [9, 6], "angle": 20},
        {"kind": "ellipse", "center": [40, 62], "radii": [8, 6], "angle": 35}"#;
    const LINES: &str = r#"{"kind": "line", "from": [10, 20], "to": [80, 24], "width": 6},
        {"kind": "line", "from": [10, 34], "to": [80, 38], "width": 6}"#;
    const ACROSS: &str = r#"{"kind": "line", "from": [10, 20], "to": [80, 24], "width": 5},
        {"kind": "line", "from": [10, 34], "to": [80, 38], "width": 5},
        {"kind": "line", "from": [30, 10], "to": [32, 80], "width": 5},
        {"kind": "line", "from": [46, 10], "to": [48, 80], "width": 5}"#;
    let layer = |system: &str, strokes: &str, more: &str| {
        format!(r#"{{"system": "{system}", "strokes": [{strokes}]{more}}}"#)
    };
    let image =
        ToneImage::new([12, 11], (0..132).map(|px| (px * 19 % 250) as u8).collect()).expect("a picture");
    let tone = format!(r#", "tone": {{"image": {{"png": "{}"}}}}"#, image.base64());
    let one = [
        ("turing-spots", SPOTS, ""),
        ("meinhardt-spots", SPOTS, ""),
        ("meinhardt-spots", SPOTS, r#", "options": {"ragged": 0.2}"#),
        ("meinhardt-stripes", LINES, ""),
        ("meinhardt-lines", LINES, ""),
        ("weave", ACROSS, ""),
        ("maze", ACROSS, ""),
        ("pair-stripes", LINES, ""),
        ("stucco", SPOTS, ""),
        ("patches", SPOTS, ""),
        ("cells", SPOTS, ""),
        ("streaks", LINES, ""),
        ("cracks", LINES, ""),
        ("points", "", ""),
        ("turing-growth", "", ""),
        ("meinhardt-stripes", "", tone.as_str()),
    ];
    let mut layers: Vec<(String, String)> = one
        .iter()
        .map(|(system, strokes, more)| (format!("{system}{more}"), layer(system, strokes, more)))
        .collect();
    let between = layer("auto", LINES, "");
    layers.push(("layers".to_owned(), format!("{}, {between}", layer("meinhardt-spots", SPOTS, ""))));
    let document = |(name, layers): (String, String)| {
        let text = format!(
            r#"{{"format": "dapple", "version": 2, "size": [96, 88], "edges": "wrap", "layers": [{layers}]}}"#
        );
        let document = Document::parse(&text, &name).unwrap_or_else(|error| panic!("{error}"));
        (name, document)
    };
    layers.into_iter().map(document).collect()
}

/// The patterns and the report of a document that is grown in parts of this budget; `looks`: its pictures are read in between.
fn grown(document: &Document, budget: u64, looks: bool) -> (Vec<Vec<u32>>, String) {
    let mut growth = Growth::begin(document, &Options::default(), None);
    while growth.advance(budget).unwrap_or_else(|error| panic!("{error}")) != Progress::Done {
        if looks && let Some(look) = growth.snapshot() {
            assert!((look.growing.pattern)().field(16, 16).values.iter().all(|value| value.is_finite()));
        }
    }
    let grown = growth.complete().expect("all layers have grown");
    let bits = |layer: &GrownLayer| {
        layer.pattern().field(96, 88).values.iter().map(|value| value.to_bits()).collect()
    };
    let report = serde_json::to_string(&report(document, "", &grown, 0.0)).expect("a report");
    (grown.layers.iter().map(bits).collect(), report)
}

#[test]
fn a_growth_does_not_depend_on_its_budgets_nor_on_whether_it_is_read() {
    for (name, document) in documents() {
        let whole = grown(&document, u64::MAX, false);
        assert!(grown(&document, 1, false) == whole, "{name} in parts of 1");
        assert!(grown(&document, 7, true) == whole, "{name} in parts of 7, looked at");
        assert!(grown(&document, 300_000, false) == whole, "{name} in parts of 300,000");
    }
}

#[test]
fn a_filmed_growth_ends_like_an_unfilmed_one() {
    for (name, document) in documents() {
        let (whole, _) = grown(&document, u64::MAX, false);
        let mut growth = Growth::begin(&document, &Options::default(), None).filmed();
        let mut seen = 0;
        while growth.advance(growth.updates_in(0.5)).expect("it grows") != Progress::Done {
            seen += usize::from(growth.snapshot().is_some());
        }
        let grown = growth.complete().expect("all layers have grown");
        assert!(seen > 5, "{name}: {seen} moments");
        for (layer, bits) in grown.layers.iter().zip(whole) {
            let values = layer.pattern().field(96, 88).values;
            assert!(values.iter().map(|value| value.to_bits()).eq(bits), "{name}");
        }
    }
}

#[test]
fn the_least_budget_does_one_part_of_the_work_and_a_growth_can_be_dropped_at_any_time() {
    let (_, document) = documents().swap_remove(1);
    let mut growth = Growth::begin(&document, &Options::default(), None);
    assert!(growth.layers().is_empty() && growth.snapshot().is_none());
    let mut stages = Vec::new();
    for _ in 0..200 {
        assert_eq!(growth.advance(1).map(|progress| progress == Progress::Done).ok(), Some(false));
        stages.push(growth.progress().0);
    }
    stages.dedup();
    assert_eq!(stages, [Stage::Plan, Stage::Grow]);
    assert!(growth.complete().is_none());
}

#[test]
fn a_layer_that_cannot_be_grown_is_refused_before_the_first_one_grows() {
    let (_, mut document) = documents().pop().expect("layers");
    document.layers[1].system = crate::document::SystemChoice::Of(&crate::document::systems::POINTS);
    document.layers[1].strokes.clear();
    let mut options = Options { memory: Some(80e6), ..Options::default() };
    options.size = Some([4000, 4000]);
    let mut growth = Growth::begin(&document, &options, None);
    let refused = loop {
        match growth.advance(1) {
            Ok(progress) => assert_eq!(progress, Progress::Growing { seen: false }),
            Err(error) => break error,
        }
    };
    assert!(refused.to_string().contains("GB of memory"), "{refused}");
    assert!(growth.layers().is_empty());
    assert_eq!(growth.advance(1).ok(), Some(Progress::Done));
    assert!(growth.complete().is_none(), "what did not grow was given as grown");
}

#[test]
fn a_layer_near_others_needs_memory_for_its_thinning() {
    let (_, mut document) = documents().pop().expect("layers");
    document.layers[1] = document.layers[0].clone();
    let least = |document: &Document| {
        // So large that it is not grown to be checked.
        let options = Options { size: Some([2000, 2000]), ..Options::default() };
        let checked = |memory: f64| check(document, &Options { memory: Some(memory), ..options });
        let fits = |memory: f64| checked(memory).is_ok_and(|checked| checked.refusal.is_none());
        let mut range = [1e4, 1e10];
        for _ in 0..24 {
            let middle = f64::sqrt(range[0] * range[1]);
            range[usize::from(fits(middle))] = middle;
        }
        range[1]
    };
    document.layers[1].after = After::Between;
    let between = least(&document);
    document.layers[1].after = After::Near;
    let near = least(&document);
    assert!(near > 1.2 * between && near < 1e9, "{between} {near}");
}

#[test]
fn a_seamless_canvas_that_is_far_longer_than_wide_is_refused_by_check_and_growth_at_once() {
    for (name, mut document) in documents() {
        let refused = |document: &Document, options: &Options| {
            let error = check(document, options).map(|checked| checked.refusal).expect_err(&name).to_string();
            let mut growth = Growth::begin(document, options, None);
            assert_eq!(growth.advance(u64::MAX).expect_err(&name).to_string(), error);
            error
        };
        let strip = Options { size: Some([257, 1]), ..Options::default() };
        let error = refused(&document, &strip);
        assert!(error.contains("size: found") && error.contains("257 × 1 px"), "{name}: {error}");
        document.size = [20_000, 1];
        let error = refused(&document, &Options::default());
        assert!(error.contains("20000 × 1 px") && error.contains("\"edges\": \"closed\""), "{name}: {error}");
    }
}
