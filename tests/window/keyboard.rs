//! The window can be used without a pointer.

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::hand::hand;

#[test]
fn a_sketch_is_made_by_keys_alone() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.key(Modifiers::SHIFT, Key::ArrowLeft);
    hand.key(Modifiers::NONE, Key::ArrowUp);
    hand.key(Modifiers::NONE, Key::Period);
    hand.key(Modifiers::NONE, Key::Plus);
    let [ellipse] = hand.ellipses()[..] else { panic!() };
    assert_eq!(ellipse.center, [246.0, 255.0]);
    assert_eq!(ellipse.angle, 5.0);
    assert!((ellipse.radii[0] - 9.8 * 1.1).abs() < 1e-9);

    hand.key(Modifiers::SHIFT, Key::E);
    hand.key(Modifiers::NONE, Key::OpenBracket);
    hand.key(Modifiers::NONE, Key::Delete);
    let [left] = hand.ellipses()[..] else { panic!() };
    assert_eq!(left.center, [256.0, 256.0]);
    hand.key(Modifiers::SHIFT, Key::L);
    assert_eq!(hand.lines().len(), 1);
}

#[test]
fn letters_typed_into_a_field_select_no_tool() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.press("Middle x");
    let before = hand.document();
    hand.key(Modifiers::NONE, Key::X);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.document(), before);
}

#[test]
fn escape_closes_a_page() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::F1);
    assert!(hand.window.query_by_label("Keys").is_some());
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label("Keys").is_none());
    hand.key(Modifiers::COMMAND, Key::N);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label("Create").is_none());
}

#[test]
fn escape_closes_a_menu_and_keeps_the_selection() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.press("Edit");
    assert!(hand.window.query_by_label_contains("Select all").is_some());
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label_contains("Select all").is_none());
    assert_eq!(hand.window.state().session().selection.len(), 1);
}
