//! The panel of layers: every control, by pointer and by keys.

mod maps;
mod options;
mod points;
mod tone;

use dapple::app::Window;
use dapple::document::{After, Kind};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand};

/// A window with two layers: two ellipses, and above them a line, which is the active layer.
fn two() -> Hand {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[80.0, 80.0], [120.0, 104.0]]);
    hand.drag(&[[280.0, 280.0], [320.0, 304.0]]);
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[100.0, 400.0], [400.0, 400.0]]);
    hand.key(Modifiers::NONE, Key::Escape);
    hand
}

fn at_hand(hand: &Hand) -> usize {
    hand.window.state().session().active_layer
}

/// The accessible names of the rows, from the top.
fn rows(hand: &Hand) -> Vec<String> {
    let said = hand.window.query_all_by_role(Role::Button);
    let mut rows: Vec<(f32, String)> = said
        .filter_map(|node| Some((node.rect().top(), node.accesskit_node().label()?)))
        .filter(|(_, name)| name.starts_with("Layer "))
        .filter(|(_, name)| name.contains(','))
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    rows.into_iter().map(|(_, name)| name).collect()
}

fn kinds(hand: &Hand) -> Vec<bool> {
    let layers = hand.document().layers;
    layers.iter().map(|layer| layer.strokes[0].kind() == Some(Kind::Ellipse)).collect()
}

/// Chooses an entry of a drop-down list.
fn choose(hand: &mut Hand, list: &str, item: &str) {
    hand.click_role(Role::ComboBox, list);
    hand.rest();
    hand.press(item);
}

fn undo(hand: &mut Hand) {
    hand.key(Modifiers::COMMAND, Key::Z);
}

/// Presses Tab until this button has the focus.
fn tab_to(hand: &mut Hand, name: &str) {
    // After the pointer, Tab alone hides the panels.
    hand.key(Modifiers::SHIFT, Key::Tab);
    for _ in 0..80 {
        if hand.window.get_by_role_and_label(Role::Button, name).is_focused() {
            return;
        }
        hand.key(Modifiers::NONE, Key::Tab);
    }
    panic!("Tab does not come to {name}");
}

#[test]
fn the_rows_list_the_content_of_each_layer_the_highest_first() {
    let hand = two();
    assert_eq!(rows(&hand), ["Layer layer 2, 1 line", "Layer layer 1, 2 ellipses"]);
    assert_eq!(at_hand(&hand), 1);
}

#[test]
fn a_click_on_a_row_or_on_a_mark_activates_the_layer() {
    let mut hand = two();
    hand.press("Layer layer 1, 2 ellipses");
    assert_eq!(at_hand(&hand), 0);
    hand.key(Modifiers::NONE, Key::V);
    hand.click([250.0, 400.0]);
    assert_eq!(at_hand(&hand), 1);
    hand.click([100.0, 92.0]);
    assert_eq!(at_hand(&hand), 0);
}

#[test]
fn layers_are_added_duplicated_and_deleted_and_every_step_can_be_undone() {
    let mut hand = two();
    hand.press("New layer");
    assert_eq!(rows(&hand)[0], "Layer layer 3, empty");
    undo(&mut hand);
    assert_eq!(rows(&hand).len(), 2);
    hand.press("Layer layer 1, 2 ellipses");
    hand.press("Duplicate layer");
    assert_eq!(kinds(&hand), [true, true, false]);
    assert_eq!(at_hand(&hand), 1);
    hand.press("Delete layer");
    assert_eq!(kinds(&hand), [true, false]);
    undo(&mut hand);
    undo(&mut hand);
    assert_eq!(kinds(&hand), [true, false]);
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(kinds(&hand), [true, true, false]);
}

#[test]
fn an_empty_layer_is_not_saved() {
    let mut hand = two();
    let before = hand.document();
    hand.press("New layer");
    assert_eq!(hand.document(), before);
}

#[test]
fn layers_are_moved_by_buttons_and_by_dragging_their_rows() {
    let mut hand = two();
    hand.press("Lower layer");
    assert_eq!(kinds(&hand), [false, true]);
    assert_eq!(at_hand(&hand), 0);
    hand.press("Raise layer");
    assert_eq!(kinds(&hand), [true, false]);
    let [upper, lower] = ["Layer layer 2, 1 line", "Layer layer 1, 2 ellipses"]
        .map(|name| hand.window.get_by_role_and_label(Role::Button, name).rect().center());
    hand.window.drag_at(lower);
    hand.window.step();
    for share in [0.3, 0.6, 1.0, 1.3] {
        hand.window.hover_at(lower + (upper - lower) * share);
        hand.window.step();
    }
    hand.window.drop_at(lower + (upper - lower) * 1.3);
    hand.rest();
    assert_eq!(kinds(&hand), [false, true]);
    undo(&mut hand);
    assert_eq!(kinds(&hand), [true, false]);
}

#[test]
fn a_name_is_typed_in_place() {
    let mut hand = two();
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(egui::Event::Text("stripes".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.document().layers[1].name, "stripes");
    assert_eq!(rows(&hand)[0], "Layer stripes, 1 line");
    // Escape discards the change.
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(egui::Event::Text("other".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!(hand.document().layers[1].name, "stripes");
    undo(&mut hand);
    assert_eq!(hand.document().layers[1].name, "layer 2");
}

#[test]
fn a_double_click_on_a_row_names_it() {
    let mut hand = two();
    let row = hand.window.get_by_role_and_label(Role::Button, "Layer layer 1, 2 ellipses").rect().center();
    for _ in 0..2 {
        hand.window.drag_at(row);
        hand.window.step();
        hand.window.drop_at(row);
        hand.window.step();
    }
    hand.rest();
    hand.window.event(egui::Event::Text("spots".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.document().layers[0].name, "spots");
}

#[test]
fn a_hidden_layer_grows_but_cannot_be_edited() {
    let mut hand = two();
    hand.press("Hide layer 1");
    assert!(!hand.document().layers[0].visible);
    assert_eq!(rows(&hand)[1], "Layer layer 1, 2 ellipses, hidden");
    hand.key(Modifiers::COMMAND, Key::A);
    assert_eq!(hand.window.state().session().selection.len(), 1);
    hand.press("Show layer 1");
    assert!(hand.document().layers[0].visible);
    undo(&mut hand);
    assert!(!hand.document().layers[0].visible);
}

#[test]
fn a_frozen_layer_cannot_be_edited_until_its_snowflake_is_clicked() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[80.0, 80.0], [120.0, 104.0]]);
    hand.press("Freeze layer and start the next");
    assert_eq!(rows(&hand), ["Layer layer 2, empty", "Layer layer 1, 1 ellipse, frozen"]);
    hand.drag(&[[200.0, 200.0], [220.0, 214.0]]);
    assert_eq!(hand.document().layers.iter().map(|layer| layer.strokes.len()).collect::<Vec<_>>(), [1, 1]);
    // Neither the eraser nor *Select all* affects a frozen layer.
    hand.key(Modifiers::NONE, Key::X);
    hand.drag(&[[60.0, 92.0], [100.0, 92.0], [140.0, 92.0]]);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.ellipses().len(), 1);
    // A click on one of its marks or on its row only selects the layer.
    let state = |hand: &Hand| (at_hand(hand), hand.window.state().session().frozen());
    hand.key(Modifiers::NONE, Key::V);
    hand.click([100.0, 92.0]);
    assert_eq!(state(&hand), (0, 1));
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[300.0, 300.0], [320.0, 314.0]]);
    hand.key(Modifiers::SHIFT, Key::E);
    assert_eq!((hand.ellipses().len(), state(&hand)), (1, (0, 1)));
    assert!(hand.window.state().notices()[0].text.contains("frozen"));
    hand.key(Modifiers::NONE, Key::F);
    assert_eq!(state(&hand), (1, 1));
    hand.press("Layer layer 1, 1 ellipse, frozen");
    assert_eq!(state(&hand), (0, 1));
    hand.press("Unfreeze layer 1");
    assert_eq!(state(&hand), (0, 0));
    hand.drag(&[[300.0, 300.0], [320.0, 314.0]]);
    assert_eq!(hand.ellipses().len(), 2);
}

#[test]
fn layers_are_edited_by_keys_alone() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    hand.key(Modifiers::NONE, Key::F);
    hand.key(Modifiers::SHIFT, Key::L);
    assert_eq!(kinds(&hand), [true, false]);
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(egui::Event::Text("rings".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    // Tab reaches the row; then the keys move down and up, move the layer, and rename it.
    tab_to(&mut hand, "Layer rings, 1 line");
    hand.key(Modifiers::NONE, Key::ArrowDown);
    assert_eq!(at_hand(&hand), 0);
    hand.key(Modifiers::ALT, Key::ArrowUp);
    assert_eq!(kinds(&hand), [true, false], "it is frozen");
    tab_to(&mut hand, "Unfreeze layer 1");
    hand.key(Modifiers::NONE, Key::Enter);
    tab_to(&mut hand, "Layer layer 1, 1 ellipse");
    hand.key(Modifiers::ALT, Key::ArrowUp);
    assert_eq!(kinds(&hand), [false, true]);
    assert_eq!(at_hand(&hand), 1);
    hand.key(Modifiers::ALT, Key::ArrowDown);
    hand.key(Modifiers::NONE, Key::ArrowUp);
    assert_eq!((kinds(&hand), at_hand(&hand)), (vec![true, false], 1));
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(egui::Event::Text("rosettes".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.document().layers[1].name, "rosettes");
    assert!(hand.window.get_by_role_and_label(Role::Button, "Layer rosettes, 1 line").is_focused());
    // Then the details, which Space opens; then the picture for rings.
    for name in ["How it grows", "Grows: Around"] {
        tab_to(&mut hand, name);
        hand.key(Modifiers::NONE, Key::Space);
    }
    assert_eq!(hand.document().layers[1].after, After::Around);
    hand.key(Modifiers::COMMAND, Key::PageDown);
    assert_eq!(kinds(&hand), [false, true]);
    hand.key(Modifiers::COMMAND, Key::PageUp);
    hand.key(Modifiers::SHIFT, Key::H);
    assert!(!hand.document().layers[1].visible);
    hand.key(Modifiers::COMMAND, Key::J);
    assert_eq!(hand.document().layers[2].name, "rosettes copy");
    hand.key(Modifiers::NONE, Key::PageDown);
    assert_eq!(at_hand(&hand), 1);
}

#[test]
fn layers_beneath_are_not_grown_again_and_are_shown_under_the_canvas() {
    let mut hand = hand();
    hand.draw_round([60.0, 60.0], [14.0, 9.0], 20.0);
    hand.draw_round([100.0, 90.0], [13.0, 9.0], 25.0);
    hand.until_settled();
    let below =
        hand.window.state().settled().unwrap().grown.layers[0].marks().expect("marks").marks.values.clone();
    hand.key(Modifiers::NONE, Key::F);
    hand.until("the picture of the frozen layer", Window::has_underlay);
    // The lowest layer is reused, so the first layer that grows is the second one.
    hand.draw_round([300.0, 300.0], [9.0, 6.0], 100.0);
    hand.until_settled();
    let grown = &hand.window.state().settled().unwrap().grown;
    assert_eq!(grown.layers.len(), 2);
    assert_eq!(grown.layers[0].marks().expect("marks").marks.values, below);
    assert_eq!(hand.window.state().growth().reused, 1);
    hand.until("the picture of the frozen layer", Window::has_underlay);
    // When the layer is unfrozen, nothing is shown under it any more.
    hand.press("Unfreeze layer 1");
    assert!(!hand.window.state().has_underlay());
}

#[test]
fn an_ellipse_on_a_layer_of_rings_asks_before_it_gets_another_layer() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::NONE, Key::F);
    hand.press("How it grows");
    hand.press("Grows: Around");
    hand.draw_round([350.0, 200.0], [40.0, 20.0], 30.0);
    assert!(hand.window.query_by_label("Draw it on another layer?").is_some());
    hand.press("Cancel");
    assert_eq!(hand.ellipses().len(), 1);
    hand.draw_round([350.0, 200.0], [40.0, 20.0], 30.0);
    hand.press("Other layer");
    assert_eq!(hand.ellipses().len(), 2);
}

#[test]
fn a_new_layer_for_another_kind_of_mark_is_reported() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.drag(&[[100.0, 300.0], [200.0, 310.0], [300.0, 320.0]]);
    assert!(hand.window.state().notices()[0].text.contains("on a new layer"));
}

#[test]
fn renaming_a_layer_grows_nothing() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.until_settled();
    let before = hand.window.state().growth().generation();
    hand.key(Modifiers::NONE, Key::F2);
    hand.window.event(egui::Event::Text("spots".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.document().layers[0].name, "spots");
    assert_eq!(hand.window.state().growth().generation(), before);
    assert!(hand.window.state().settled().is_some());
}
