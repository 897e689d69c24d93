//! Preferences take effect at once, and are saved.

use dapple::WriteFile;
use dapple::app::{New, Settings, Start, Units};
use dapple::document::Ellipse;
use dapple::document::{Document, Stroke};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, ThemePreference, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand, with};

fn at(file: &std::path::Path) -> Hand {
    let start = Start { settings: Settings::read(file), ..Start::default() };
    with(start, vec2(1280.0, 800.0), Theme::Light)
}

fn preferences(hand: &mut Hand) {
    hand.key(Modifiers::COMMAND, Key::Comma);
    assert!(hand.window.query_by_label("Preferences").is_some());
}

fn shown(hand: &Hand, name: &str) -> String {
    let field = hand.window.get_by_role_and_label(Role::SpinButton, name);
    field.accesskit_node().value().unwrap_or_default()
}

#[test]
fn preferences_are_remembered() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let mut hand = at(&file);
    preferences(&mut hand);
    hand.press("Dark");
    hand.press("mm");
    hand.press("This many");
    hand.type_into("Number of threads", "1");
    hand.type_into("Width of new documents", "10");
    hand.press("Regions of new documents");
    hand.type_into("Rows of new documents", "4");
    hand.type_into("Resolution of new documents", "254");
    hand.press("tiles without a seam");
    hand.press("Close");
    let settings = Settings::read(&file);
    assert_eq!((settings.theme, settings.units), (ThemePreference::Dark, Units::Mm));
    assert_eq!(settings.threads, Some(1));
    let new = New { size: [118, 512], regions: Some([2, 4]), seamless: true, dpi: 254.0 };
    assert_eq!(settings.new, new, "10 mm at 300 dpi are 118 px");
}

#[test]
fn the_last_change_is_written_when_the_window_closes() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let mut hand = at(&file);
    preferences(&mut hand);
    hand.press("mm");
    assert_eq!(Settings::read(&file).units, Units::Px, "the page is still open");
    hand.window.state_mut().leave();
    assert_eq!(Settings::read(&file).units, Units::Mm);
}

#[test]
fn settings_that_cannot_be_written_are_reported_once_and_the_window_stays_usable() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = at(&folder.path().join("dapple/settings"));
    std::fs::write(folder.path().join("dapple"), "a file where a folder should be").unwrap();
    for change in ["mm", "Dark"] {
        preferences(&mut hand);
        hand.press(change);
        hand.press("Close");
        let notices = hand.window.state().notices().to_vec();
        let reported = notices.iter().filter(|notice| notice.text.contains("settings cannot be saved"));
        assert_eq!(reported.count(), usize::from(change == "mm"), "{notices:?}");
        if change == "mm" {
            hand.press("OK");
        }
    }
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(hand.strokes().len(), 1);
}

#[test]
fn a_new_document_has_the_preferred_values() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let mut settings = Settings::read(&file);
    settings.new = New { size: [640, 320], regions: Some([4, 1]), seamless: true, dpi: 72.0 };
    settings.write();
    let mut hand = at(&file);
    let is = |hand: &Hand| {
        let document = hand.window.state().session().document();
        assert_eq!((document.size, document.regions), ([640, 320], Some([4, 1])));
        assert_eq!((document.edges, document.dpi), (dapple::document::Edges::Wrap, 72.0));
    };
    is(&hand);
    hand.key(Modifiers::COMMAND, Key::N);
    hand.press("Create");
    is(&hand);
}

#[test]
fn lengths_are_shown_and_typed_in_mm_by_the_documents_dpi() {
    let mut hand = hand();
    hand.key(Modifiers::SHIFT, Key::E);
    preferences(&mut hand);
    hand.press("mm");
    hand.press("Close");
    let before = hand.ellipses()[0];
    assert_eq!(shown(&hand, "Centre x"), "21.67", "256 px of 300 an inch");
    assert_eq!(shown(&hand, "Area"), "2.163 mm²");
    hand.type_into("Radius along", "2.54");
    assert!((hand.ellipses()[0].radii[0] - 30.0).abs() < 1e-9);
    hand.type_into("Radius along", "60 px");
    assert!((hand.ellipses()[0].radii[0] - 60.0).abs() < 1e-9);
    hand.press("Canvas");
    hand.type_into("Resolution", "254");
    hand.type_into("Canvas width", "40");
    assert_eq!(hand.document().size, [400, 512]);
    assert_eq!(hand.ellipses()[0].center, before.center, "the document holds px");
    assert_eq!(hand.document().dpi, 254.0);
}

#[test]
fn a_number_field_that_is_left_without_typing_changes_nothing() {
    let mut hand = hand();
    hand.draw_round([150.3, 200.7], [40.0, 21.3], 30.0);
    hand.key(Modifiers::COMMAND, Key::A);
    let before = hand.ellipses();
    for units in ["px", "mm"] {
        preferences(&mut hand);
        hand.press(units);
        hand.press("Close");
        for name in ["Centre x", "Centre y", "Radius along", "Radius across", "Area"] {
            hand.click_role(Role::SpinButton, name);
            hand.rest();
            hand.key(Modifiers::NONE, Key::Enter);
        }
        assert_eq!(hand.ellipses(), before, "{units}");
    }
}

#[test]
fn any_number_of_threads_grows_the_same_texture() {
    let mut document = Document { size: [128, 128], ..Document::default() };
    let ellipses = [[40.0, 40.0], [80.0, 50.0], [60.0, 90.0]];
    let strokes = ellipses.map(|center| Stroke::Ellipse(Ellipse { center, radii: [9.0, 6.0], angle: 20.0 }));
    document.layers.push(dapple::document::Layer { strokes: strokes.to_vec(), ..Default::default() });
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.dapple");
    document.write(&file).unwrap();
    let mut pictures = Vec::new();
    for threads in [Some(1), Some(3), None] {
        let mut start = Start { file: Some(file.clone()), ..Start::default() };
        start.settings.threads = threads;
        let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
        hand.until_settled();
        // With more px, the texture is grown again, with the number of threads for exports.
        let path = folder.path().join(format!("{threads:?}.png"));
        hand.window.state_mut().export(&path, Some([96, 96]), 1);
        hand.until("the picture", |window| !window.notices().is_empty());
        pictures.push(std::fs::read(&path).unwrap());
        let plain = folder.path().join(format!("plain-{threads:?}.png"));
        hand.window.state_mut().export(&plain, None, 1);
        hand.until("the picture", |_| plain.exists());
        pictures.push(std::fs::read(&plain).unwrap());
    }
    for picture in pictures.chunks(2) {
        assert!(picture == &pictures[..2], "the pictures differ");
    }
}

#[test]
fn every_control_of_the_page_has_a_name_and_is_reached_by_keys() {
    let mut hand = hand();
    preferences(&mut hand);
    for role in [Role::RadioButton, Role::SpinButton, Role::CheckBox] {
        for node in hand.window.query_all_by_role(role) {
            let node = node.accesskit_node();
            let name = node.label().or_else(|| node.labelled_by().next()?.value()).unwrap_or_default();
            assert!(!name.is_empty());
        }
    }
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_role_and_label(Role::RadioButton, "mm").is_none());
}
