//! What panels, signs and the status line say is true at a glance.

use dapple::app::Verdict;
use dapple::document::{Document, DutyChoice};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, hand_with};

fn told(hand: &Hand, text: &str) -> bool {
    hand.window.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn a_region_in_which_a_mark_does_not_grow_gets_no_tick() {
    let text = r#"{"format": "dapple", "version": 2, "size": [220, 160], "layers": [{"name": "a", "system":
        "meinhardt-spots", "strokes": [
        {"kind": "ellipse", "center": [60, 60], "radii": [10, 10]}, {"kind": "ellipse", "center": [64, 60], "radii": [10, 10]},
        {"kind": "ellipse", "center": [150, 100], "radii": [10, 10]}]}]}"#;
    let (mut hand, ..) = hand_with(&Document::parse(text, "overlapping").unwrap());
    hand.until_settled();
    hand.until("measured", |window| window.results().for_texture(window.settled()).is_some());
    let outcome = hand.window.state().results().outcome().unwrap();
    assert!(outcome.layers[0].lost() > 0, "one of the overlapping marks does not grow");
    assert_eq!(outcome.layers[0].regions[0].verdict, Verdict::Missed);
}

#[test]
fn closed_strokes_are_called_what_they_become() {
    let mut hand = hand();
    assert!(told(&hand, "a closed stroke becomes an ellipse"));
    hand.press("Ellipse");
    for left in [60.0, 182.0, 304.0] {
        hand.drag(&[[left, 100.0], [left + 50.0, 140.0], [left + 100.0, 180.0]]);
    }
    hand.press("Grow cells");
    assert!(told(&hand, "3 cells"));
    // The mark that was drawn last is selected.
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(told(&hand, "It becomes a cell"));
    hand.key(Modifiers::NONE, Key::B);
    assert!(told(&hand, "a closed stroke becomes a cell"));
    assert!(told(&hand, "A closed stroke becomes a cell on this layer"));
    hand.key(Modifiers::NONE, Key::V);
    hand.click([110.0, 140.0]);
    assert!(hand.window.query_by_label("Cell").is_some(), "the selected mark");
}

#[test]
fn the_period_of_lines_is_the_one_that_counts() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    for y in [100.0, 120.0, 140.0] {
        hand.drag(&[[100.0, y], [200.0, y], [300.0, y]]);
    }
    hand.key(Modifiers::COMMAND, Key::A);
    assert!(told(&hand, "Line spacing"));
    let mut document = hand.document();
    document.layers[0].options.duty = DutyChoice::Given(0.3);
    let (mut hand, ..) = hand_with(&document);
    hand.key(Modifiers::COMMAND, Key::A);
    assert!(!told(&hand, "Line spacing"), "it no longer sets the period");
    assert!(hand.window.query_all_by_label_contains("20").next().is_some(), "6 px ÷ 0.3");
}
