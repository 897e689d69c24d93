//! `--set`.

use crate::outlines::bench::Bench;
use dapple::ReadFile;
use dapple::document::Document;

#[test]
fn a_value_on_the_command_line_replaces_that_in_the_document() {
    let bench = Bench::new();
    let text = bench.text("a.dapple").replace("\"edges\": \"wrap\"", "\"edges\": \"closed\", \"seed\": 7");
    bench.write("changed.dapple", &text);
    let set = "--set edges=closed --set seed=7";
    bench.does("grow changed.dapple -o changed.png");
    bench.does(&format!("grow a.dapple -o a.png {set}"));
    assert!(std::fs::read(bench.path("a.png")).unwrap() == std::fs::read(bench.path("changed.png")).unwrap());
    // The picture holds the document that was grown.
    bench.does(
        "grow a.png -o again.png --set layers[0].colours=#fff,#102030 --set layers[0].options.ragged=.2",
    );
    let (document, _) = dapple_engine::document::in_stream(
        std::io::BufReader::new(std::fs::File::open(bench.path("again.png")).unwrap()),
        "again.png",
    )
    .unwrap()
    .expect("a document");
    let layer = &document.layers[0];
    assert_eq!(layer.colours.as_ref().map(|colours| colours.stops.len()), Some(2));
    assert_eq!(document.seed, 7);
    assert_eq!(Document::read(bench.path("a.dapple")).unwrap().seed, 1, "the file stays");
    for command in [
        "check a.dapple",
        "link a.dapple",
        "sheet a.dapple -o s.png",
        "film a.dapple -o f.gif --side 32 --seconds 0.2",
    ] {
        bench.does(&format!("{command} {set}"));
    }
    assert!(bench.prints(&format!("check a.dapple --json {set}")).contains("\"seed\": 7"));
}

#[test]
fn a_value_is_checked_like_one_in_a_file() {
    let bench = Bench::new();
    for command in ["grow a.dapple -o x.png", "check a.dapple", "film a.dapple -o x.gif", "link a.dapple"] {
        let place = "a.dapple: layers[0].options.ragged: found 9; allowed:";
        bench.refuses(&format!("{command} --set layers[0].options.ragged=9"), 1, &[place]);
        bench.refuses(
            &format!("{command} --set layers[0].system=spotty"),
            1,
            &["layers[0].system: found", "allowed: auto"],
        );
    }
    bench.refuses("check a.dapple --set seed", 2, &["PLACE=VALUE, such as layers[0].options.ragged=.2"]);
}
