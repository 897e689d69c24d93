//! Growths on small bodies.

use super::anchors::anchors;
use super::asked::Asked;
use super::drawn_spacing::drawn_spacing;
use super::placed::Placed;
use super::plan::{self, BodyPlan};
use super::remeshed::Remeshed;
use super::{BodyGrowth, BodyProgress, GrownBody};
use crate::document::{Body, BodyEllipse, BodyMark, BodySource, Document, Layer, Stroke};
use crate::surface::Surface;
use crate::synth::Options;
use crate::synth::training::Training;

/// Round spots 24 px apart on a built-in body of so many px.
fn document(name: &'static str, px: f64) -> Document {
    let at = |i: i32| {
        [40.0 + 24.0 * f64::from(i % 4) + 12.0 * f64::from(i / 4 % 2), 40.0 + 20.8 * f64::from(i / 4)]
    };
    let layer = Layer::new((0..16).map(|i| Stroke::ellipse(at(i), [4.0, 4.0], 0.0)));
    let model = Some(Body { px, ..Body::new(BodySource::BuiltIn(name)) });
    Document { model, ..Document::new([200, 160]).with_layer(layer) }
}

fn grown(document: &Document, budget: u64) -> GrownBody {
    let mut growth = BodyGrowth::begin(document, None, &Options::default()).expect("it has a model");
    while growth.advance(budget).expect("it grows") == BodyProgress::Growing {}
    growth.complete().expect("it has grown")
}

fn surface(placed: &Placed, body: &Body, cell: f64) -> Surface {
    let mut remeshed = Remeshed::begin(placed, cell);
    while remeshed.advance() {}
    let [_, fine] = remeshed.surfaces(body);
    fine
}

#[test]
fn how_long_it_takes_is_known_once_the_model_is_read() {
    let [small, large] = [90.0, 180.0].map(|px| {
        let document = document("torus", px);
        let mut growth = BodyGrowth::begin(&document, None, &Options::default()).expect("it has a model");
        assert_eq!(growth.seconds(), None);
        while growth.seconds().is_none() {
            growth.advance(1).expect("it fits");
        }
        growth.seconds().expect("a time")
    });
    assert!((large / small - 4.0).abs() < 1e-6, "{small} {large}");
}

#[test]
fn marks_on_the_model_without_a_sketch_want_the_distance_that_they_have_there() {
    // Rows on the flat front of a cube of 90 px whose sides are 2 long.
    let at = |i: i32| [0.4 * f64::from(i % 3) - 0.4, 0.5 * f64::from(i / 3) - 0.5, 1.0];
    let mark =
        |i: i32| BodyMark::Ellipse(BodyEllipse { at: at(i), normal: None, radii: [4.0, 4.0], angle: 0.0 });
    let mut document = document("cube", 90.0);
    document.layers[0].strokes.clear();
    document.layers[0].on_model = (0..9).map(mark).collect();
    let body = document.model.clone().expect("a model");
    let placed = Placed::read(&body, None, "test").expect("a cube");
    let drawn = drawn_spacing(&document, 0, &body, &placed, &Options::default()).expect("it fits");
    let middle = drawn[4].expect("a distance");
    // Two neighbours at 18 px, two at 22.5.
    assert!((middle - 20.25).abs() < 0.2, "{drawn:?}");
    document.layers[0].strokes = vec![Stroke::ellipse([40.0, 40.0], [4.0, 4.0], 0.0)];
    assert!(drawn_spacing(&document, 0, &body, &placed, &Options::default()).expect("it fits").is_empty());
}

#[test]
fn the_pattern_does_not_depend_on_how_the_growth_is_cut() {
    let document = document("torus", 90.0);
    let whole = grown(&document, u64::MAX);
    let [whole] = &whole.layers[..] else { panic!("one layer") };
    assert!(whole.settled && whole.spots() > 20, "{}", whole.spots());
    for budget in [1, 40_000] {
        let cut = grown(&document, budget);
        let cut = &cut.layers[0];
        assert_eq!((cut.steps, &cut.levelled.pattern), (whole.steps, &whole.levelled.pattern), "{budget}");
    }
}

#[test]
fn another_seed_lays_other_spots_of_the_same_area() {
    let [first, second] = [1, 2].map(|seed| grown(&Document { seed, ..document("sphere", 90.0) }, u64::MAX));
    let [first, second] = [&first.layers[0], &second.layers[0]];
    assert_ne!(first.levelled.pattern, second.levelled.pattern);
    for grown in [first, second] {
        assert_eq!(grown.laid, grown.spots());
        let sums = grown.levelled.measured.sums[0];
        assert!((sums.got / sums.wanted - 1.0).abs() < 1e-3, "{sums:?}");
        let before = grown.levelled.before[0];
        assert!((before.got / before.wanted - 1.0).abs() < 0.015, "{before:?}");
    }
}

#[test]
fn spots_on_coarser_cells_have_lower_levels() {
    // Such cells make spots smaller.
    let document = document("sphere", 90.0);
    let (body, training) = (document.model.clone().expect("a model"), Training::built_in());
    let placed = Placed::read(&body, None, "test").expect("a sphere");
    let asked = Asked::read(&document, 0, &body, &[], "test", training).expect("spots");
    let cell = plan::cell(&document, &asked, training).expect("a cell");
    let level = |cell: f64| {
        let surface = surface(&placed, &body, cell);
        let placed = Placed::read(&body, None, "test").expect("a sphere");
        BodyPlan::new(&document, &body, &asked, &placed, surface, training).expect("a plan").levels[0]
    };
    assert!(level(cell) < level(0.6 * cell), "{} {}", level(cell), level(0.6 * cell));
}

#[test]
fn strokes_on_the_model_turn_the_directions_along_them() {
    let mut document = document("sphere", 90.0);
    document.layers[0].strokes.iter_mut().for_each(|stroke| {
        if let Stroke::Ellipse(ellipse) = stroke {
            ellipse.radii = [6.0, 3.0];
        }
    });
    let mut body = document.model.clone().expect("a model");
    // Up along the front, where +x of the sketch would run to the right.
    body.strokes = vec![vec![[0.0, -0.5, 0.87], [0.0, 0.0, 1.0], [0.0, 0.5, 0.87]]];
    let training = Training::built_in();
    let placed = Placed::read(&body, None, "test").expect("a sphere");
    let asked = Asked::read(&document, 0, &body, &[], "test", training).expect("spots");
    let cell = plan::cell(&document, &asked, training).expect("a cell");
    let surface = surface(&placed, &body, cell);
    let plan = BodyPlan::new(&document, &body, &asked, &placed, surface, training);
    let plan = plan.expect("a plan");
    let front = plan.surface().vertex_of(plan.surface().closest([0.0, 0.0, 45.0]));
    let angle = plan.wanted[front].angle();
    assert!((angle - 90.0).abs() < 4.0, "{angle}");
    assert!(!anchors(&asked, &document, &body, plan.surface(), &placed.scale).is_empty());
}
