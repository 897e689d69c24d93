//! Photographs of spots in several colours, and of ragged spots. Textures of this project are found again unchanged.

use std::fs;
use std::path::Path;

use dapple::ReadFile;
use dapple::document::{Document, RaggedChoice};
use tempfile::TempDir;

use crate::photos::{done, grown, json, png, read_document};

/// A picture without the data that dapple writes into its own pictures.
fn picture_of(name: &str) -> (TempDir, Document) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    let document = Document::read(file).expect("an example");
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.png"), png(&grown(&document))).expect("written");
    (folder, document)
}

#[test]
fn dots_of_two_colours_on_a_ground_between_them_become_two_layers_with_these_colours() {
    let (folder, document) = picture_of("gallery/phan-grimm-08-two-colour-sets.dapple");
    let printed = json(&done(folder.path(), "import a.png -o b.dapple --json"));
    let sketch = read_document(folder.path(), "b.dapple");
    assert_eq!(sketch.layers.len(), 2, "{printed}");
    for (found, drawn) in sketch.layers.iter().zip(&document.layers) {
        let [found, drawn] =
            [found, drawn].map(|layer| layer.colours.clone().expect("colours").gradient().colour(0.9));
        assert!((0..3).all(|k| found[k].abs_diff(drawn[k]) <= 24), "{found:?} {drawn:?}");
    }
}

#[test]
fn spots_of_several_colours_that_cover_half_of_the_picture_are_the_marks() {
    let (folder, _) = picture_of("gallery/phan-grimm-07a-four-colours-spots.dapple");
    let measured = json(&done(folder.path(), "measure a.png --json"));
    assert_eq!(measured["kind"], "spots");
    assert_eq!(measured["marks"], 39);
    // The ground between them is connected.
    let inverted = json(&done(folder.path(), "import a.png -o b.dapple --invert --take-it --json"));
    assert_eq!(inverted["kind"], "stripes");
}

#[test]
fn ragged_spots_are_found_with_their_raggedness() {
    let (folder, document) = picture_of("spotted-hyena.dapple");
    let measured = json(&done(folder.path(), "measure a.png --json"));
    done(folder.path(), "import a.png -o b.dapple -q");
    done(folder.path(), "grow b.dapple -o b.png --report b.json -q");
    let report = json(&fs::read_to_string(folder.path().join("b.json")).expect("a report"));
    let sketch = read_document(folder.path(), "b.dapple");
    let RaggedChoice::Given(sigma) = sketch.layers[0].options.ragged else { panic!("{sketch:?}") };
    let RaggedChoice::Given(drawn) = document.layers[0].options.ragged else { panic!("a ragged example") };
    assert!((sigma - drawn).abs() < 0.1, "{sigma} {drawn}");
    let back = &report["layers"][0]["regions"][0]["got"]["raggedness"];
    let [back, measured] = [back, &measured["raggedness"]].map(|value| value.as_f64().expect("a number"));
    assert!((back - measured).abs() < 0.1, "{back} {measured}");
}
