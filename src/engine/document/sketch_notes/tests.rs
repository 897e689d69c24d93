//! Sketches that will not grow as they were drawn.

use std::f64::consts::TAU;

use super::*;
use crate::document::{After, Layer, Stroke, SystemChoice};
use crate::sketch::recognise;

fn notes(layers: Vec<Layer>) -> Vec<SketchNote> {
    let document = Document { layers, ..Document::default() };
    notes_on(&document)
}

fn outline(radius: impl Fn(f64) -> f64) -> Stroke {
    let point = |k: usize| {
        let turn = k as f64 / 120.0;
        let (s, c) = (TAU * turn).sin_cos();
        [100.0 + radius(turn) * c, 100.0 + 0.8 * radius(turn) * s]
    };
    Stroke::Freehand { points: (0..=120).map(point).collect(), width: 6.0 }
}

#[test]
fn hidden_layers_are_noted_if_no_layer_is_visible() {
    let spot = || Layer::new([Stroke::ellipse([50.0, 50.0], [9.0, 7.0], 0.0)]);
    let told = notes(vec![spot().hidden(), spot().hidden()]);
    assert!(matches!(&told[..], [note] if note.text.starts_with("all layers are hidden")), "{told:?}");
    assert!(notes(vec![spot().hidden(), spot()]).is_empty());
}

#[test]
fn an_outline_far_from_an_ellipse_is_told_with_how_far() {
    let star = outline(|turn| 30.0 * (1.0 + 0.35 * (5.0 * TAU * turn).cos()));
    let spiral: Vec<[f64; 2]> = (0..400)
        .map(|k| f64::from(k) / 399.0)
        .map(|t| (t, (TAU * 4.0 * t).sin_cos()))
        .map(|(t, (s, c))| [100.0 + 40.0 * t * c, 100.0 + 40.0 * t * s])
        .collect();
    let wobbly = outline(|turn| 30.0 * (1.0 + 0.03 * (5.0 * TAU * turn).cos()));
    let told = notes(vec![Layer::new([wobbly, star])]);
    let [note] = &told[..] else { panic!("{told:?}") };
    assert_eq!((note.layer, &note.strokes[..]), (Some(0), &[1][..]));
    assert!((note.places[0][0] - 100.0).abs() < 3.0, "{note:?}");
    let per_cent: f64 = note.text.split(" %").next().unwrap().rsplit(' ').next().unwrap().parse().unwrap();
    assert!((30.0..60.0).contains(&per_cent), "{note}");
    let spiral = Stroke::Freehand { points: spiral, width: 6.0 };
    let told = notes(vec![Layer::new([spiral.clone()])]);
    // A spiral whose windings are apart is read as an open path, or as an outline with a note.
    let is_open = matches!(&spiral, Stroke::Freehand { points, .. } if matches!(recognise(points, 6.0), Some(Mark::Path(_))));
    assert!(is_open || told.len() == 1, "{told:?}");
}

#[test]
fn spots_narrower_than_any_that_grow_are_told_together() {
    let spot = |x: f64, minor: f64| Stroke::ellipse([x, 50.0], [40.0, minor], 90.0);
    let told = notes(vec![Layer::new([spot(50.0, 3.0), spot(150.0, 6.1), spot(250.0, 4.0)])]);
    let [note] = &told[..] else { panic!("{told:?}") };
    assert_eq!((note.layer, &note.strokes[..]), (Some(0), &[0, 2][..]));
    assert!(note.text.contains("0.07") && note.text.contains("0.15 times"), "{note}");
    assert!(notes(vec![Layer::new([spot(50.0, 6.0), spot(150.0, 39.0)])]).is_empty());
}

#[test]
fn crossings_are_told_with_their_places() {
    let eight = Stroke::path([[10.0, 10.0], [50.0, 50.0], [50.0, 10.0], [10.0, 50.0]], 5.0);
    let across = [
        Stroke::line([100.0, 100.0], [200.0, 100.0], 5.0),
        Stroke::line([150.0, 60.0], [150.0, 150.0], 5.0),
        Stroke::line([100.0, 200.0], [200.0, 200.0], 5.0),
    ];
    let stripes = |lines: &[Stroke]| Layer::new(lines.to_vec()).with_system(SystemChoice::Stripes);
    let told = notes(vec![Layer::new([eight]), stripes(&across)]);
    let [itself, each_other] = &told[..] else { panic!("{told:?}") };
    assert_eq!(
        (itself.layer, &itself.strokes[..], &itself.places[..]),
        (Some(0), &[0][..], &[[30.0, 30.0]][..])
    );
    assert_eq!((each_other.layer, &each_other.strokes[..]), (Some(1), &[0, 1][..]));
    assert_eq!(each_other.places, [[150.0, 100.0]]);
    assert!(
        each_other
            .to_string()
            .starts_with("layers[1].strokes[0, 1]: these lines cross each other at [150, 100]")
    );
    assert_eq!(each_other.remedies, [Remedy::CrossingLayer, Remedy::Weave]);
    assert!(notes(vec![Layer::new(across.clone())]).is_empty(), "they are a weave");
    let ring = Layer::new(across).with_after(After::Net);
    assert!(notes(vec![ring]).is_empty(), "only the width of a web is drawn");
}

/// Dots in rows, of the radius that `radius` says at each place.
fn dots(radius: impl Fn(usize, usize) -> f64) -> Layer {
    let at = |k: usize| (k % 6, k / 6);
    Layer::new((0..24).map(at).map(|(x, y)| {
        let center = [40.0 + 60.0 * x as f64, 40.0 + 60.0 * y as f64];
        Stroke::ellipse(center, [radius(x, y); 2], 0.0)
    }))
}

#[test]
fn two_sizes_among_each_other_are_told() {
    let is_large = |x: usize, y: usize| x % 3 == 1 && y.is_multiple_of(2);
    let told = notes(vec![dots(|x, y| if is_large(x, y) { 20.0 } else { 6.0 + 0.2 * x as f64 })]);
    let [note] = &told[..] else { panic!("{told:?}") };
    assert_eq!((&note.strokes[..], &note.remedies[..]), (&[1, 4, 13, 16][..], &[Remedy::TwoLayers][..]));
    assert!(note.text.contains("20 of about 133 px² and 4 of about 1257 px²"), "{note}");
}

#[test]
fn a_gradual_change_and_a_single_odd_spot_are_no_two_sizes() {
    assert!(notes(vec![dots(|x, _| 4.0 + 4.0 * x as f64)]).is_empty(), "from small to large");
    assert!(notes(vec![dots(|x, y| if (x, y) == (2, 1) { 24.0 } else { 6.0 })]).is_empty(), "a single one");
    assert!(notes(vec![dots(|x, _| if x < 3 { 6.0 } else { 20.0 })]).is_empty(), "two parts of the canvas");
    assert!(notes(vec![dots(|x, y| 6.0 + (x * y % 3) as f64)]).is_empty(), "a spread");
}
