//! The texture grows while the user draws; once settled it is what `dapple grow` writes.

use std::fs;

use assert_cmd::Command;
use dapple::ReadFile;
use dapple::app::{GrowthState, Spawn, Start};
use dapple::document::Document;
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, hand_with, with};

fn three_spots(hand: &mut Hand) {
    hand.draw_round([60.0, 60.0], [14.0, 9.0], 20.0);
    hand.draw_round([100.0, 90.0], [13.0, 9.0], 25.0);
    hand.draw_round([55.0, 120.0], [14.0, 8.0], 15.0);
}

/// A small canvas, which grows quickly.
fn small() -> (Hand, tempfile::TempDir) {
    let text = r#"{"format": "dapple", "version": 1, "size": [160, 160], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [14, 9], "angle": 20}]}]}"#;
    let (hand, folder, _) = hand_with(&Document::parse(text, "small").unwrap());
    (hand, folder)
}

#[test]
fn a_settled_texture_equals_the_one_of_the_command_line() {
    let mut hand = hand();
    three_spots(&mut hand);
    hand.until_settled();
    let folder = tempfile::tempdir().unwrap();
    let [saved, exported, grown] =
        ["a.dapple", "window.png", "grown.png"].map(|name| folder.path().join(name));

    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_into("File", saved.to_str().unwrap());
    hand.window.state_mut().export(&exported, None, 1);
    hand.until("exported", |_| exported.exists());

    let dapple = assert_cmd::cargo::cargo_bin!("dapple");
    Command::new(dapple).arg("grow").arg(&saved).arg("-o").arg(&grown).arg("-q").assert().success();
    assert_eq!(fs::read(&exported).unwrap(), fs::read(&grown).unwrap());

    // The px on the screen are equal as well.
    let shown = &hand.window.state().growth().picture.as_ref().unwrap().image;
    let mut reader =
        png::Decoder::new(std::io::BufReader::new(fs::File::open(&grown).unwrap())).read_info().unwrap();
    let mut written = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut written).unwrap();
    let same = shown.pixels.iter().zip(written.chunks_exact(3)).all(|(px, rgb)| px.to_array()[..3] == *rgb);
    assert!(same && shown.pixels.len() * 3 == written.len());
}

#[test]
fn growth_begins_in_the_frame_in_which_the_stroke_ends() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    let [from, to] = [hand.at([100.0, 100.0]), hand.at([130.0, 120.0])];
    hand.window.drag_at(from);
    hand.window.step();
    hand.window.hover_at(to);
    hand.window.step();
    assert_eq!(*hand.growth_state(), GrowthState::Idle);
    hand.window.drop_at(to);
    hand.window.step();
    assert!(matches!(hand.growth_state(), GrowthState::Growing(..)), "{:?}", hand.growth_state());
}

#[test]
fn a_change_replaces_what_grows() {
    let (mut hand, _folder) = small();
    hand.until("growing", |window| matches!(window.growth_state(), GrowthState::Growing(..)));
    hand.draw_round([110.0, 110.0], [20.0, 15.0], 0.0);
    hand.until_settled();
    let grown = &hand.window.state().settled().unwrap().document;
    assert_eq!(**grown, hand.document());
    assert_eq!(grown.layers[0].strokes.len(), 2);
}

#[test]
fn a_paused_growth_takes_no_step_until_it_is_continued() {
    let mut hand = hand();
    three_spots(&mut hand);
    hand.press("Pause");
    let before = hand.growth_state().clone();
    assert!(matches!(before, GrowthState::Growing(..)));
    // A state that was on its way at the pause may still arrive.
    hand.until("standing still", {
        let mut last = None;
        let mut still = 0;
        move |window| {
            still = if last.as_ref() == Some(window.growth_state()) { still + 1 } else { 0 };
            last = Some(window.growth_state().clone());
            still > 50
        }
    });
    assert!(matches!(hand.growth_state(), GrowthState::Growing(..)), "{:?}", hand.growth_state());
    hand.press("Resume");
    hand.until_settled();
}

#[test]
fn a_stopped_growth_keeps_its_picture_and_grows_again_when_asked() {
    // Small spots on a large canvas: they grow for at least a second after their first picture.
    let text = r#"{"format": "dapple", "version": 1, "size": [1200, 1200], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [5, 4], "angle": 20}]}]}"#;
    let (mut hand, _folder, _) = hand_with(&Document::parse(text, "large").unwrap());
    hand.until("a first picture", |window| window.growth().picture.is_some());
    hand.key(Modifiers::COMMAND, Key::Period);
    assert_eq!(*hand.growth_state(), GrowthState::Stopped);
    assert!(hand.window.state().growth().picture.is_some() && hand.window.state().settled().is_none());
    hand.press("Grow again");
    assert!(matches!(hand.growth_state(), GrowthState::Growing(..)), "{:?}", hand.growth_state());
    hand.until_settled();
}

#[test]
fn a_line_among_ellipses_grows_on_a_layer_of_its_own() {
    let (mut hand, _folder) = small();
    hand.until_settled();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[20.0, 140.0], [80.0, 150.0], [140.0, 140.0]]);
    hand.until_settled();
    assert_eq!(hand.window.state().settled().unwrap().grown.layers.len(), 2);
    // Layers that were reused from the previous growth equal those of a new growth.
    let shown = hand.window.state().growth().picture.as_ref().unwrap().image.clone();
    hand.press("Grow again");
    hand.until_settled();
    assert_eq!(shown.pixels, hand.window.state().growth().picture.as_ref().unwrap().image.pixels);
}

#[test]
fn another_seed_is_another_texture_that_can_be_undone() {
    let (mut hand, _folder) = small();
    hand.until_settled();
    let before = hand.window.state().growth().picture.as_ref().unwrap().image.clone();
    hand.key(Modifiers::NONE, Key::N);
    hand.until_settled();
    let after = hand.window.state().growth().picture.as_ref().unwrap().image.clone();
    assert_eq!(hand.document().seed, 2);
    assert_ne!(before.pixels, after.pixels);
    hand.key(Modifiers::COMMAND, Key::Z);
    hand.until_settled();
    assert_eq!(before.pixels, hand.window.state().growth().picture.as_ref().unwrap().image.pixels);
}

#[test]
fn an_empty_canvas_grows_nothing() {
    let mut hand = hand();
    three_spots(&mut hand);
    hand.until_settled();
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(*hand.growth_state(), GrowthState::Idle);
    assert!(hand.window.state().growth().picture.is_none());
}

#[test]
fn an_export_at_another_size_runs_in_the_background_and_can_be_cancelled() {
    let (mut hand, folder) = small();
    hand.until_settled();
    let path = folder.path().join("large.png");
    hand.window.state_mut().export(&path, Some([320, 240]), 2);
    hand.until("written", |_| path.exists());
    let size =
        png::Decoder::new(std::io::BufReader::new(fs::File::open(&path).unwrap())).read_info().unwrap();
    assert_eq!((size.info().width, size.info().height), (640, 480));

    let given_up = folder.path().join("huge.png");
    hand.window.state_mut().export(&given_up, Some([3000, 3000]), 1);
    hand.rest();
    hand.press("Cancel");
    hand.until("cancelled", |window| window.notices().iter().any(|notice| notice.text.contains("cancelled")));
    assert!(!given_up.exists());
}

#[test]
fn a_growth_thread_that_does_not_start_is_reported() {
    let spawn = Spawn(|_, _| Err(std::io::Error::other("no thread left")));
    let mut hand = with(Start { spawn, ..Start::default() }, vec2(1280.0, 800.0), Theme::Light);
    three_spots(&mut hand);
    let GrowthState::Failed(why) = hand.growth_state() else { panic!("{:?}", hand.growth_state()) };
    assert!(why.contains("growth") && why.contains("no thread left"), "{why}");
    assert!(hand.window.query_by_label_contains("no thread left").is_some(), "it is shown");
    // The document can still be saved.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    hand.key(Modifiers::COMMAND, Key::S);
    hand.type_into("File", path.to_str().unwrap());
    assert_eq!(Document::read(&path).unwrap(), hand.document());
}
