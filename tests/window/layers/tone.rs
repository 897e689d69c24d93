//! A picture that drives a layer: it is dropped or chosen, and its rows change settings.

use std::path::{Path, PathBuf};

use dapple::document::systems::TURING_GROWTH;
use dapple::document::{Document, Layer, SystemChoice};
use dapple::tone::{Drives, Tone};
use egui::accesskit::Role;
use egui::vec2;
use egui_kittest::kittest::{NodeT, Queryable};

use crate::documents::drop_file;
use crate::hand::{Hand, hand};
use crate::layers::undo;

/// A picture of 64 × 48 px: a bright ball on a dark ground.
fn ball(folder: &Path) -> PathBuf {
    let path = folder.join("ball.png");
    let light = |x: u32, y: u32| {
        let away = (f64::from(x) - 32.0).hypot(f64::from(y) - 24.0) / 20.0;
        if away < 1.0 { 255.0 * (1.0 - away * away).sqrt() } else { 40.0 }
    };
    image::GrayImage::from_fn(64, 48, |x, y| image::Luma([light(x, y) as u8])).save(&path).unwrap();
    path
}

/// A window with a new document that a dropped picture drives, with its rows unfolded.
fn driven(folder: &Path) -> Hand {
    let mut hand = hand();
    drop_file(&mut hand, &ball(folder));
    hand.press("Tone");
    hand.press("How it grows");
    hand
}

fn layer(hand: &Hand) -> Layer {
    hand.document().layers[0].clone()
}

fn tone(hand: &Hand) -> Tone {
    layer(hand).tone.expect("a tone")
}

fn scroll_to(hand: &mut Hand, role: Role, name: &str) {
    hand.window.get_by_role_and_label(role, name).scroll_to_me();
    hand.window.run_steps(60);
}

fn set(hand: &mut Hand, name: &str, text: &str) {
    scroll_to(hand, Role::SpinButton, name);
    hand.type_into(name, text);
}

/// Drags the slider of the sketch's weight to its right end.
fn slide_to_the_end(hand: &mut Hand) {
    scroll_to(hand, Role::Slider, "Sketch");
    let rect = hand.window.get_by_role_and_label(Role::Slider, "Sketch").rect();
    let from = rect.left_center() + vec2(4.0, 0.0);
    hand.window.hover_at(from);
    hand.window.step();
    hand.window.drag_at(from);
    hand.window.step();
    for step in 1..=4 {
        hand.window.hover_at(from + vec2(100.0 * step as f32, 0.0));
        hand.window.step();
    }
    hand.window.drop_at(from + vec2(400.0, 0.0));
    hand.rest();
}

#[test]
fn a_dropped_picture_drives_an_empty_document_and_can_be_undone() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &ball(folder.path()));
    hand.press("Tone");
    assert_eq!(tone(&hand), Tone::new(tone(&hand).image));
    assert_eq!(tone(&hand).image.size(), [64, 48]);
    assert!(hand.strokes().is_empty() && layer(&hand).colours.is_some(), "ink on paper");
    assert!(hand.window.query_by_label("Layer layer 1, a picture").is_some());
    hand.until_settled();
    hand.document().check("what was dropped").unwrap();
    undo(&mut hand);
    assert!(hand.document().layers.is_empty());
}

#[test]
fn a_dropped_picture_drives_the_lowest_layer_and_its_marks_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [20.0, 20.0], 0.0);
    let drawn = hand.strokes();
    drop_file(&mut hand, &ball(folder.path()));
    hand.press("Tone");
    assert_eq!((hand.strokes(), tone(&hand).image.size()), (drawn, [64, 48]));
    undo(&mut hand);
    assert!(layer(&hand).tone.is_none());
}

#[test]
fn every_row_of_a_tone_sets_its_value() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = driven(folder.path());
    set(&mut hand, "Ink at white", "20");
    set(&mut hand, "Ink at black", "70");
    assert_eq!(tone(&hand).range, [0.2, 0.7]);
    hand.reach("Ink: default");
    assert_eq!(tone(&hand).range, Tone::RANGE);
    slide_to_the_end(&mut hand);
    assert_eq!(tone(&hand).sketch, 10.0);
    hand.reach("Sketch: default");
    assert_eq!(tone(&hand).sketch, Tone::SKETCH);
    scroll_to(&mut hand, Role::CheckBox, "Equalise");
    hand.press("Equalise");
    assert!(!tone(&hand).equalise);
    hand.document().check("what was chosen").unwrap();
    assert_eq!(Document::parse(&hand.document().to_json(), "written").unwrap(), hand.document());
}

#[test]
fn the_attributes_that_follow_the_picture_are_ticked_and_at_least_one_is() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = driven(folder.path());
    for name in ["Ink", "Direction"] {
        let name = format!("{name} follows the picture");
        scroll_to(&mut hand, Role::CheckBox, &name);
        hand.press(&name);
    }
    assert_eq!(tone(&hand).drives, Drives { level: false, direction: false, spacing: true });
    assert!(hand.window.query_by_role_and_label(Role::Slider, "Sketch").is_none(), "nothing turns");
    let last = hand.window.get_by_role_and_label(Role::CheckBox, "Spacing follows the picture");
    assert!(last.accesskit_node().is_disabled());
    hand.reach("Follows: default");
    assert_eq!(tone(&hand).drives, Drives::default());
}

#[test]
fn a_picture_is_chosen_replaced_and_removed() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [20.0, 20.0], 0.0);
    hand.press("How it grows");
    hand.reach("Picture of the tone");
    hand.type_into("File", ball(folder.path()).to_str().unwrap());
    hand.rest();
    assert_eq!(tone(&hand).image.size(), [64, 48]);
    set(&mut hand, "Ink at white", "20");
    let other = folder.path().join("other.png");
    image::GrayImage::from_fn(8, 8, |x, _| image::Luma([32 * x as u8])).save(&other).unwrap();
    hand.reach("Picture of the tone");
    hand.type_into("File", other.to_str().unwrap());
    hand.rest();
    assert_eq!((tone(&hand).image.size(), tone(&hand).range), ([8, 8], [0.2, 0.9]), "its settings stay");
    hand.reach("Tone: default");
    assert!(layer(&hand).tone.is_none());
    assert_eq!(hand.strokes().len(), 1);
}

#[test]
fn turings_growth_is_chosen_for_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = driven(folder.path());
    hand.click_role(Role::ComboBox, "System");
    hand.rest();
    // The last entry of the list, which is below its visible part.
    hand.reach("Turing's growth");
    assert_eq!(layer(&hand).system, SystemChoice::Of(TURING_GROWTH));
    assert!(layer(&hand).tone.is_some());
    hand.until_settled();
}
