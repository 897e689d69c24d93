//! The export dialog: the preview equals the written file and the file of `dapple grow` and `dapple film`.

mod films;
mod outlines;
mod pictures;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assert_cmd::Command;
use dapple::WriteFile;
use dapple::app::{ExportKind, FinishedPreview, Settings, Start};
use dapple::document::Document;
use egui::accesskit::Role;
use egui::{ColorImage, Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand_with, with};
use crate::sights::see;

const SMALL: &str = r#"{"format": "dapple", "version": 1, "size": [96, 80], "layers": [
    {"name": "spots", "strokes": [{"kind": "ellipse", "center": [40, 40], "radii": [10, 7], "angle": 20}]}]}"#;

fn small() -> (Hand, tempfile::TempDir) {
    let (mut hand, folder, _) = hand_with(&Document::parse(SMALL, "small").unwrap());
    hand.until_settled();
    (hand, folder)
}

/// Opens the dialog on one of its pages.
fn open(hand: &mut Hand, kind: &str) {
    hand.key(Modifiers::COMMAND, Key::E);
    hand.press(kind);
}

/// Chooses an entry of a list.
fn take(hand: &mut Hand, list: &str, text: &str) {
    let begins = format!("{list}: ");
    let nodes = hand.window.query_all_by_role(Role::ComboBox);
    let label = |node: &egui_kittest::Node| {
        use egui_kittest::kittest::NodeT;
        node.accesskit_node().label().unwrap_or_default()
    };
    nodes
        .into_iter()
        .find(|node| label(node).starts_with(&begins))
        .unwrap_or_else(|| panic!("no {list}"))
        .click();
    hand.rest();
    hand.click_role(Role::Button, text);
    hand.rest();
}

/// The preview, once it is complete.
fn seen(hand: &mut Hand) -> Arc<FinishedPreview> {
    hand.until("a preview", |window| window.previewed().is_some());
    // The lit view of a material is rendered after its maps.
    hand.rest();
    hand.window.state().previewed().unwrap()
}

/// Writes the file, and waits until it is written.
fn write(hand: &mut Hand, path: &Path) {
    hand.press("Export…");
    let into = hand.window.query_by_role_and_label(Role::TextInput, "File").is_none();
    hand.type_path(if into { "Folder" } else { "File" }, path);
    hand.until("written", |window| window.notices().iter().any(|notice| notice.text.contains("Written")));
    assert!(hand.window.state().notices().iter().all(|notice| !notice.wrong));
    hand.rest();
    hand.press("OK");
}

/// The picture, decoded by another decoder than that of the preview.
fn decoded(path: &Path) -> ColorImage {
    let image = image::open(path).unwrap().into_rgba8();
    ColorImage::from_rgba_unmultiplied([image.width() as usize, image.height() as usize], image.as_raw())
}

#[track_caller]
fn same(seen: &ColorImage, path: &Path) {
    let written = decoded(path);
    assert_eq!(seen.size, written.size);
    assert!(seen.pixels == written.pixels, "{} is not what was seen", path.display());
}

/// The file that the command line writes for the same document.
fn grown(folder: &Path, name: &str, options: &[&str]) -> PathBuf {
    let path = folder.join(name);
    let dapple = assert_cmd::cargo::cargo_bin!("dapple");
    let mut command = Command::new(dapple);
    command.arg("grow").arg(folder.join("a.dapple")).arg("-q").args(options);
    if !options.contains(&"--material") {
        command.arg("-o").arg(&path);
    }
    command.assert().success();
    path
}

#[test]
fn an_export_does_not_cancel_the_one_that_is_being_written() {
    let (mut hand, folder) = small();
    let first = folder.path().join("first.png");
    hand.window.state_mut().export(&first, Some([1200, 1200]), 1);
    open(&mut hand, "Picture");
    hand.press("Export…");
    hand.type_path("File", &folder.path().join("second.png"));
    let told = |window: &dapple::app::Window, text: &str| {
        window.notices().iter().any(|notice| notice.text.contains("first.png") && notice.text.contains(text))
    };
    hand.until("refused", |window| told(window, "is still being written"));
    hand.until("written", |window| told(window, "Written"));
    assert!(first.exists() && !folder.path().join("second.png").exists());
}

#[test]
fn an_impossible_export_is_reported_with_a_remedy() {
    let (mut hand, folder) = small();
    let other = folder.path().join("stripes.dapple");
    let text = r#"{"format": "dapple", "version": 1, "size": [96, 80], "layers": [
        {"strokes": [{"kind": "line", "from": [10, 10], "to": [80, 60], "width": 6}]}]}"#;
    Document::parse(text, "other").unwrap().write(&other).unwrap();
    open(&mut hand, "Film");
    hand.press("The change into another document");
    hand.press("Choose a document…");
    hand.type_path("File", &other);
    hand.press("Preview the film");
    let mut found = false;
    for _ in 0..2000 {
        hand.window.step();
        found = hand.window.query_by_label_contains("one has spots and the other stripes").is_some();
        if found {
            break;
        }
        hand.wait_for_tasks();
    }
    assert!(found);
}

#[test]
fn the_dialog_keeps_its_choices_also_in_the_next_session() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let document = folder.path().join("a.dapple");
    Document::parse(SMALL, "small").unwrap().write(&document).unwrap();
    let start =
        || Start { settings: Settings::read(&file), file: Some(document.clone()), ..Start::default() };
    let mut first = with(start(), vec2(1280.0, 800.0), Theme::Light);
    first.until_settled();
    open(&mut first, "Picture");
    take(&mut first, "Format", "WebP");
    first.press("transparent");
    seen(&mut first);
    write(&mut first, &folder.path().join("x.webp"));
    open(&mut first, "Outlines");
    first.press("hatch");
    seen(&mut first);
    write(&mut first, &folder.path().join("x.svg"));
    let mut again = with(start(), vec2(1280.0, 800.0), Theme::Light);
    again.key(Modifiers::COMMAND, Key::E);
    let choices = again.window.state().choices().unwrap().clone();
    assert_eq!(choices.what, ExportKind::Outlines);
    assert!(choices.outlines.hatch && choices.picture.transparent);
    assert_eq!(choices.picture.format.name(), "WebP");
}

#[test]
fn escape_closes_the_dialog_and_cancelling_the_file_dialog_returns_to_it() {
    let (mut hand, _folder) = small();
    open(&mut hand, "Picture");
    seen(&mut hand);
    hand.press("Export…");
    hand.press("Cancel");
    assert!(hand.window.state().choices().is_some(), "back in the dialog");
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.state().choices().is_none());
}

fn sight(kind: &str, name: &str, size: [f32; 2], theme: Theme) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/cheetah-run.dapple");
    let mut hand = with(Start { file: Some(file), ..Start::default() }, size.into(), theme);
    hand.until_settled();
    hand.window.state_mut().hide_times();
    open(&mut hand, kind);
    seen(&mut hand);
    see(&mut hand, name);
}

#[test]
fn the_picture_page() {
    sight("Picture", "export-picture-light", [1280.0, 800.0], Theme::Light);
}

#[test]
fn the_outlines_page_in_a_small_dark_window() {
    sight("Outlines", "export-outlines-dark", [1024.0, 700.0], Theme::Dark);
}

#[test]
fn the_material_page() {
    sight("Material", "export-material-light", [1024.0, 700.0], Theme::Light);
}

#[test]
fn after_a_failed_write_the_dialog_stays_open_and_the_last_folder_is_proposed() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = crate::hand::hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.until_settled();
    open(&mut hand, "Picture");
    hand.press("Export…");
    hand.type_path("File", &folder.path().join("no").join("such.png"));
    assert!(hand.window.state().notices()[0].wrong);
    assert!(hand.window.state().choices().is_some(), "the dialog is open");
    hand.press("Export…");
    hand.type_path("File", &folder.path().join("mine.png"));
    hand.until("written", |window| window.notices().iter().any(|notice| notice.text.contains("mine.png")));
    open(&mut hand, "Picture");
    hand.press("Export…");
    let name = hand.window.get_by_role_and_label(Role::TextInput, "File").value();
    assert_eq!(name.as_deref(), Some("mine.png"));
    assert!(hand.window.query_all_by_label_contains(folder.path().to_str().unwrap()).next().is_some());
}
