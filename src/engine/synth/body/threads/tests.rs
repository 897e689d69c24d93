//! Weaves and stripes with tips on small bodies.

use crate::attributes::Attribute;
use crate::document::{DutyChoice, Layer, Over, Stroke, SystemChoice};
use crate::marks::Line;
use crate::rd::pairs::PairKind;
use crate::synth::Options;
use crate::synth::body::BodyGrowth;
use crate::synth::body::kinds_tests::{from_marks, grown, on, spots};
use crate::synth::pattern::EDGE;

/// Lines of this width, so many px apart, along x; and across them others.
fn crossing(width: f64, apart: [f64; 2]) -> Layer {
    let along = |i: i32| Line {
        from: [10.0, 40.0 + apart[0] * f64::from(i)],
        to: [200.0, 40.0 + apart[0] * f64::from(i)],
        width,
    };
    let across = |i: i32| Line {
        from: [50.0 + apart[1] * f64::from(i), 10.0],
        to: [50.0 + apart[1] * f64::from(i), 150.0],
        width,
    };
    let lines = (0..4).map(along).chain((0..4).map(across));
    Layer::new(lines.map(Stroke::from))
}

fn of(kind: PairKind, layer: Layer) -> Layer {
    Layer { system: SystemChoice::Of(kind.description()), ..layer }
}

#[test]
fn threads_of_a_weave_have_the_widths_and_the_distances_that_are_asked_on_a_torus() {
    // Lines that cross are a weave by themselves.
    let grown = grown(&on("torus", 200.0, vec![crossing(5.0, [18.0, 22.0])]));
    let report = grown.report("test", 0.0).layers.pop().expect("a layer");
    assert_eq!((report.system, report.threads.len(), report.regions.len()), ("weave", 2, 0));
    for threads in &report.threads {
        let error = threads.error.expect("threads");
        assert!(error.width.abs() < 0.05 && error.wavelength.abs() < 0.06, "{threads:?}");
        assert!(error.angle.abs() < 4.0 && error.angle_rms < 15.0, "{threads:?}");
    }
    let between = crate::marks::turn(report.threads[1].asked.angle, report.threads[0].asked.angle).abs();
    assert!((between - 90.0).abs() < 1.0, "{between}");
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
fn threads_keep_away_from_the_marks_beneath() {
    let grown = grown(&on("torus", 200.0, vec![spots(9.0, 50.0), crossing(5.0, [18.0, 18.0])]));
    let [spots, weave] = &grown.layers[..] else { panic!("two layers") };
    let away = from_marks(weave, spots);
    let on_marks =
        away.iter().zip(&weave.levelled.pattern).filter(|(away, value)| **away == 0.0 && **value >= EDGE);
    assert_eq!(on_marks.count(), 0);
}

#[test]
fn threads_that_lie_over_others_are_refused_on_a_model_with_the_reason() {
    let mut layer = of(PairKind::Weave, crossing(5.0, [18.0, 18.0]));
    layer.options.over = Over::Plain;
    let document = on("torus", 200.0, vec![layer]);
    let refused = BodyGrowth::begin(&document, None, &Options::default()).err().expect("refused").to_string();
    assert!(refused.contains("layers[0].options.over") && refused.contains("cannot be counted"), "{refused}");
}
