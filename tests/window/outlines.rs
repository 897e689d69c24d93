//! Outlines of patches in the window: they are opened, moved, grown and saved with their own shapes.

use super::hand::{Hand, hand_with};
use dapple::ReadFile;
use dapple::document::{Document, Layer, Stroke};
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;

/// A patch with a dent, so that it is not convex.
const DENTED: [[f64; 2]; 6] =
    [[60.0, 60.0], [150.0, 50.0], [160.0, 130.0], [110.0, 90.0], [100.0, 140.0], [50.0, 120.0]];

fn opened() -> (Hand, tempfile::TempDir, std::path::PathBuf) {
    let far = DENTED.map(|[x, y]| [x + 160.0, y + 60.0]);
    let layer = Layer::new([Stroke::outline(DENTED), Stroke::outline(far)]).with_name("patches");
    hand_with(&Document::new([400, 300]).with_layer(layer))
}

fn corners(stroke: &Stroke) -> &[[f64; 2]] {
    if let Stroke::Outline(outline) = stroke { &outline.points } else { panic!("{stroke:?}") }
}

#[test]
fn an_outline_is_moved_scaled_copied_and_deleted_as_it_was_drawn() {
    let (mut hand, _folder, path) = opened();
    hand.key(Modifiers::NONE, Key::V);
    hand.click([100.0, 80.0]);
    hand.key(Modifiers::NONE, Key::ArrowRight);
    let moved = hand.strokes();
    let by = corners(&moved[0])[0][0] - DENTED[0][0];
    assert!(by > 0.0, "{by}");
    for (corner, drawn) in corners(&moved[0]).iter().zip(DENTED) {
        assert!((corner[0] - drawn[0] - by).abs() < 1e-6 && (corner[1] - drawn[1]).abs() < 1e-6);
    }
    let text = hand.window.state().session().copy().unwrap();
    let at = hand.at([300.0, 220.0]);
    hand.window.hover_at(at);
    hand.window.event(Event::Paste(text));
    hand.rest();
    let pasted = hand.strokes();
    assert_eq!(pasted.len(), 3);
    let side = |stroke: &Stroke| corners(stroke)[1][0] - corners(stroke)[0][0];
    assert!((side(&pasted[2]) - 90.0).abs() < 1e-6);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.strokes(), moved);
    hand.key(Modifiers::COMMAND, Key::S);
    assert_eq!(Document::read(&path).unwrap(), hand.document());
}

#[test]
fn a_document_of_outlines_grows_in_the_window() {
    let (mut hand, _folder, _path) = opened();
    let before = hand.document();
    hand.until_settled();
    hand.until("the result", |window| window.results().outcome().is_some());
    assert_eq!(hand.document(), before);
}

/// A star-shaped path of 40 px about a centre, as the pen draws it.
fn star([x, y]: [f64; 2]) -> Vec<[f64; 2]> {
    let turns = (0..=200).map(|k| f64::from(k) / 200.0 * std::f64::consts::TAU);
    turns
        .map(|turn| (40.0 * (1.0 + 0.3 * (5.0 * turn).cos()), turn.sin_cos()))
        .map(|(radius, (s, c))| [x + radius * c, y + radius * s])
        .collect()
}

#[test]
fn a_closed_stroke_on_a_layer_of_patches_stays_the_outline_that_was_drawn() {
    let (mut hand, _folder, path) = opened();
    hand.key(Modifiers::NONE, Key::B);
    let drawn = star([200.0, 60.0]);
    hand.drag(&drawn);
    let strokes = hand.strokes();
    assert_eq!(strokes.len(), 3);
    let found = corners(&strokes[2]);
    assert!(found.len() > 40, "{}", found.len());
    let apart = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    for corner in found {
        let nearest = drawn.iter().map(|at| apart(at, corner)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 2.0, "{corner:?} is {nearest} px from what was drawn");
    }
    for at in &drawn {
        let nearest = found.iter().map(|corner| apart(at, corner)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 6.0, "{at:?} is {nearest} px from what is kept");
    }
    assert!(hand.window.query_all_by_label_contains("is read as an ellipse").next().is_none());
    hand.key(Modifiers::COMMAND, Key::S);
    assert_eq!(Document::read(&path).unwrap(), hand.document());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.strokes(), strokes[..2]);
}

#[test]
fn a_closed_stroke_on_a_layer_of_spots_is_an_ellipse_that_keeps_its_outline_for_patches() {
    let layer = Layer::new([Stroke::ellipse([60.0, 60.0], [20.0, 15.0], 0.0)]);
    let (mut hand, _folder, path) = hand_with(&Document::new([400, 300]).with_layer(layer));
    hand.key(Modifiers::NONE, Key::B);
    hand.drag(&star([200.0, 160.0]));
    let strokes = hand.strokes();
    let Stroke::Fitted { outline, .. } = &strokes[1] else { panic!("{strokes:?}") };
    let far = outline.points.iter().map(|[x, y]| (x - 200.0).hypot(y - 160.0)).fold(0.0, f64::max);
    assert!((far - 52.0).abs() < 3.0, "the rays of the star are {far} px long");
    hand.key(Modifiers::COMMAND, Key::S);
    assert_eq!(Document::read(&path).unwrap(), hand.document());
}

#[test]
fn a_stroke_over_the_border_stays_where_it_was_drawn_and_is_dragged_farther() {
    let layer = Layer::new([Stroke::ellipse([60.0, 60.0], [20.0, 15.0], 0.0)]);
    let (mut hand, _folder, path) = hand_with(&Document::new([400, 300]).with_layer(layer));
    hand.key(Modifiers::NONE, Key::B);
    // The stroke begins on the canvas.
    hand.draw_round([405.0, 200.0], [30.0, 20.0], 180.0);
    let center = |hand: &Hand| hand.ellipses()[1].center;
    let [x, y] = center(&hand);
    assert!((x - 405.0).abs() < 1.0 && (y - 200.0).abs() < 1.0, "{x} {y}");
    hand.key(Modifiers::NONE, Key::V);
    hand.drag(&[[390.0, 200.0], [395.0, 190.0], [400.0, 180.0]]);
    let moved = center(&hand);
    assert!((moved[0] - x - 10.0).abs() < 0.5 && (moved[1] - y + 20.0).abs() < 0.5, "{moved:?}");
    hand.key(Modifiers::COMMAND, Key::S);
    assert_eq!(Document::read(&path).unwrap(), hand.document());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(center(&hand), [x, y]);
}
