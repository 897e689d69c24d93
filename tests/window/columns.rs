//! The columns beside the sketch keep their sizes and places; only the user resizes and hides them.

use dapple::ReadFile;
use dapple::app::{Settings, Start};
use dapple::document::Document;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand, hand_with, with};

fn rect(hand: &Hand, name: &str) -> Rect {
    hand.window.get_by_label(name).rect()
}

#[test]
fn nothing_moves_while_the_pointer_crosses_regions() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/turning-spots.dapple");
    let (mut hand, ..) = hand_with(&Document::read(file).unwrap());
    hand.until_settled();
    for tab in ["Draw", "Canvas", "Colour", "Result"] {
        hand.press(tab);
        hand.rest();
        let names = ["Draw", "Result", "Layers", "Sketch"];
        let before = (hand.canvas(), hand.window.state().views(), names.map(|name| rect(&hand, name)));
        for place in [[60.0, 60.0], [400.0, 60.0], [60.0, 400.0], [400.0, 400.0], [250.0, 250.0]] {
            let at = hand.at(place);
            hand.window.hover_at(at);
            hand.rest();
            let now = (hand.canvas(), hand.window.state().views(), names.map(|name| rect(&hand, name)));
            assert_eq!(now, before, "{tab}: {place:?}");
        }
    }
}

#[test]
fn settings_of_the_canvas_keep_their_places_while_marks_are_drawn_and_selected() {
    let mut hand = hand();
    hand.press("Canvas");
    let names = ["Canvas regions", "Seamless", "Link both views"];
    let role = |hand: &Hand, name| hand.window.get_by_role_and_label(Role::CheckBox, name).rect();
    let before = names.map(|name| role(&hand, name));
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.until_settled();
    hand.key(Modifiers::NONE, Key::Escape);
    let at = hand.at([150.0, 200.0]);
    hand.window.hover_at(at);
    hand.rest();
    assert_eq!(names.map(|name| role(&hand, name)), before);
}

#[test]
fn the_right_column_is_resized_hidden_and_remembered() {
    let folder = tempfile::tempdir().unwrap();
    let start = || Start { settings: Settings::read(&folder.path().join("settings")), ..Start::default() };
    let mut hand = with(start(), vec2(1280.0, 800.0), Theme::Light);
    let before = hand.canvas().width();
    let edge = egui::pos2(1280.0 - 264.0 + 3.0, 300.0);
    hand.window.hover_at(edge);
    hand.window.step();
    hand.window.drag_at(edge);
    for x in [20.0, 60.0, 100.0] {
        hand.window.hover_at(edge - vec2(x, 0.0));
        hand.window.step();
    }
    hand.window.drop_at(edge - vec2(100.0, 0.0));
    hand.rest();
    assert!((hand.canvas().width() - before + 50.0).abs() < 2.0, "{} {before}", hand.canvas().width());
    hand.key(Modifiers::NONE, Key::F9);
    assert!(hand.window.query_by_label("Layers").is_none());
    assert!((hand.canvas().width() - before - 132.0).abs() < 2.0, "{} {before}", hand.canvas().width());
    hand.window.state_mut().leave();

    let mut again = with(start(), vec2(1280.0, 800.0), Theme::Light);
    assert!(again.window.query_by_label("Layers").is_none());
    again.key(Modifiers::NONE, Key::F9);
    assert!((again.canvas().width() - before + 50.0).abs() < 2.0, "{}", again.canvas().width());
}

#[test]
fn nothing_overlaps_in_a_small_window() {
    let mut hand = with(Start::default(), vec2(800.0, 600.0), Theme::Light);
    hand.draw_round([150.0, 200.0], [60.0, 40.0], 30.0);
    hand.until_settled();
    for tab in ["Draw", "Canvas", "Colour", "Result"] {
        hand.press(tab);
        let column = rect(&hand, "Layers").left();
        for name in ["Another seed", "Alternatives", "Seed", "Pause or grow"] {
            if let Some(found) = hand.window.query_by_label(name) {
                assert!(found.rect().right() < column, "{tab}: {name} {:?}", found.rect());
            }
        }
        let [sketch, texture] =
            ["Fit", "Texture"].map(|name| hand.window.query_by_label(name).map(|one| one.rect()));
        if let (Some(sketch), Some(texture)) = (sketch, texture) {
            assert!(!sketch.intersects(texture), "{sketch:?} {texture:?}");
        }
    }
}

/// The controls that overlap: their names.
fn overlapping(hand: &Hand) -> Vec<(String, String)> {
    let roles = [Role::Button, Role::SpinButton, Role::CheckBox, Role::Slider];
    let nodes = roles.into_iter().flat_map(|role| hand.window.query_all_by_role(role));
    let all: Vec<(String, Rect)> = nodes
        .map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()))
        .filter(|(_, rect)| rect.is_positive())
        .collect();
    let mut found = Vec::new();
    for (index, (name, rect)) in all.iter().enumerate() {
        for (other, second) in &all[index + 1..] {
            // The row of a layer holds its eye and its snowflake.
            if name.starts_with("Layer ") && rect.contains_rect(*second) {
                continue;
            }
            let both = rect.intersect(*second);
            if both.width() > 1.0 && both.height() > 1.0 {
                found.push((name.clone(), other.clone()));
            }
        }
    }
    found
}

#[test]
fn no_controls_overlap_in_a_window_of_640_by_400_points() {
    let start = Start { settings: Settings::default(), ..Start::default() };
    let mut hand = with(start, vec2(640.0, 400.0), Theme::Light);
    assert_eq!(overlapping(&hand), [], "an empty canvas");
    hand.press("Spots");
    hand.until_settled();
    assert_eq!(overlapping(&hand), [], "a texture");
    hand.press("Panels");
    hand.press("Draw");
    assert_eq!(overlapping(&hand), [], "the column");
}
