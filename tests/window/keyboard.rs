//! The window can be used without a pointer.

use egui::{Event, Key, Modifiers, PointerButton};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand};

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
    hand.key(Modifiers::COMMAND, Key::OpenBracket);
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
    hand.press("Centre x");
    let before = hand.document();
    hand.key(Modifiers::NONE, Key::X);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.document(), before);
}

#[test]
fn escape_closes_a_page() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::F1);
    assert!(hand.window.query_by_label("Copy a mark").is_some());
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label("Copy a mark").is_none());
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

/// Whether an entry of a menu has the keyboard focus.
fn is_focused(hand: &Hand, name: &str) -> bool {
    let found = hand.window.query_all_by_label_contains(name).find(|node| node.accesskit_node().is_focused());
    found.is_some()
}

#[test]
fn menus_are_opened_and_navigated_by_keys() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.key(Modifiers::ALT, Key::F);
    assert!(is_focused(&hand, "New…"));
    assert_eq!(hand.document().layers.len(), 1, "Alt and F freezes nothing");
    assert_eq!(hand.window.state().session().frozen(), 0);
    hand.key(Modifiers::NONE, Key::ArrowDown);
    assert!(is_focused(&hand, "Open…"));
    hand.key(Modifiers::NONE, Key::ArrowUp);
    hand.key(Modifiers::NONE, Key::ArrowUp);
    assert!(is_focused(&hand, "Quit"));
    hand.key(Modifiers::NONE, Key::ArrowRight);
    assert!(is_focused(&hand, "Undo"));
    assert_eq!(hand.ellipses()[0].center, [256.0, 256.0], "arrows move no marks");
    hand.key(Modifiers::NONE, Key::Enter);
    assert!(hand.strokes().is_empty());
    assert!(hand.window.query_by_label_contains("Select all").is_none(), "the menu is closed");
    hand.key(Modifiers::NONE, Key::F10);
    assert!(is_focused(&hand, "New…"));
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label_contains("Import SVG").is_none());
}

#[test]
fn the_menu_of_marks_is_opened_by_key_and_by_the_secondary_button() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.key(Modifiers::SHIFT, Key::F10);
    assert!(is_focused(&hand, "Cut"));
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!(hand.window.state().session().selection.len(), 0);
    let at = hand.at([256.0, 256.0]);
    hand.window.hover_at(at);
    let button = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Secondary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    hand.window.input_mut().events.extend([button(true), button(false)]);
    hand.rest();
    assert_eq!(hand.window.state().session().selection.len(), 1, "the mark under the pointer");
    hand.press("Delete");
    assert!(hand.strokes().is_empty());
}

#[test]
fn bracket_keys_change_the_width_of_lines_and_of_the_pen() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::CloseBracket);
    hand.drag(&[[100.0, 100.0], [200.0, 150.0], [300.0, 200.0]]);
    assert!((hand.lines()[0].width - 6.6).abs() < 1e-9);
    hand.key(Modifiers::NONE, Key::OpenBracket);
    assert!((hand.lines()[0].width - 6.0).abs() < 1e-9);
}

#[test]
fn undo_in_a_text_field_only_undoes_typing() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(Event::Text("spots".to_owned()));
    hand.window.step();
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.ellipses().len(), 1);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(hand.ellipses().is_empty());
}

#[test]
fn escape_closes_the_panel_of_alternatives() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::A);
    assert!(hand.window.query_by_label("Hide").is_some());
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label("Hide").is_none());
}
