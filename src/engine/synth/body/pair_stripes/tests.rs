//! Stripes with tips on small bodies.

use crate::attributes::Attribute;
use crate::document::{DutyChoice, Layer, Stroke, SystemChoice};
use crate::marks::Line;
use crate::rd::pairs::PairKind;
use crate::synth::Options;
use crate::synth::body::BodyGrowth;
use crate::synth::body::kinds_tests::{from_marks, grown, on, spots};
use crate::synth::pattern::EDGE;

fn of(kind: PairKind, layer: Layer) -> Layer {
    Layer { system: SystemChoice::Of(kind.description()), ..layer }
}

#[test]
fn stripes_with_tips_have_the_width_and_the_period_that_are_asked_on_a_torus() {
    for duty in [0.3, 0.6] {
        let line = |i: i32| Line {
            from: [20.0, 30.0 + 18.0 * f64::from(i)],
            to: [160.0, 30.0 + 18.0 * f64::from(i)],
            width: 18.0 * duty,
        };
        let mut layer = of(PairKind::Stripes, Layer::new((0..5).map(|i| Stroke::from(line(i)))));
        layer.options.duty = DutyChoice::Given(duty);
        let grown = grown(&on("torus", 200.0, vec![layer]));
        let report = grown.report("test", 0.0).layers.pop().expect("a layer");
        assert_eq!((report.system, report.regions.len()), ("pair-stripes", 1));
        let error = |attribute: Attribute| report.regions[0].error[&attribute];
        assert!(error(Attribute::Width).abs() < 0.01, "{duty}: {:?}", report.regions[0].error);
        assert!(error(Attribute::Wavelength).abs() < 0.04, "{duty}: {:?}", report.regions[0].error);
        assert!(report.regions[0].direction.expect("directions").rms < 20.0);
    }
}

#[test]
fn stripes_with_tips_keep_away_from_the_marks_beneath() {
    let line = |i: i32| {
        let y = 30.0 + 18.0 * f64::from(i);
        Stroke::from(Line { from: [20.0, y], to: [160.0, y], width: 6.0 })
    };
    let above = of(PairKind::Stripes, Layer::new((0..5).map(line)));
    let grown = grown(&on("torus", 200.0, vec![spots(9.0, 50.0), above]));
    let [spots, stripes] = &grown.layers[..] else { panic!("two layers") };
    let away = from_marks(stripes, spots);
    let on_marks =
        away.iter().zip(&stripes.levelled.pattern).filter(|(away, value)| **away == 0.0 && **value >= EDGE);
    assert_eq!(on_marks.count(), 0);
}

#[test]
fn weaves_are_refused_on_a_model() {
    let layer = of(PairKind::Weave, Layer::default());
    let document = on("torus", 200.0, vec![layer]);
    let refused = BodyGrowth::begin(&document, None, &Options::default()).err().expect("refused").to_string();
    assert!(refused.contains("layers[0].system") && refused.contains("pair-stripes"), "{refused}");
}
