//! Which layers grow again after a change of the document.

use super::{cascade, grown, spots, stripes};
use dapple::document::Edges;
use dapple::document::{After, Document, Layer};
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::{Grown, Growth, Options, Settings, unchanged};

type Change = fn(&mut Document);

fn document() -> Document {
    let small = spots(63.0, 0.8, 60.0, 24.0);
    let layers = vec![spots(850.0, 0.83, 30.0, 80.0), small, stripes(3.0, 45.0)];
    Document { size: [240, 240], ..cascade(Edges::Closed, 1, layers) }
}

/// `document`, grown after `before`, and the number of layers that were grown.
fn after(document: &Document, before: &Grown) -> (Grown, usize) {
    let growth = Growth::begin(document, &Options::default(), Some(before));
    let planned = document.layers.len() - growth.layers().len();
    (growth.run().unwrap(), planned)
}

fn assert_same(a: &Grown, b: &Grown) {
    for (a, b) in a.layers.iter().zip(&b.layers) {
        let [a, b] = [a, b].map(|layer| layer.marks().expect("marks"));
        assert!(a.marks.values == b.marks.values && a.correction == b.correction);
    }
}

#[test]
fn changed_layers_are_grown_again_and_those_beneath_are_not() {
    let before = grown(&document());
    let colours = |document: &mut Document| document.layers[0].visible = false;
    let seed = |document: &mut Document| document.layers[2].seed = Some(9);
    let marks = |document: &mut Document| document.layers[1].strokes.truncate(2);
    let all = |document: &mut Document| document.seed = 2;
    let size = |document: &mut Document| document.size = [200, 240];
    let cases: [(Change, usize); 5] = [(colours, 0), (seed, 1), (marks, 2), (all, 3), (size, 3)];
    for (change, times) in cases {
        let mut document = document();
        change(&mut document);
        let (again, planned) = after(&document, &before);
        assert_eq!(planned, times);
        assert_same(&again, &grown(&document));
    }
}

#[test]
fn renamed_layers_are_not_grown_again_and_reports_have_their_new_names() {
    let spots_inside = Layer { after: After::Inside, ..spots(120.0, 0.8, 60.0, 24.0) };
    let layers = vec![spots(850.0, 0.83, 30.0, 80.0), spots_inside];
    let named = Document { size: [240, 240], ..cascade(Edges::Closed, 1, layers) };
    let before = grown(&named);
    let mut renamed = named.clone();
    renamed.name = "another".to_owned();
    for (layer, name) in renamed.layers.iter_mut().zip(["lower", "upper"]) {
        layer.name = name.to_owned();
    }
    assert_eq!(unchanged(&renamed, Settings::default(), &before), 2);
    let (again, planned) = after(&renamed, &before);
    assert_eq!(planned, 0);
    assert_same(&again, &before);
    assert_eq!(again.document, renamed);
    let report = report(&again.document, "renamed.dapple", &again, 0.0);
    let names: Vec<&str> = report.layers.iter().map(|layer| layer.name.as_str()).collect();
    assert_eq!(names, ["lower", "upper"]);
    let notes = &report.layers[1].regions[0].notes;
    assert!(notes.iter().any(|note| note.contains("each mark of \"lower\"")), "{notes:?}");
}

#[test]
fn layers_without_concentrations_are_grown_again_if_concentrations_are_requested() {
    let layers = vec![spots(850.0, 0.83, 30.0, 80.0)];
    let before = grown(&Document { size: [120, 120], ..cascade(Edges::Closed, 1, layers) });
    let wanted = Settings { concentrations: true, ..Settings::default() };
    assert_eq!(unchanged(&before.document, wanted, &before), 0);
    assert_eq!(unchanged(&before.document, Settings::default(), &before), 1);
}
