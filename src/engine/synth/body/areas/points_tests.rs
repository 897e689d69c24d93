//! Fields of points that grow on small bodies.

use crate::document::{Document, Labels, Layer, Points, Progression, SystemChoice};
use crate::points::discs::POINTS_A_SQUARE;
use crate::points::fields::POINTS;
use crate::synth::Options;
use crate::synth::body::BodyGrowth;
use crate::synth::body::kinds_tests::{from_marks, grown, on, spots};
use crate::synth::pattern::EDGE;
use crate::synth::report::PointsReport;

fn field(points: Points) -> Layer {
    Layer { system: SystemChoice::Of(&POINTS), points: Some(points), ..Layer::default() }
}

fn on_sphere(layers: Vec<Layer>) -> Document {
    on("sphere", 110.0, layers)
}

fn report_of(document: &Document) -> PointsReport {
    let report = grown(document).report("test", 0.0).layers.pop().expect("a layer");
    assert_eq!((report.system, report.regions.len()), (POINTS.name, 0));
    report.points.expect("a field of points")
}

#[test]
fn all_labels_have_the_share_that_is_asked_on_a_model() {
    let random = Labels::Random { dark: [0.5; 2] };
    let all = [
        random,
        Labels::Values { group: 3 },
        Labels::SpaceGiraffe { rays: [8, 12] },
        Labels::BreadthFirst { size: 8 },
        Labels::DepthFirst { size: 8 },
        Labels::RoundRobin { size: 30, rings: 0 },
        Labels::Connected { start: 0.06, rings: 0 },
    ];
    for labels in all {
        let name = labels.name();
        let points = Points { labels, distance: Some([6.0; 2]), share: Some(0.4), ..Points::default() };
        let report = report_of(&on_sphere(vec![field(points)]));
        assert_eq!(report.labels, name);
        assert!((report.share.got - 0.4).abs() < 0.002, "{name}: {:?}", report.share);
    }
}

#[test]
fn points_on_a_model_are_as_far_apart_as_is_asked_or_as_drawn_ellipses() {
    let given = field(Points { distance: Some([7.0; 2]), ..Points::default() });
    let drawn = Layer { points: Some(Points::default()), ..field(Points::default()) };
    let drawn = Layer { strokes: spots(3.0, 9.0).strokes, ..drawn };
    for (layer, distance, share) in [(given, 7.0, 0.5), (drawn, 9.0, 0.388)] {
        let document = on_sphere(vec![layer]);
        let grown = grown(&document);
        let report = grown.report("test", 0.0).layers[0].points.clone().expect("points");
        let area = grown.layers[0].plan.surface().mesh.area();
        let expected = POINTS_A_SQUARE * area / (distance * distance);
        assert!((report.count as f64 / expected - 1.0).abs() < 0.12, "{} of {expected}", report.count);
        assert!((report.share.got - share).abs() < 0.01, "{:?}", report.share);
    }
}

#[test]
fn dark_points_become_more_frequent_along_the_model() {
    let labels = Labels::Random { dark: [0.05, 0.95] };
    let points = Points { labels, distance: Some([5.0; 2]), ..Points::default() };
    for (progression, axis, sign) in [(Progression::Across, 0, 1.0), (Progression::Down, 1, -1.0)] {
        let points = Points { progression, ..points.clone() };
        let grown = grown(&on_sphere(vec![field(points)]));
        let [layer] = &grown.layers[..] else { panic!("one layer") };
        let places = &layer.plan.surface().mesh.positions;
        let share = |beyond: bool| {
            let there: Vec<bool> = places
                .iter()
                .zip(&layer.levelled.pattern)
                .filter(|(at, _)| (sign * at[axis] > 25.0) == beyond && at[axis].abs() > 25.0)
                .map(|(_, value)| *value >= EDGE)
                .collect();
            there.iter().filter(|dark| **dark).count() as f64 / there.len() as f64
        };
        assert!(share(true) > share(false) + 0.4, "{} {}", share(true), share(false));
    }
}

#[test]
fn a_field_of_points_is_light_on_the_marks_beneath() {
    let points = Points { distance: Some([5.0; 2]), ..Points::default() };
    let grown = grown(&on_sphere(vec![spots(10.0, 40.0), field(points)]));
    let [spots, field] = &grown.layers[..] else { panic!("two layers") };
    let away = from_marks(field, spots);
    let dark =
        away.iter().zip(&field.levelled.pattern).filter(|(away, value)| **away == 0.0 && **value >= EDGE);
    assert_eq!(dark.count(), 0);
}

#[test]
fn what_has_no_place_on_a_model_is_refused_with_the_reason() {
    let default = Points { distance: Some([6.0; 2]), ..Points::default() };
    let outward = Points { progression: Progression::Outward, ..default.clone() };
    let towards = Points { shift: 0.5, towards: crate::document::Towards::Outward, ..default };
    for (points, key) in [(outward, "layers[0].points.progression"), (towards, "layers[0].points.towards")] {
        let document = on_sphere(vec![field(points)]);
        let refused =
            BodyGrowth::begin(&document, None, &Options::default()).err().expect("refused").to_string();
        assert!(refused.contains(key) && refused.contains("a model has no middle"), "{refused}");
    }
}
