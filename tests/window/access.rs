//! Screen readers: every control has a name.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand};

const CONTROLS: [Role; 6] =
    [Role::Button, Role::CheckBox, Role::SpinButton, Role::Slider, Role::TextInput, Role::RadioButton];

#[track_caller]
fn all_are_named(hand: &Hand, page: &str) {
    let mut controls = 0;
    for role in CONTROLS {
        for node in hand.window.query_all_by_role(role) {
            let node = node.accesskit_node();
            let name = node.label().or_else(|| node.labelled_by().next()?.value()).unwrap_or_default();
            assert!(!name.trim().is_empty(), "{page}: a {role:?} at {:?} has no name", node.bounding_box());
            controls += 1;
        }
    }
    assert!(controls > 20, "{page}: only {controls} controls");
}

#[test]
fn every_control_has_a_name() {
    let mut hand = hand();
    all_are_named(&hand, "an empty document");
    hand.key(Modifiers::SHIFT, Key::L);
    all_are_named(&hand, "a line");
    hand.key(Modifiers::SHIFT, Key::E);
    all_are_named(&hand, "an ellipse");
    hand.key(Modifiers::COMMAND, Key::A);
    all_are_named(&hand, "many marks");
    hand.key(Modifiers::COMMAND, Key::N);
    all_are_named(&hand, "a new document");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND, Key::O);
    all_are_named(&hand, "opening");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    all_are_named(&hand, "examples");
}

#[test]
fn the_accessible_name_of_the_canvas_lists_its_marks() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    assert!(hand.window.query_by_label("Sketch canvas, 1 mark").is_some());
    assert!(hand.window.query_by_label("Texture, growing").is_some());
}

#[test]
fn the_canvas_is_reached_by_tab_and_moves_marks_by_arrows() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    let canvas = hand.window.get_by_role(Role::Canvas);
    canvas.focus();
    hand.rest();
    hand.key(Modifiers::NONE, Key::ArrowDown);
    assert_eq!(hand.ellipses()[0].center, [256.0, 257.0]);
    hand.key(Modifiers::NONE, Key::Tab);
    assert!(!hand.window.get_by_role(Role::Canvas).is_focused(), "Tab leaves the canvas");
}
