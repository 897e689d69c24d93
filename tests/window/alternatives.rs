//! Other textures that fit the same sketch.

use dapple::WriteFile;
use std::sync::Arc;

use dapple::app::{Alternative, Start, Window, small};
use dapple::document::{Document, SpreadChoice};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand_with, with};

fn spots() -> (Hand, tempfile::TempDir) {
    let text = r#"{"format": "dapple", "version": 1, "size": [120, 120], "layers": [
        {"name": "spots", "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [12, 9], "angle": 20}]}]}"#;
    let (hand, folder, _) = hand_with(&Document::parse(text, "spots").unwrap());
    (hand, folder)
}

#[track_caller]
fn until_grown(hand: &mut Hand) {
    hand.until("alternatives", |window| {
        let all = &window.alternatives().all;
        !all.is_empty() && window.alternatives().is_complete()
    });
    hand.rest();
}

fn named<'a>(window: &'a Window, name: &str) -> &'a Alternative {
    window.alternatives().all.iter().find(|one| one.name == name).unwrap_or_else(|| panic!("no {name}"))
}

fn names(hand: &Hand) -> Vec<String> {
    hand.window.state().alternatives().all.iter().map(|one| one.name.clone()).collect()
}

#[test]
fn hidden_alternatives_are_not_grown() {
    let (mut hand, _folder) = spots();
    hand.until_settled();
    hand.rest();
    assert!(hand.window.state().alternatives().all.is_empty());
    assert!(!hand.window.state().alternatives().is_growing());
}

#[test]
fn alternatives_have_other_seeds_and_another_spread() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    until_grown(&mut hand);
    let all = names(&hand);
    assert_eq!(all, ["Original", "Seed 2", "Seed 3", "Seed 4", "Seed 5", "Varied"]);
    let window = hand.window.state();
    assert!(window.alternatives().all.iter().all(|one| one.failed.is_none() && one.picture.is_some()));
    assert!(matches!(named(window, "Varied").document.layers[0].options.spread, SpreadChoice::Given(_)));
    assert!(window.alternatives().is_taken(named(window, "Original").id));
    for (index, one) in window.alternatives().all.iter().enumerate() {
        for other in &window.alternatives().all[..index] {
            assert_ne!(one.picture.as_ref().unwrap().pixels, other.picture.as_ref().unwrap().pixels);
        }
    }
}

#[test]
fn a_chosen_alternative_grows_what_its_picture_showed() {
    for name in ["Seed 3", "Varied"] {
        let (mut hand, _folder) = spots();
        hand.key(Modifiers::NONE, Key::A);
        until_grown(&mut hand);
        let before = hand.document();
        let one = named(hand.window.state(), name);
        let (id, document, picture) = (one.id, one.document.clone(), one.picture.clone().unwrap());
        hand.press(&format!("Use {name}"));
        hand.until_settled();
        assert_eq!(hand.document(), document);
        let settled = hand.window.state().settled().unwrap().clone();
        assert_eq!(small(&settled.document, &settled.grown).pixels, picture.pixels, "{name}");
        assert!(hand.window.state().alternatives().is_taken(id));

        // A new growth gives the same texture.
        let shown = hand.window.state().growth().picture.as_ref().unwrap().image.clone();
        hand.press("Grow again");
        hand.until_settled();
        assert_eq!(shown.pixels, hand.window.state().growth().picture.as_ref().unwrap().image.pixels);

        hand.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(hand.document(), before);
    }
}

#[test]
fn choosing_an_alternative_keeps_the_others() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    until_grown(&mut hand);
    let before = names(&hand);
    hand.press("Use Seed 4");
    hand.until_settled();
    hand.rest();
    assert_eq!(names(&hand), before);
    assert!(hand.window.query_by_label("Use Seed 4, open now").is_some());
    hand.press("Use Original");
    hand.until_settled();
    assert_eq!(hand.document().seed, 1);
}

#[test]
fn another_sketch_has_other_alternatives_and_keeps_the_starred_ones() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    until_grown(&mut hand);
    hand.press("Star Seed 3");
    let kept = named(hand.window.state(), "Seed 3").document.clone();
    let picture = named(hand.window.state(), "Seed 3").picture.clone().unwrap();
    let before = hand.document();

    hand.draw_round([30.0, 30.0], [10.0, 10.0], 0.0);
    hand.until_settled();
    hand.until("begun anew", |window| {
        window.alternatives().all.iter().any(|one| !one.kept && one.document.layers[0].strokes.len() == 2)
    });
    until_grown(&mut hand);
    assert_eq!(hand.window.state().alternatives().all.iter().filter(|one| one.kept).count(), 1);
    assert_eq!(named(hand.window.state(), "Seed 3").document, kept);
    assert!(Arc::ptr_eq(&picture, named(hand.window.state(), "Seed 3").picture.as_ref().unwrap()));
    let drawn = hand.document();

    let id = hand.window.state().alternatives().all[0].id;
    let first = hand.window.query_all_by_label("Use Seed 3").next().unwrap();
    first.click();
    hand.rest();
    hand.until_settled();
    assert_eq!(Document { starred: Vec::new(), ..hand.document() }, kept);
    assert_eq!(hand.document().starred.len(), 1, "the star is kept with the document");
    assert_eq!(hand.document().layers[0].strokes, before.layers[0].strokes);
    assert!(hand.window.state().alternatives().is_taken(id));
    let settled = hand.window.state().settled().unwrap().clone();
    assert_eq!(small(&settled.document, &settled.grown).pixels, picture.pixels);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), drawn);
}

#[test]
fn alternatives_can_be_stopped_and_continued() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    hand.until("some growing", |window| window.alternatives().is_growing());
    hand.window.run_steps(2);
    hand.press("Stop the alternatives");
    assert!(!hand.window.state().alternatives().is_growing());
    let there = |hand: &Hand| {
        hand.window.state().alternatives().all.iter().filter(|one| one.picture.is_some()).count()
    };
    let before = there(&hand);
    hand.rest();
    assert_eq!(there(&hand), before);
    hand.press("Continue the alternatives");
    until_grown(&mut hand);
}

#[test]
fn hiding_the_alternatives_cancels_their_growth() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    hand.until("some growing", |window| window.alternatives().is_growing());
    hand.key(Modifiers::NONE, Key::A);
    assert!(!hand.window.state().alternatives().is_growing());
}

#[test]
fn an_alternative_is_chosen_and_starred_by_keys_alone() {
    let (mut hand, _folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    until_grown(&mut hand);
    hand.window.get_by_role_and_label(Role::Button, "Use Varied").focus();
    hand.rest();
    hand.key(Modifiers::NONE, Key::Tab);
    let star = hand.window.get_by_role_and_label(Role::Button, "Star Varied");
    assert!(star.accesskit_node().is_focused());
    hand.key(Modifiers::NONE, Key::Enter);
    assert!(named(hand.window.state(), "Varied").kept);
    hand.key(Modifiers::SHIFT, Key::Tab);
    hand.key(Modifiers::NONE, Key::Space);
    hand.until_settled();
    assert!(matches!(hand.document().layers[0].options.spread, SpreadChoice::Given(_)));
}

#[test]
fn stars_are_saved_with_the_document_and_undone() {
    let (mut hand, folder) = spots();
    hand.key(Modifiers::NONE, Key::A);
    until_grown(&mut hand);
    hand.press("Star Seed 3");
    let kept = named(hand.window.state(), "Seed 3").document.clone();
    assert_eq!(hand.document().starred[0].document, kept);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(hand.document().starred.is_empty() && !named(hand.window.state(), "Seed 3").kept);
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert!(named(hand.window.state(), "Seed 3").kept);
    let file = folder.path().join("starred.dapple");
    hand.document().write(&file).unwrap();
    drop(hand);

    let start = Start { file: Some(file), ..Start::default() };
    let mut again = with(start, vec2(1280.0, 800.0), Theme::Light);
    again.until_settled();
    again.key(Modifiers::NONE, Key::A);
    until_grown(&mut again);
    assert!(named(again.window.state(), "Seed 3").kept && !again.window.state().session().is_changed());
    again.press("Remove star from Seed 3");
    assert!(again.document().starred.is_empty() && again.window.state().session().is_changed());
}
