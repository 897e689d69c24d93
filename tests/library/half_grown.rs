//! Marks whose values stay between those of ground and mark.

use dapple::document::{Document, Layer, Stroke};
use dapple_engine::measure::{Spot, faded_axes, spots};
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::report::LayerReport;
use dapple_engine::synth::{Grown, Growth, Options};

fn grown(document: &Document) -> (Grown, LayerReport) {
    let grown = Growth::begin(document, &Options::default(), None).run().expect("it grows");
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
fn lines_that_fade_beside_others_are_named() {
    let (grown, report) = grown(&waves());
    let field = grown.layers[0].pattern().field(256, 256);
    let faded = faded_axes(&field, &|_| Some(5.0)).len();
    let named = report.half_grown.len();
    assert!(faded > 8 && named.abs_diff(faded) <= faded / 2, "{faded} {named}");
    let note = report.regions[0].notes.iter().find(|note| note.contains("stays between ground and mark"));
    assert!(note.is_some_and(|note| note.contains(&format!("and {} more places", named - 8))), "{note:?}");
}

/// Eleven ellipses beside which one spot stays too low at first.
fn ellipses() -> Document {
    let drawn = [
        [49.0, 341.0, 12.4, 10.0, 167.0],
        [213.0, 366.0, 12.8, 11.6, 172.0],
        [367.0, 299.0, 13.2, 10.2, 172.0],
        [172.0, 298.0, 12.0, 10.9, 162.0],
        [472.0, 265.0, 12.0, 11.5, 162.0],
        [104.0, 290.0, 11.3, 11.3, 173.0],
        [19.0, 140.0, 11.3, 11.3, 161.0],
        [129.0, 181.0, 12.3, 11.2, 173.0],
        [312.0, 264.0, 11.3, 10.0, 166.0],
        [93.0, 31.0, 10.9, 10.1, 158.0],
        [503.0, 169.0, 11.3, 11.1, 168.0],
    ];
    let strokes = drawn.map(|[x, y, long, short, angle]| Stroke::ellipse([x, y], [long, short], angle));
    Document::new([512, 512]).with_seed(149).with_layer(Layer::new(strokes.to_vec()))
}

#[test]
fn spots_whose_values_stay_too_low_are_restarted() {
    let (grown, report) = grown(&ellipses());
    assert!(report.half_grown.is_empty(), "{:?}", report.half_grown);
    let field = grown.layers[0].pattern().field(512, 512);
    let low = |spot: &&Spot| spot.whole && spot.peak < 0.79;
    assert_eq!(spots(&field, 0.5).iter().find(low), None);
}
