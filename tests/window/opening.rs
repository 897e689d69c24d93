//! What is opened and saved by the file dialog: nothing is replaced that was not asked about.

use std::fs;
use std::path::PathBuf;

use dapple::ReadFile;
use dapple::app::{Start, Window};
use dapple::document::Document;
use egui::{Event, Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, with};

/// A picture without a document.
fn photograph() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/examples/zebra.png")
}

fn drawn() -> Hand {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand
}

#[test]
fn typing_replaces_the_name_that_is_proposed_and_keeps_its_ending() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = drawn();
    hand.key(Modifiers::COMMAND, Key::S);
    let typed = folder.path().join("mine");
    hand.window.event(Event::Text(typed.to_str().unwrap().to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(Document::read(typed.with_extension("dapple")).unwrap(), hand.document());
}

#[test]
fn a_document_that_is_saved_as_a_picture_gets_its_own_ending_and_is_listed_when_opening() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("x.png");
    fs::copy(photograph(), &picture).unwrap();
    let before = fs::read(&picture).unwrap();
    let mut hand = drawn();
    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_path("File", &picture);
    assert_eq!(fs::read(&picture).unwrap(), before, "the picture stays");
    let saved = folder.path().join("x.png.dapple");
    assert_eq!(Document::read(&saved).unwrap(), hand.document());
    hand.key(Modifiers::COMMAND, Key::O);
    assert!(hand.window.query_all_by_label("x.png.dapple").next().is_some(), "what was saved is listed");
}

#[test]
fn a_name_with_a_point_is_no_ending_and_an_existing_file_is_asked_about() {
    let folder = tempfile::tempdir().unwrap();
    let there = folder.path().join("cat v1.2.dapple");
    fs::write(&there, "mine").unwrap();
    let mut hand = drawn();
    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_path("File", &folder.path().join("cat v1.2"));
    assert!(hand.window.query_by_label_contains("already exists").is_some());
    assert_eq!(fs::read_to_string(&there).unwrap(), "mine");
    hand.press("Replace");
    assert_eq!(Document::read(&there).unwrap(), hand.document());
}

#[test]
fn a_picture_named_on_the_command_line_is_asked_about_as_if_it_were_dropped() {
    let start = Start { file: Some(photograph()), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    assert!(hand.window.query_by_label("What is zebra.png for?").is_some());
    hand.press("Reference picture");
    hand.until("the picture", Window::has_reference);
}

#[test]
fn a_picture_that_is_opened_is_asked_about_and_unsaved_work_stays_where_it_is_drawn_over() {
    let mut hand = drawn();
    let mine = hand.document();
    hand.key(Modifiers::COMMAND, Key::O);
    hand.type_path("File", &photograph());
    assert!(hand.window.query_by_label("What is zebra.png for?").is_some());
    hand.press("Reference picture");
    hand.until("the picture", Window::has_reference);
    assert_eq!(hand.document(), mine);
}

#[test]
fn unsaved_work_is_asked_about_before_an_opened_document_replaces_it() {
    let mut hand = drawn();
    let mine = hand.document();
    let zebra = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/zebra.dapple");
    hand.key(Modifiers::COMMAND, Key::O);
    hand.type_path("File", &zebra);
    assert_eq!(hand.document(), mine);
    hand.press("Don't save");
    assert_eq!(hand.document(), Document::read(&zebra).unwrap());
}

#[test]
fn a_starter_keeps_the_canvas_that_was_just_made_and_is_undone() {
    for starter in ["Spots", "Stripes", "A leopard", "A cow"] {
        let mut hand = hand();
        hand.key(Modifiers::COMMAND, Key::N);
        hand.type_into("Width", "300");
        hand.type_into("Height", "240");
        hand.press("tiles without a seam");
        hand.press("Create");
        let before = hand.window.state().session().document().clone();
        hand.press(starter);
        let after = hand.window.state().session().document().clone();
        assert!(!after.layers.is_empty(), "{starter}");
        assert_eq!(
            (after.size, after.edges, after.dpi),
            (before.size, before.edges, before.dpi),
            "{starter}"
        );
        hand.until_settled();
        hand.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(*hand.window.state().session().document(), before, "{starter}");
    }
}
