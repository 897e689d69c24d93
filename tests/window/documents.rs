//! Opening and saving documents.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dapple::app::{Settings, Start, Window};
use dapple::document::Document;
use dapple::{ReadFile, WriteFile};
use egui::{DroppedFile, Event, Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, hand_with, with};

#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

pub fn drop_file(hand: &mut Hand, path: &Path) {
    hand.window.input_mut().dropped_files.push(Arc::new(Dropped(path.to_owned())));
    hand.rest();
}

fn example(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"))
}

#[test]
fn a_saved_document_is_opened_unchanged() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.drag(&[[100.0, 400.0], [300.0, 430.0]]);
    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_into("File", folder.path().join("mine").to_str().unwrap());
    let path = folder.path().join("mine.dapple");
    assert_eq!(Document::read(&path).unwrap(), hand.document());
    assert!(!hand.window.state().session().is_changed());

    let again = with(Start { file: Some(path), ..Start::default() }, vec2(1280.0, 800.0), Theme::Light);
    assert_eq!(again.document(), hand.document());
}

#[test]
fn every_example_is_opened_and_saved_without_a_change() {
    let folder = example("zebra").parent().unwrap().to_owned();
    let files = |folder: PathBuf| fs::read_dir(folder).unwrap().map(|file| file.unwrap().path());
    for path in files(folder.clone()).chain(files(folder.join("gallery"))) {
        if path.extension().is_some_and(|ending| ending == "dapple") {
            let document = Document::read(&path).unwrap();
            let session = dapple::app::Session::open(document.clone(), Some(path.clone()));
            assert_eq!(session.finished(), document, "{}", path.display());
            assert!(!session.is_changed());
        }
    }
}

#[test]
fn a_document_on_a_model_is_shown_flat_and_keeps_its_model_and_the_marks_on_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cat.dapple");
    let text = r#"{"format": "dapple", "version": 2, "size": [200, 160], "model": {"file": "cat.obj", "px": 700},
        "layers": [{"strokes": [{"kind": "ellipse", "center": [90, 70], "radii": [9, 6]},
            {"kind": "ellipse", "at": [0, 1, 0], "radii": [9, 6]}]}]}"#;
    fs::write(&path, text).unwrap();
    let before = Document::read(&path).unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &path);
    let notices = hand.window.state().notices().to_vec();
    assert!(notices[0].text.contains("grows on the model \"cat.obj\""), "{notices:?}");
    hand.press("OK");
    hand.draw_round([120.0, 110.0], [30.0, 20.0], 30.0);
    hand.key(Modifiers::COMMAND, Key::S);
    hand.rest();
    let after = Document::read(&path).unwrap();
    assert_eq!(after.layers[0].strokes.len(), 2);
    assert_eq!((&after.model, &after.layers[0].on_model), (&before.model, &before.layers[0].on_model));
}

#[test]
fn an_invalid_file_that_is_dropped_is_reported_and_loses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let bad = folder.path().join("bad.dapple");
    fs::write(&bad, r#"{"format": "dapple", "version": 1, "size": [64, -1], "layers": []}"#).unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let before = hand.document();
    drop_file(&mut hand, &bad);
    let notices = hand.window.state().notices().to_vec();
    assert!(notices[0].wrong && notices[0].text.contains("size"), "{notices:?}");
    assert_eq!(hand.document(), before);
    hand.press("OK");
    assert!(hand.window.state().notices().is_empty());
}

#[test]
fn a_dropped_document_is_opened_after_the_question_about_unsaved_work() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    drop_file(&mut hand, &example("zebra"));
    assert_eq!(hand.document(), mine, "nothing is lost before the answer");
    hand.press("Cancel");
    assert_eq!(hand.document(), mine);
    drop_file(&mut hand, &example("zebra"));
    hand.press("Don't save");
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}

#[test]
fn unsaved_work_can_be_saved_before_another_document_is_opened() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    drop_file(&mut hand, &example("tiger"));
    hand.press("Save");
    let path = folder.path().join("mine.dapple");
    hand.type_into("File", path.to_str().unwrap());
    assert_eq!(Document::read(&path).unwrap(), mine);
    assert_eq!(hand.document(), Document::read(example("tiger")).unwrap());
}

#[test]
fn a_dropped_picture_is_shown_under_the_canvas_where_the_user_chooses_that() {
    let picture = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/examples/zebra.png");
    let mut hand = hand();
    drop_file(&mut hand, &picture);
    assert!(!hand.window.state().has_reference(), "it is asked before");
    hand.press("Reference picture");
    hand.until("the picture", Window::has_reference);
    assert!(hand.strokes().is_empty());
}

#[test]
fn a_new_document_has_the_size_and_the_regions_that_were_asked_for() {
    let mut hand = hand();
    hand.key(Modifiers::COMMAND, Key::N);
    hand.press("Regions");
    hand.type_into("Width", "300");
    hand.type_into("Rows", "3");
    hand.press("tiles without a seam");
    hand.press("Create");
    let document = hand.window.state().session().document().clone();
    assert_eq!((document.size, document.regions), ([300, 512], Some([2, 3])));
    assert_eq!(document.edges, dapple::document::Edges::Wrap);
}

#[test]
fn files_that_were_opened_are_remembered_the_latest_first() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let start = Start { settings: Settings::read(&file), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    for name in ["zebra", "tiger"] {
        drop_file(&mut hand, &example(name));
    }
    let names: Vec<String> = Settings::read(&file)
        .recent
        .iter()
        .map(|path| path.file_stem().unwrap().to_string_lossy().into())
        .collect();
    assert_eq!(names, ["tiger", "zebra"]);
}

#[test]
fn an_example_is_chosen_from_its_picture() {
    let mut hand = hand();
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    hand.press("Example: Zebra");
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}

#[test]
fn the_canvas_is_resized_and_divided_into_regions() {
    let mut hand = hand();
    hand.draw_round([450.0, 200.0], [30.0, 20.0], 30.0);
    hand.draw_round([100.0, 200.0], [30.0, 20.0], 30.0);
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!(hand.document().regions, None, "off in a new document");
    hand.press("Canvas");
    hand.press("Canvas regions");
    hand.type_into("Region columns", "3");
    hand.type_into("Canvas width", "400");
    let document = hand.document();
    assert_eq!((document.size, document.regions), ([400, 512], Some([3, 2])));
    assert_eq!(document.layers[0].strokes.len(), 1, "what is outside goes");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.strokes().len(), 2);
}

#[test]
fn a_document_named_on_the_command_line_is_open() {
    let (hand, ..) = hand_with(&Document::read(example("zebra")).unwrap());
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}

/// A PNG that dapple wrote, with or without its document.
fn pictured(folder: &Path, options: &[&str]) -> PathBuf {
    let document = folder.join("small.dapple");
    let text = r#"{"format": "dapple", "version": 1, "size": [96, 80], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [40, 40], "radii": [10, 7], "angle": 20}]}]}"#;
    Document::parse(text, "small").unwrap().write(&document).unwrap();
    let picture = folder.join("small.png");
    let dapple = assert_cmd::cargo::cargo_bin!("dapple");
    let mut grow = assert_cmd::Command::new(dapple);
    grow.arg("grow").arg(&document).arg("-o").arg(&picture).arg("-q").args(options).assert().success();
    picture
}

#[test]
fn a_picture_that_holds_its_document_restores_it_without_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let picture = pictured(folder.path(), &["--size", "120x96", "--scale", "2"]);
    let before = fs::read(&picture).unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &picture);
    assert_eq!(hand.document().layers, Document::read(folder.path().join("small.dapple")).unwrap().layers);
    assert!(!hand.window.state().has_reference());
    assert_eq!(hand.window.state().session().path, None);

    // Saving asks for a file name, and the picture is not overwritten.
    hand.key(Modifiers::COMMAND, Key::S);
    let saved = folder.path().join("again.dapple");
    hand.type_into("File", saved.to_str().unwrap());
    assert!(Document::read(&saved).is_ok());
    assert_eq!(fs::read(&picture).unwrap(), before);

    // The export dialog starts with the size of the picture.
    hand.key(Modifiers::COMMAND, Key::E);
    let size = hand.window.state().choices().unwrap().size;
    assert_eq!((size.canvas, size.scale), (Some([120, 96]), 2));
}

#[test]
fn unsaved_work_is_asked_about_before_a_picture_or_a_drawing_replaces_it() {
    let folder = tempfile::tempdir().unwrap();
    let picture = pictured(folder.path(), &[]);
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    drop_file(&mut hand, &picture);
    hand.press("Cancel");
    assert_eq!(hand.document(), mine);
    drop_file(&mut hand, &picture);
    hand.press("Don't save");
    assert_ne!(hand.document(), mine);
}

#[test]
fn a_picture_without_a_document_is_asked_about_when_it_is_opened() {
    let folder = tempfile::tempdir().unwrap();
    let picture = pictured(folder.path(), &["--no-document"]);
    let mut hand = hand();
    hand.key(Modifiers::COMMAND, Key::O);
    hand.type_into("File", picture.to_str().unwrap());
    hand.press("Reference picture");
    hand.until("the picture", Window::has_reference);
}

#[test]
fn an_svg_becomes_an_unsaved_sketch_with_a_notice_of_what_was_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("drawing.svg");
    fs::write(
        &drawing,
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="200" height="160" viewBox="0 0 200 160">
        <ellipse cx="60" cy="50" rx="20" ry="10" fill="#333"/><text x="5" y="150">note</text></svg>"##,
    )
    .unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &drawing);
    assert_eq!(hand.ellipses().len(), 1);
    assert_eq!(hand.document().size, [200, 160]);
    let session = hand.window.state().session();
    assert!(session.path.is_none() && session.is_changed());
    let notices = hand.window.state().notices().to_vec();
    assert!(notices[0].text.contains("not read: 1 × text"), "{notices:?}");

    // The document equals that of `dapple import`.
    let other = folder.path().join("cli.dapple");
    let mut import = assert_cmd::Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    import.arg("import").arg(&drawing).arg("-o").arg(&other).arg("-q").assert().success();
    assert_eq!(hand.document().layers, Document::read(&other).unwrap().layers);
}

#[test]
fn a_json_file_with_a_document_is_opened_and_one_with_a_palette_is_applied() {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("zebra.json");
    fs::copy(example("zebra"), &json).unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &json);
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}

#[test]
fn a_window_that_closes_during_a_save_completes_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("zebra.dapple");
    fs::copy(example("zebra"), &path).unwrap();
    let start = Start { file: Some(path.clone()), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::ArrowRight);
    let moved = hand.document();
    hand.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    hand.window.step();
    drop(hand);
    assert_eq!(Document::read(&path).unwrap(), moved);
}

#[test]
fn a_change_after_a_save_began_is_unsaved() {
    let (mut hand, _folder, path) = hand_with(&Document::read(example("zebra")).unwrap());
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::ArrowRight);
    let moved = hand.document();
    hand.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    hand.window.step();
    hand.key(Modifiers::NONE, Key::ArrowRight);
    assert_eq!(Document::read(&path).unwrap(), moved);
    assert_ne!(hand.document(), moved);
    assert!(hand.window.state().session().is_changed());
}

#[test]
fn enter_that_answers_one_question_does_not_answer_the_next() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::COMMAND, Key::N);
    assert!(hand.window.query_by_label_contains("Save the changes").is_some());
    hand.key(Modifiers::NONE, Key::Enter);
    hand.type_path_only("File", &path);
    // Enter is held, so that the same key event is repeated.
    for _ in 0..6 {
        let (key, modifiers) = (Key::Enter, Modifiers::NONE);
        hand.window.event(Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers });
        hand.rest();
    }
    assert!(path.exists());
    assert!(hand.window.query_by_label("New document").is_some(), "the page is shown");
    hand.window.key_up(Key::Enter);
    hand.rest();
    hand.key(Modifiers::NONE, Key::Enter);
    assert!(hand.window.query_by_label("New document").is_none());
    assert!(hand.strokes().is_empty());
}

#[test]
fn the_question_about_unsaved_changes_is_as_high_as_its_text() {
    let mut hand = hand();
    hand.key(Modifiers::COMMAND, Key::N);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::COMMAND, Key::N);
    let text = hand.window.get_by_label_contains("Otherwise they will be lost").rect();
    let button = hand.window.get_by_label("Don't save").rect();
    assert!(button.top() - text.bottom() < 40.0, "{text:?} {button:?}");
}
