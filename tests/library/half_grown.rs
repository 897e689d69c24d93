//! Marks that stay between ground and mark.

use dapple::document::{Document, Layer, Stroke};
use dapple_engine::measure::{Spot, faded_axes, spots};
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::report::LayerReport;
use dapple_engine::synth::{Grown, Growth, Options};

fn grown(document: &Document, refine: bool) -> (Grown, LayerReport) {
    let options = Options { refine: Some(refine), ..Options::default() };
    let grown = Growth::begin(document, &options, None).run().expect("it grows");
    let report = report(document, "test", &grown, 0.0).layers.remove(0);
    (grown, report)
}

/// Three waves side by side, 12 px apart and 5 px wide.
fn waves() -> Document {
    let wave = |k: usize| {
        let height = |x: f64| 116.0 + 12.0 * k as f64 + 40.0 * (x / 60.0).sin();
        let points = (0..19).map(|i| 12.0 * f64::from(i)).map(|x| [20.0 + x, height(x)]);
        Stroke::path(points, 5.0)
    };
    Document::new([256, 256]).with_layer(Layer::new((0..3).map(wave).collect::<Vec<_>>()))
}

#[test]
fn lines_that_fade_beside_others_are_taken_away_and_the_drawn_ones_stay() {
    let [before, after] = [false, true].map(|refine| grown(&waves(), refine));
    let faded = |grown: &Grown| {
        let field = grown.layers[0].pattern().field(256, 256);
        faded_axes(&field, &|_| Some(5.0)).iter().map(|axis| axis.length).sum::<f64>()
    };
    let [long, short] = [faded(&before.0), faded(&after.0)];
    assert!(long > 200.0 && short < 0.6 * long, "{long} {short}");
    assert!(after.1.drawn.len() == 3 && after.1.drawn.iter().all(|mark| mark.there), "{:?}", after.1.drawn);
    // What is left is named.
    let named = after.1.regions[0].notes.iter().any(|note| note.contains("stays between ground and mark"));
    assert_eq!(named, !after.1.half_grown.is_empty());
    assert!(!before.1.half_grown.is_empty());
}

/// Nine narrow ellipses in a ring, of which some spots between them begin late.
fn ring() -> Document {
    let drawn = [
        [174.0, 283.0, 21.5, 7.5, 123.0],
        [148.0, 219.0, 20.9, 7.3, 139.0],
        [177.0, 162.0, 23.1, 8.1, 169.0],
        [241.0, 130.0, 22.9, 7.4, 1.0],
        [301.0, 146.0, 22.5, 7.2, 29.0],
        [343.0, 194.0, 22.9, 8.0, 41.0],
        [346.0, 264.0, 21.4, 7.5, 76.0],
        [298.0, 318.0, 20.6, 7.1, 88.0],
        [227.0, 323.0, 21.0, 7.4, 148.0],
    ];
    let strokes = drawn.map(|[x, y, long, short, angle]| Stroke::ellipse([x, y], [long, short], angle));
    Document::new([512, 512]).with_seed(2).with_layer(Layer::new(strokes.to_vec()))
}

#[test]
fn spots_that_are_too_low_begin_again() {
    let (grown, report) = grown(&ring(), true);
    assert!(report.half_grown.is_empty(), "{:?}", report.half_grown);
    let field = grown.layers[0].pattern().field(512, 512);
    let low = |spot: &&Spot| spot.whole && spot.peak < 0.79;
    assert_eq!(spots(&field, 0.5).iter().find(low), None);
}
