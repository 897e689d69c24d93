//! `dapple import`.

use crate::outlines::bench::Bench;
use dapple::ReadFile;
use dapple::document::{Document, Stroke};

const SKETCH: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200">
    <g id="spots"><circle cx="50" cy="50" r="12"/><ellipse cx="90" cy="55" rx="14" ry="8"/>
    <line x1="10" y1="150" x2="80" y2="160" stroke="#222" stroke-width="5"/></g>
    <g id="beyond"><circle cx="900" cy="50" r="12"/></g><text>hello</text></svg>"##;

#[test]
fn an_svg_becomes_a_document_that_grows() {
    let bench = Bench::new();
    bench.write("in.svg", SKETCH);
    let output = bench.does("import in.svg -o in.dapple");
    for word in ["3 marks in 2 layers", "300 × 200 px", "1 × text", "1 × mark off the canvas"] {
        assert!(output.contains(word), "{word} in {output}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&bench.prints("import in.svg -o in.dapple --json")).unwrap();
    assert_eq!((&json["marks"], &json["size"]), (&3.into(), &serde_json::json!([300, 200])));
    assert_eq!(json["unread"], serde_json::json!({"mark off the canvas": 1, "text": 1}));
    let document = Document::read(bench.path("in.dapple")).unwrap();
    assert_eq!((document.name.as_str(), document.size), ("in", [300, 200]));
    let names: Vec<_> = document.layers.iter().map(|layer| layer.name.as_str()).collect();
    assert_eq!(names, ["spots spots", "spots lines"]);
    let Stroke::Ellipse(circle) = &document.layers[0].strokes[0] else { panic!("{document:?}") };
    assert!((circle.center[0] - 50.0).abs() < 0.02 && (circle.radii[0] - 12.0).abs() < 0.05, "{circle:?}");
    bench.does("check in.dapple");
}

#[test]
fn shapes_over_the_border_stay_and_shapes_that_are_not_ellipses_keep_their_outline() {
    let bench = Bench::new();
    bench.write(
        "in.svg",
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"><circle cx="-4" cy="50" r="12"/>
        <path d="M100 100 L140 100 L140 140 L120 120 L100 140 Z"/>
        <line x1="290" y1="150" x2="900" y2="150" stroke="black" stroke-width="5"/></svg>"#,
    );
    bench.does("import in.svg -o in.dapple");
    let document = Document::read(bench.path("in.dapple")).unwrap();
    let [spots, lines] = &document.layers[..] else { panic!("{document:?}") };
    let Stroke::Ellipse(circle) = &spots.strokes[0] else { panic!("{spots:?}") };
    assert!((circle.center[0] + 4.0).abs() < 0.02, "{circle:?}");
    let Stroke::Fitted { outline, .. } = &spots.strokes[1] else { panic!("{spots:?}") };
    assert_eq!(
        outline.points,
        [[100.0, 100.0], [140.0, 100.0], [140.0, 140.0], [120.0, 120.0], [100.0, 140.0]]
    );
    assert_eq!(spots.areas(), None, "automatic takes spots");
    let Stroke::Line(line) = &lines.strokes[0] else { panic!("{lines:?}") };
    assert_eq!(
        (line.from, line.to),
        ([290.0, 150.0], [600.0, 150.0]),
        "cut where a document can hold no more"
    );
}

#[test]
fn exported_outlines_are_imported_as_the_grown_marks() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.svg --no-refine --units px --quiet");
    let output = bench.does("import a.svg -o b.dapple");
    let document = Document::read(bench.path("b.dapple")).unwrap();
    assert_eq!(document.size, [128, 96], "{output}");
    assert_eq!(document.layers[0].name, "big spots");
    assert!(document.layers[0].strokes.len() > 8);
}

#[test]
fn a_file_without_a_sketch_is_refused_with_a_remedy() {
    let bench = Bench::new();
    bench.write("bad.svg", "<svg");
    bench.write(
        "empty.svg",
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><text>x</text></svg>"#,
    );
    bench.write("in.svg", SKETCH);
    bench.refuses("import bad.svg -o b.dapple", 1, &["bad.svg", "is no SVG", "allowed"]);
    bench.refuses("import empty.svg -o b.dapple", 1, &["empty.svg", "no marks", "1 × text", "allowed"]);
    bench.refuses("import none.svg -o b.dapple", 1, &["none.svg", "cannot be read"]);
    bench.refuses("import in.svg -o b.svg", 1, &["b.svg", ".dapple"]);
    bench.refuses("import in.svg -o b.dapple --dpi 0", 2, &["--dpi", "dots an inch"]);
    bench.refuses("import in.svg -o b.dapple --dpi 99999", 1, &["in.svg", "65536", "--dpi"]);
}
