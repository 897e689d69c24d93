//! Spots that are farther apart than the natural spacing of their system, in one layer: they are placed one by one,
//! with a note.

use super::{cascade, grown, spots};
use dapple::document::Edges;
use dapple::document::{Document, Layer, Stroke};
use dapple_engine::marks::{Ellipse, turn};
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::{Grown, Measured};

#[track_caller]
fn assert_met(grown: &Grown, of: &str) {
    let layer = grown.layers[0].marks().expect("marks");
    let Measured::Spots { errors, .. } = &layer.measured else { panic!("spots") };
    assert!(layer.settled, "{of} is still moving");
    for error in errors {
        let (got, wanted) = (error.got.expect("spots"), error.wanted.expect("spots"));
        let spacing = error.spacing.expect("neighbours");
        assert!(error.area.expect("spots").abs() < 0.05 && spacing.abs() < 0.05, "{of}: {error:?}");
        assert!((got.aspect / wanted.aspect - 1.0).abs() < 0.05, "{of}: {error:?}");
        assert!(wanted.aspect > 0.85 || turn(got.angle, wanted.angle).abs() < 3.0, "{of}: {error:?}");
    }
}

/// A document with about forty spots of 20 px²; their spacing is `diameters` times their diameter.
fn apart(diameters: f64, aspect: f64, edges: Edges) -> Document {
    let spacing = diameters * (20.0 * 4.0 / std::f64::consts::PI).sqrt();
    let side = (6.0 * spacing).round() as u32;
    Document { size: [side; 2], ..cascade(edges, 3, vec![spots(20.0, aspect, 40.0, spacing)]) }
}

#[test]
fn a_spacing_beyond_the_natural_one_is_reached() {
    for edges in [Edges::Wrap, Edges::Closed] {
        for (diameters, aspect) in [(9.0, 1.0), (12.0, 0.5), (20.0, 0.35)] {
            assert_met(
                &grown(&apart(diameters, aspect, edges)),
                &format!("{diameters}, {aspect}, {edges:?}"),
            );
        }
    }
}

#[test]
fn only_some_regions_may_be_sparse() {
    let pair = |x: f64, spacing: f64| {
        [-0.5, 0.5]
            .map(|side| Stroke::Ellipse(Ellipse::from_area([x + side * spacing, 180.0], 40.0, 0.6, 30.0)))
    };
    let strokes = [pair(90.0, 20.0), pair(270.0, 75.0)].concat();
    let document = Document {
        regions: Some([2, 1]),
        ..cascade(Edges::Wrap, 2, vec![Layer { strokes, ..Layer::default() }])
    };
    let grown = grown(&document);
    assert_met(&grown, "half sparse");
    // The parameters with the lowest natural density are left out, because they take as many steps.
    assert!(grown.layers[0].steps() < 5_000, "{} steps", grown.layers[0].steps());
}

#[test]
fn the_report_has_a_note_about_sparse_spots() {
    let report = |document: &Document| serde_json::json!(report(document, "test", &grown(document), 0.0));
    let region = |document: &Document| report(document)["layers"][0]["regions"][0].clone();
    let sparse = region(&apart(9.0, 1.0, Edges::Wrap));
    let note = sparse["notes"][0].as_str().expect("a note");
    assert!(
        note.contains("placed one by one") && note.contains("as they would stand by themselves"),
        "{note}"
    );
    assert!(sparse["parameters"]["pitch"].as_f64().expect("a pitch") > 2.0, "{sparse}");
    let dense = region(&apart(4.0, 1.0, Edges::Wrap));
    assert!(
        dense["parameters"]["pitch"].is_null() && !dense["notes"].to_string().contains("place of its own")
    );
}
