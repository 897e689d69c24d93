//! The documents in `examples/`: valid, with only a few marks, and formatted as the program writes them.

mod programs;

use std::fs;
use std::path::PathBuf;

use dapple::ReadFile;
use dapple::document::Document;
use dapple::document::Edges;
use dapple_engine::marks::Mark;
use dapple_engine::synth::Growth;
use dapple_engine::synth::Options;
use dapple_engine::synth::drawn::sketch_targets::{marks, region_map};

fn examples() -> Vec<(PathBuf, Document)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples");
    let entries = fs::read_dir(folder).expect("the examples are there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "dapple"));
    paths.sort();
    paths
        .into_iter()
        .map(|path| (path.clone(), Document::read(&path).expect("an example is valid")))
        .collect()
}

#[test]
fn there_are_at_least_a_dozen_examples_each_with_a_description() {
    let examples = examples();
    assert!(examples.len() >= 12, "{}", examples.len());
    for (path, document) in examples {
        assert!(!document.name.is_empty(), "{}", path.display());
        assert!(document.layers.iter().all(|layer| layer.colours.is_some()), "{}", path.display());
    }
}

#[test]
fn each_document_is_formatted_as_the_program_writes_it() {
    for (path, document) in examples() {
        let text = fs::read_to_string(&path).expect("readable");
        assert!(text == document.to_json(), "{} is not what Document::to_json gives", path.display());
    }
}

#[test]
fn each_region_holds_only_a_few_marks() {
    for (path, document) in examples() {
        for index in 0..document.layers.len() {
            let map = region_map(&document, index, "example").expect("its marks make a region map");
            for (place, region) in map.regions() {
                assert!(region.marks <= 14, "{} {place:?}: {} marks", path.display(), region.marks);
            }
        }
    }
}

#[test]
fn together_the_examples_use_every_kind_of_document() {
    let all: Vec<(Document, Vec<Mark>)> = examples()
        .into_iter()
        .map(|(_, document)| {
            let marks = marks(&document, 0, "example").expect("its strokes make marks");
            (document, marks)
        })
        .collect();
    let some = |what: &str, holds: &dyn Fn(&Document, &[Mark]) -> bool| {
        let found = all.iter().any(|(document, marks)| holds(document, marks));
        assert!(found, "no example of {what}");
    };
    let spots = |marks: &[Mark]| matches!(marks[0], Mark::Ellipse(_));
    some("one region", &|document, _| document.regions == Some([1, 1]));
    some("2 × 2 regions of spots", &|document, marks| document.regions == Some([2, 2]) && spots(marks));
    some("2 × 2 regions of stripes", &|document, marks| document.regions == Some([2, 2]) && !spots(marks));
    some("3 × 3 regions of spots", &|document, marks| document.regions == Some([3, 3]) && spots(marks));
    some("3 × 3 regions of stripes", &|document, marks| document.regions == Some([3, 3]) && !spots(marks));
    some("a tile of spots", &|document, marks| document.edges == Edges::Wrap && spots(marks));
    some("a tile of stripes", &|document, marks| document.edges == Edges::Wrap && !spots(marks));
    some("a canvas that is not square", &|document, _| document.size[0] != document.size[1]);
    let freehand =
        |document: &Document| document.layers[0].strokes.iter().all(|stroke| stroke.kind().is_none());
    some("closed freehand strokes", &|document, marks| freehand(document) && spots(marks));
    some("open freehand strokes", &|document, marks| freehand(document) && !spots(marks));
}

#[test]
fn the_ladybird_grows_a_few_huge_spots() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/ladybird.dapple");
    let document = Document::read(&path).expect("valid");
    let grown = Growth::begin(&document, &Options::default(), None).run();
    let layer = &grown.expect("it grows").layers[0];
    assert!(layer.settled());
    let pattern = layer.pattern().field(512, 512);
    let spots = dapple_engine::measure::spots(&pattern, 0.5);
    let whole: Vec<f64> = spots.iter().filter(|s| s.whole).map(|s| s.ellipse.area()).collect();
    let mean = whole.iter().sum::<f64>() / whole.len() as f64;
    assert!((8..30).contains(&whole.len()), "{} spots", whole.len());
    assert!((mean / 3029.0 - 1.0).abs() < 0.02, "mean area {mean}");
}
