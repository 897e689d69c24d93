//! Documents in and out.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dapple::app::{Settings, Start, Window};
use dapple::synth::recipe::Document;
use eframe::egui::{DroppedFile, Key, Modifiers, Theme, vec2};

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

fn drop_file(hand: &mut Hand, path: &Path) {
    hand.window.input_mut().dropped_files.push(Arc::new(Dropped(path.to_owned())));
    hand.rest();
}

fn example(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"))
}

#[test]
fn what_is_saved_is_opened_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.drag(&[[100.0, 400.0], [300.0, 430.0]]);
    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_into("File", folder.path().join("mine").to_str().unwrap());
    let path = folder.path().join("mine.dapple");
    assert_eq!(Document::read(&path).unwrap(), hand.document());
    assert!(!hand.window.state().desk().is_changed());

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
            let desk = dapple::app::Desk::open(document.clone(), Some(path.clone()));
            assert_eq!(desk.finished(), document, "{}", path.display());
            assert!(!desk.is_changed());
        }
    }
}

#[test]
fn a_bad_file_that_is_dropped_is_told_and_loses_nothing() {
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
fn a_document_that_is_dropped_is_opened_once_unsaved_work_is_answered_for() {
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
fn unsaved_work_can_be_saved_before_another_document_comes() {
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
fn a_picture_that_is_dropped_lies_under_the_canvas() {
    let picture = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/examples/zebra.png");
    let mut hand = hand();
    drop_file(&mut hand, &picture);
    hand.until("the picture", Window::has_reference);
    assert!(hand.strokes().is_empty());
}

#[test]
fn a_new_document_has_the_size_and_the_regions_that_were_asked_for() {
    let mut hand = hand();
    hand.key(Modifiers::COMMAND, Key::N);
    hand.type_into("Width", "300");
    hand.type_into("Rows", "3");
    hand.press("tiles without a seam");
    hand.press("Create");
    let document = hand.window.state().desk().document().clone();
    assert_eq!((document.size, document.regions), ([300, 512], [2, 3]));
    assert_eq!(document.edges, dapple::field::Edges::Wrap);
}

#[test]
fn files_that_were_opened_are_remembered_the_latest_first() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let start = Start { settings: Settings::at(&file), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    for name in ["zebra", "tiger"] {
        drop_file(&mut hand, &example(name));
    }
    let names: Vec<String> = Settings::at(&file)
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
    hand.press("Example: zebra");
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}

#[test]
fn the_canvas_is_resized_and_cut_into_regions() {
    let mut hand = hand();
    hand.draw_round([450.0, 200.0], [30.0, 20.0], 30.0);
    hand.draw_round([100.0, 200.0], [30.0, 20.0], 30.0);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.type_into("Region columns", "3");
    hand.type_into("Canvas width", "400");
    let document = hand.document();
    assert_eq!((document.size, document.regions), ([400, 512], [3, 2]));
    assert_eq!(document.layers[0].strokes.len(), 1, "what is outside goes");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.strokes().len(), 2);
}

#[test]
fn a_document_named_on_the_command_line_is_open() {
    let (hand, ..) = hand_with(&Document::read(example("zebra")).unwrap());
    assert_eq!(hand.document(), Document::read(example("zebra")).unwrap());
}
