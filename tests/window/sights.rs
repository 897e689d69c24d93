//! Pictures of the main states of the window. `UPDATE_SNAPSHOTS=force cargo test --test window sights` renews them.

use std::path::PathBuf;

use dapple::app::Start;
use eframe::App;
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::{SnapshotOptions, image_snapshot_options};
use image::RgbaImage;

use crate::hand::{Hand, with};

const SMALL: [f32; 2] = [1280.0, 800.0];

fn example(name: &str) -> Start {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"));
    Start { file: Some(file), ..Start::default() }
}

/// Moves the pointer away, and waits for what is shown later: the results of a texture, its picture for another zoom, and pictures
/// of what it can become.
#[track_caller]
fn prepare(hand: &mut Hand) {
    hand.window.remove_cursor();
    hand.rest();
    hand.until("measured", |window| {
        window.settled().is_none() || window.results().for_texture(window.settled()).is_some()
    });
    hand.until("painted", |window| !window.is_painting() && !window.goals().is_busy());
    hand.rest();
}

/// A picture of the window without the pointer.
#[track_caller]
pub fn picture(hand: &mut Hand) -> RgbaImage {
    prepare(hand);
    let picture = hand.window.render().unwrap();
    on_background(hand, picture)
}

/// Lays a picture with a transparent background on the colour to which the window is cleared.
fn on_background(hand: &Hand, mut picture: RgbaImage) -> RgbaImage {
    let window = hand.window.state();
    let background = window.clear_color(&hand.window.ctx.global_style().visuals).map(|part| 255.0 * part);
    for pixel in picture.pixels_mut() {
        let behind = 1.0 - f32::from(pixel.0[3]) / 255.0;
        // The colours of the picture are multiplied by its opacity.
        pixel.0 =
            [0, 1, 2, 3].map(|part| (f32::from(pixel.0[part]) + behind * background[part]).round() as u8);
    }
    picture
}

/// Compares the window with the stored picture.
#[track_caller]
pub fn see(hand: &mut Hand, name: &str) {
    let picture = picture(hand);
    let options = SnapshotOptions::new()
        .output_path(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/window/sights"))
        .threshold(1.5)
        .max_failed_pixels(400);
    image_snapshot_options(&picture, name, &options);
}

#[test]
fn the_welcome() {
    see(&mut with(Start::default(), SMALL.into(), Theme::Light), "welcome-light");
}

#[test]
fn the_welcome_in_the_dark() {
    see(&mut with(Start::default(), SMALL.into(), Theme::Dark), "welcome-dark");
}

fn cheetah(name: &str, size: [f32; 2], theme: Theme) {
    let mut hand = with(example("cheetah-run"), size.into(), theme);
    hand.until_settled();
    hand.window.state_mut().hide_times();
    see(&mut hand, name);
}

#[test]
fn a_sketch_beside_its_texture() {
    cheetah("cheetah-light", SMALL, Theme::Light);
}

#[test]
fn a_sketch_beside_its_texture_in_the_dark() {
    cheetah("cheetah-dark", SMALL, Theme::Dark);
}

#[test]
fn a_selected_ellipse_in_a_new_document() {
    let mut hand = with(Start::default(), vec2(1280.0, 800.0), Theme::Dark);
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[100.0, 100.0], [220.0, 180.0]]);
    hand.until_settled();
    hand.key(Modifiers::NONE, Key::V);
    hand.window.state_mut().hide_times();
    see(&mut hand, "selected-dark");
}

#[test]
fn the_analysis_of_the_sketch() {
    let mut hand = with(example("turning-spots"), SMALL.into(), Theme::Light);
    hand.press("Canvas");
    hand.press("Analysis of the sketch");
    hand.until_settled();
    hand.window.state_mut().hide_times();
    see(&mut hand, "analysis-light");
}

#[test]
fn pages() {
    let mut hand = with(Start::default(), SMALL.into(), Theme::Light);
    hand.key(Modifiers::NONE, Key::F1);
    see(&mut hand, "keys-light");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    see(&mut hand, "examples-light");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND, Key::N);
    see(&mut hand, "new-light");
}

#[test]
fn a_bad_file_is_reported_in_a_notice() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bad.dapple");
    std::fs::write(&file, "{\"format\": \"dapple\"").unwrap();
    let start = Start { file: Some(file), ..Start::default() };
    let hand = with(start, SMALL.into(), Theme::Light);
    let notices = hand.window.state().notices().to_vec();
    assert!(notices[0].wrong && notices[0].text.contains("bad.dapple"), "{notices:?}");
}

#[test]
fn the_texture_over_the_sketch_with_tiles() {
    let mut hand = with(example("tile-petals"), SMALL.into(), Theme::Light);
    hand.until_settled();
    hand.window.state_mut().hide_times();
    hand.press("Texture over the sketch");
    see(&mut hand, "divider-light");
    hand.press("Side by side");
    hand.press("Two by two");
    see(&mut hand, "tiles-light");
}
