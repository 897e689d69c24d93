//! Links that hold a document: they are copied and pasted. Also the parts of the window that are shown in another page.

use dapple::app::{Presentation, Start};
use dapple::document::Document;
use dapple::document::link::SHORT;
use dapple::{ReadFile, WriteFile};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::clipboard::secondary;
use crate::hand::{Hand, hand, hand_with, with};

fn example(name: &str) -> Document {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    Document::read(folder.join(format!("{name}.dapple"))).unwrap()
}

/// Clicks on an entry or a button; returns the text that was copied in the frames after that.
fn copied(hand: &mut Hand, name: &str) -> Option<String> {
    hand.click_label(name);
    let mut text = None;
    for _ in 0..4 {
        let commands = hand.window.output().platform_output.commands.iter();
        text = text.or(commands
            .filter_map(|command| match command {
                OutputCommand::CopyText(text) => Some(text.clone()),
                _ => None,
            })
            .next());
        hand.window.step();
    }
    text
}

fn last_notice(hand: &Hand) -> String {
    hand.window.state().notices().last().map(|notice| notice.text.clone()).unwrap_or_default()
}

#[test]
fn a_copied_link_opens_the_same_document_where_it_is_pasted() {
    let (mut from, _folder, _) = hand_with(&example("zebra"));
    from.press("Edit");
    let link = copied(&mut from, "Copy link").unwrap();
    assert!(link.starts_with("https://dapple.example/#dapple1="), "{link}");
    assert!(link.len() < SHORT, "{}", link.len());
    assert!(last_notice(&from).contains("Copied a link"));

    let mut to = hand();
    to.window.event(Event::Paste(format!("{link}\n")));
    to.rest();
    assert_eq!(to.document(), from.document());
    assert_eq!(to.window.state().session().path, None, "saving asks for a name");
    assert!(!to.window.state().session().is_changed());
}

#[test]
fn the_menu_of_the_texture_copies_a_link_too() {
    let (mut hand, _folder, _) = hand_with(&example("ladybird"));
    hand.until("a picture", |window| !window.growth().is_empty());
    let texture = hand.window.get_by_label_contains("Texture, ").rect();
    secondary(&mut hand, texture.center());
    let link = copied(&mut hand, "Copy link").unwrap();
    assert_eq!(Document::from_link(&link).unwrap(), example("ladybird"));
}

#[test]
fn a_pasted_link_does_not_overwrite_what_was_drawn_without_asking() {
    let link = example("zebra").fragment().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    hand.window.event(Event::Paste(link.clone()));
    hand.rest();
    assert_eq!(hand.document(), mine, "nothing is lost before the answer");
    hand.press("Cancel");
    assert_eq!(hand.document(), mine);
    hand.window.event(Event::Paste(link));
    hand.rest();
    hand.press("Don't save");
    assert_eq!(hand.document(), example("zebra"));
}

#[test]
fn a_link_that_was_cut_off_is_reported_and_loses_nothing() {
    let link = example("zebra").fragment().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    hand.window.event(Event::Paste(link[..link.len() / 2].to_owned()));
    hand.rest();
    hand.press("Don't save");
    assert!(last_notice(&hand).contains("cut off"), "{}", last_notice(&hand));
    assert_eq!(hand.document(), mine);
}

#[test]
fn the_window_opens_with_the_document_of_a_link() {
    let link = Some(example("zebra").fragment().unwrap());
    let hand = with(Start { link, ..Start::default() }, vec2(1280.0, 800.0), Theme::Light);
    assert_eq!(hand.document(), example("zebra"));
}

#[test]
fn for_a_long_document_a_file_is_offered_and_the_link_copied_on_request() {
    let (mut hand, _folder, _) = hand_with(&example("camouflage"));
    hand.press("Edit");
    assert_eq!(copied(&mut hand, "Copy link"), None);
    assert!(hand.window.query_by_label_contains("cut links after 2000").is_some());
    let link = copied(&mut hand, "Copy the link anyway").unwrap();
    assert_eq!(Document::from_link(&link).unwrap(), example("camouflage"));
    hand.press("Edit");
    assert_eq!(copied(&mut hand, "Copy link"), None);
    hand.press("Save a file…");
    assert!(hand.window.query_by_role_and_label(Role::TextInput, "File").is_some(), "asks for a file name");
}

#[test]
fn a_model_that_is_a_file_is_named_and_the_file_offered() {
    let text = r#"{"format": "dapple", "version": 2, "size": [200, 160], "model": {"file": "cat.obj", "px": 700},
        "layers": [{"strokes": [{"kind": "ellipse", "center": [90, 70], "radii": [9, 6]}]}]}"#;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cat.dapple");
    Document::parse(text, "cat").unwrap().write(&path).unwrap();
    let mut hand = with(Start { file: Some(path), ..Start::default() }, vec2(1280.0, 800.0), Theme::Light);
    hand.press("Edit");
    assert_eq!(copied(&mut hand, "Copy link"), None);
    assert!(hand.window.query_by_label_contains("\"cat.obj\" is a file").is_some());
    assert!(hand.window.query_by_label("Copy the link anyway").is_none());
    hand.press("Cancel");
    assert!(hand.window.query_by_label_contains("is a file, which").is_none());
}

fn shown(presentation: Presentation) -> Hand {
    let link = Some(example("ladybird").fragment().unwrap());
    let start = Start { link, presentation, ..Start::default() };
    with(start, vec2(640.0, 360.0), Theme::Light)
}

#[test]
fn a_frame_in_a_page_shows_sketch_and_texture_without_panels() {
    let mut hand = shown(Presentation::Embedded);
    for panel in ["File", "Export…", "Draw", "Undo"] {
        assert!(hand.window.query_by_role_and_label(Role::Button, panel).is_none(), "{panel}");
    }
    assert_eq!(hand.canvas(), egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(320.0, 360.0)));
    let marks = hand.strokes().len();
    hand.draw_round([150.0, 300.0], [30.0, 20.0], 30.0);
    assert_eq!(hand.strokes().len(), marks + 1, "it can be drawn on");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), example("ladybird"));
    hand.until_settled();
    crate::sights::see(&mut hand, "embedded-light");
}

#[test]
fn a_view_shows_the_texture_alone_and_nothing_changes_it() {
    let mut hand = shown(Presentation::Texture);
    assert!(hand.window.query_by_role(Role::Canvas).is_none());
    assert!(hand.window.query_by_role(Role::Button).is_none());
    hand.until_settled();
    let texture = hand.window.get_by_label_contains("Texture, finished").rect();
    assert_eq!(texture.size(), vec2(640.0, 360.0));
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::Delete);
    hand.key(Modifiers::SHIFT, Key::E);
    assert_eq!(hand.document(), example("ladybird"));
    crate::sights::see(&mut hand, "view-light");
}
