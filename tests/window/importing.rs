//! Photographs that become sketches.

use std::path::{Path, PathBuf};

use dapple::ReadFile;
use dapple::app::{Start, Window};
use dapple::document::Document;
use dapple::photograph::{Corners, Framing, Limits, PhotoOptions, Wanted, import_photo};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Pos2, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use image::{Rgb, RgbImage};

use crate::documents::drop_file;
use crate::hand::{Hand, hand, with};
use crate::sights::see;

/// A photograph with dark ellipses on light ground, 7 × 5, with small discs between them, in uneven light.
fn pelt(folder: &Path) -> PathBuf {
    let picture = RgbImage::from_fn(420, 300, |x, y| {
        let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let out = |center: f64, at: f64| (at - center).rem_euclid(60.0) - 30.0;
        let large = 1.0 - (out(0.0, x) / 16.0).hypot(out(0.0, y) / 11.0);
        let small = 1.0 - out(30.0, x).hypot(out(30.0, y)) / 4.5;
        let share = (0.5 + (11.0 * large).max(4.5 * small)).clamp(0.0, 1.0);
        let light = 1.0 - 0.3 * x / 420.0;
        Rgb([225.0 - 175.0 * share, 190.0 - 150.0 * share, 140.0 - 110.0 * share]
            .map(|tone| (light * tone) as u8))
    });
    let path = folder.join("pelt.png");
    picture.save(&path).unwrap();
    path
}

/// A chessboard with squares of 30 px: neither spots nor stripes.
fn chessboard(folder: &Path) -> PathBuf {
    let path = folder.join("board.png");
    let tone = |x: u32, y: u32| if (x / 30 + y / 30).is_multiple_of(2) { [30; 3] } else { [220; 3] };
    RgbImage::from_fn(360, 300, |x, y| Rgb(tone(x, y))).save(&path).unwrap();
    path
}

/// Drops a photograph, asks for a sketch from it, and waits until it is read.
fn drop_photo(hand: &mut Hand, path: &Path) {
    drop_file(hand, path);
    hand.press("Sketch from it");
}

fn options(hand: &Hand) -> PhotoOptions {
    hand.window.state().importing().expect("the dialog is open").options
}

/// The document that the library makes from the photograph.
fn imported(path: &Path, options: PhotoOptions) -> Document {
    import_photo(path, &options).unwrap().document
}

/// The number of whole spots in the dialog.
#[track_caller]
fn spots(hand: &Hand) -> usize {
    let heading = hand.window.get_by_label_contains("whole spots");
    let text =
        heading.accesskit_node().value().or_else(|| heading.accesskit_node().label()).unwrap_or_default();
    text.split(' ').next().and_then(|count| count.parse().ok()).unwrap_or_else(|| panic!("{text}"))
}

fn can_open(hand: &Hand) -> bool {
    !hand.window.get_by_role_and_label(Role::Button, "Open the sketch").accesskit_node().is_disabled()
}

/// Drags from one place on the screen to another.
fn drag(hand: &mut Hand, from: Pos2, to: Pos2) {
    hand.window.hover_at(from);
    hand.window.step();
    hand.window.drag_at(from);
    hand.window.step();
    for step in 1..=4 {
        hand.window.hover_at(from + (to - from) * (step as f32 / 4.0));
        hand.window.step();
    }
    hand.window.drop_at(to);
    hand.rest();
}

/// Drags a slider to a share of its length.
fn slide(hand: &mut Hand, name: &str, share: f32) {
    const LENGTH: f32 = 84.0;
    let rect = hand.window.get_by_role_and_label(Role::Slider, name).rect();
    let at = |share: f32| rect.left_center() + vec2(share * LENGTH, 0.0);
    drag(hand, at(0.5), at(share));
}

#[test]
fn a_photograph_becomes_the_sketch_that_the_library_makes_with_the_photograph_under_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    assert_eq!(options(&hand), PhotoOptions::default());
    assert_eq!(spots(&hand), 35 + 24, "large ones, and the small ones that are whole");
    hand.press("Open the sketch");
    assert_eq!(hand.document(), imported(&path, PhotoOptions::default()));
    assert_eq!(hand.document().layers.len(), 2);
    hand.until("the picture", Window::has_reference);
    let placed = hand.window.state().reference().unwrap();
    assert_eq!((placed.center, placed.scale), ([210.0, 150.0], 1.0));
    let session = hand.window.state().session();
    assert!(session.is_changed() && session.path.is_none() && session.can_undo_redo() == [false, false]);
    assert!(hand.window.state().importing().is_none());
}

#[test]
fn the_smallest_mark_and_the_level_change_what_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    let area = |hand: &Hand| match hand.window.state().importing().unwrap().found().unwrap().picture {
        dapple::output::Picture::Spots { got, .. } => got.area,
        other @ dapple::output::Picture::Stripes { .. } => panic!("{other:?}"),
    };
    slide(&mut hand, "Smallest mark", 0.72);
    let smallest = options(&hand).framing.limits.smallest.expect("it was set");
    assert!((64.0..540.0).contains(&smallest), "{smallest}");
    assert_eq!(spots(&hand), 35);
    let before = area(&hand);
    slide(&mut hand, "Level", 0.9);
    let level = options(&hand).framing.limits.level.expect("it was set");
    assert!(level > 0.75, "{level}");
    assert!(area(&hand) < 0.97 * before, "{} {before}", area(&hand));
    let limits = Limits { level: Some(level), smallest: Some(smallest), ..Limits::default() };
    let wanted =
        PhotoOptions { framing: Framing { limits, ..Framing::default() }, ..PhotoOptions::default() };
    hand.press("Level: default");
    hand.press("Smallest mark: default");
    assert_eq!((options(&hand), spots(&hand)), (PhotoOptions::default(), 59));
    slide(&mut hand, "Smallest mark", 0.72);
    slide(&mut hand, "Level", 0.9);
    hand.press("Open the sketch");
    assert_eq!(hand.document(), imported(&path, wanted));
}

#[test]
fn regions_layers_and_the_other_phase_are_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    hand.press("one");
    hand.press("by number");
    hand.type_into("Region columns", "3");
    hand.type_into("Region rows", "2");
    let wanted = Wanted { regions: Some([3, 2]), layers: Some(1), all_marks: false };
    assert_eq!(options(&hand).wanted, wanted);
    assert!(hand.window.query_by_label_contains("3 × 2 regions").is_some());
    hand.press("none: all marks are drawn");
    hand.press("cover more");
    assert!(options(&hand).framing.invert && options(&hand).wanted.all_marks);
    hand.press("cover less");
    let wanted = Wanted { regions: None, layers: Some(1), all_marks: true };
    hand.press("Open the sketch");
    assert_eq!(hand.document(), imported(&path, PhotoOptions { wanted, ..PhotoOptions::default() }));
    assert_eq!(hand.document().layers[0].strokes.len(), 59);
}

#[test]
fn a_picture_without_a_pattern_is_refused_with_the_reason_and_can_be_taken_anyway() {
    let folder = tempfile::tempdir().unwrap();
    let path = chessboard(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    assert!(hand.window.query_by_label_contains("Neither spots nor stripes: ").is_some());
    assert!(!can_open(&hand));
    hand.key(Modifiers::NONE, Key::Enter);
    assert!(hand.window.state().importing().is_some(), "Enter does not open it either");
    hand.press("Take it anyway");
    assert!(can_open(&hand));
    hand.press("Open the sketch");
    assert_eq!(hand.document(), imported(&path, PhotoOptions { take_it: true, ..PhotoOptions::default() }));
}

#[test]
fn a_picture_without_marks_and_a_file_that_is_no_picture_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let plain = folder.path().join("plain.png");
    RgbImage::from_pixel(200, 160, Rgb([120, 100, 90])).save(&plain).unwrap();
    let broken = folder.path().join("broken.jpg");
    std::fs::write(&broken, "no picture").unwrap();
    for (path, why) in [(plain, "there are no marks"), (broken, "cannot be read as a picture")] {
        let mut hand = hand();
        hand.key(Modifiers::COMMAND, Key::I);
        hand.type_path("File", &path);
        let failure = hand.window.state().importing().unwrap().failure();
        assert!(failure.is_some_and(|failure| failure.contains(why)), "{failure:?}");
        assert!(hand.window.query_by_label_contains(why).is_some());
        assert!(!can_open(&hand));
    }
}

#[test]
fn cancel_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let before = (hand.document(), hand.window.state().session().revision());
    for by_key in [false, true] {
        drop_photo(&mut hand, &path);
        if by_key {
            hand.key(Modifiers::NONE, Key::Escape);
        } else {
            hand.press("Cancel");
        }
        assert!(hand.window.state().importing().is_none());
        assert_eq!((hand.document(), hand.window.state().session().revision()), before);
        assert!(!hand.window.state().has_reference());
    }
    drop_file(&mut hand, &path);
    hand.press("Cancel");
    assert!(hand.window.state().importing().is_none() && !hand.window.state().has_reference());
}

#[test]
fn the_dialog_closes_at_once_while_the_photograph_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_file(&mut hand, &path);
    hand.click_role(Role::Button, "Sketch from it");
    hand.window.step();
    hand.window.step();
    assert!(hand.window.state().importing().is_some());
    hand.window.key_press_modifiers(Modifiers::NONE, Key::Escape);
    hand.window.step();
    hand.window.step();
    assert!(hand.window.state().importing().is_none());
}

#[test]
fn unsaved_work_is_asked_about_before_the_sketch_replaces_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let mine = hand.document();
    drop_photo(&mut hand, &path);
    hand.press("none: all marks are drawn");
    hand.press("Open the sketch");
    assert_eq!(hand.document(), mine, "nothing is lost before the answer");
    hand.press("Cancel");
    assert!(options(&hand).wanted.all_marks, "back in the dialog, with its choices");
    hand.press("Open the sketch");
    hand.press("Save");
    let saved = folder.path().join("mine.dapple");
    hand.type_into("File", saved.to_str().unwrap());
    assert_eq!(Document::read(&saved).unwrap(), mine);
    assert_eq!(hand.document().layers[0].strokes.len(), 35);
}

/// The place of a px of the photograph on the screen.
fn on_screen(hand: &Hand, [x, y]: [f32; 2]) -> Pos2 {
    let dialog = hand.window.state().importing().unwrap();
    let (from, to) = (dialog.corner(0), dialog.corner(2));
    from + vec2(x / 420.0, y / 300.0) * (to - from)
}

#[test]
fn dragged_corners_flatten_the_part_between_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    let places = [[0.0, 0.0], [420.0, 0.0], [420.0, 300.0], [0.0, 300.0]].map(|px| on_screen(&hand, px));
    let wanted = [[31.0, 2.0], [400.0, 11.0], [418.0, 290.0], [4.0, 271.0]];
    let targets = wanted.map(|px| on_screen(&hand, px));
    for (from, to) in places.into_iter().zip(targets) {
        drag(&mut hand, from, to);
    }
    let corners = options(&hand).framing.corners.expect("they were dragged");
    let far = |k: usize| {
        (corners.0[k][0] - f64::from(wanted[k][0])).hypot(corners.0[k][1] - f64::from(wanted[k][1]))
    };
    assert!((0..4).all(|k| far(k) < 1.5), "{corners:?}");
    let framing = Framing { corners: Some(corners), ..Framing::default() };
    hand.press("Open the sketch");
    assert_eq!(hand.document(), imported(&path, PhotoOptions { framing, ..PhotoOptions::default() }));
    let [width, height] = corners.size().map(|side| side.round() as u32);
    assert_eq!(hand.document().size, [width, height]);
    hand.until("the picture", Window::has_reference);
    let placed = hand.window.state().reference().unwrap();
    assert_eq!(placed.center, [f64::from(width) / 2.0, f64::from(height) / 2.0]);
}

#[test]
fn with_shift_the_corners_stay_a_rectangle_and_the_whole_photograph_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_photo(&mut hand, &path);
    let (from, to) = (on_screen(&hand, [420.0, 300.0]), on_screen(&hand, [300.0, 240.0]));
    hand.window.event(egui::Event::ModifiersChanged(Modifiers::SHIFT));
    drag(&mut hand, from, to);
    hand.window.event(egui::Event::ModifiersChanged(Modifiers::NONE));
    let Some(Corners([a, b, c, d])) = options(&hand).framing.corners else { panic!("none") };
    assert_eq!((a, b[1], d[0]), ([0.0, 0.0], 0.0, 0.0));
    assert_eq!((b[0], d[1]), (c[0], c[1]));
    assert!((c[0] - 300.0).abs() < 1.5 && (c[1] - 240.0).abs() < 1.5, "{c:?}");
    assert_eq!(spots(&hand), 20 + 12);
    hand.press("Whole photograph");
    assert_eq!((options(&hand), spots(&hand)), (PhotoOptions::default(), 59));
}

/// A photograph of a grown texture. It has no noise, which would make the stored pictures large.
fn photographed(folder: &Path, example: &str) -> PathBuf {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{example}.dapple"));
    let document = Document::read(file).unwrap();
    let [width, height] = document.size;
    let picture = RgbImage::from_raw(width, height, document.grow().unwrap().rgb()).unwrap();
    let path = folder.join(format!("{example}.jpg"));
    let mut jpeg = Vec::new();
    picture.write_with_encoder(image::codecs::jpeg::JpegEncoder::new_with_quality(&mut jpeg, 92)).unwrap();
    std::fs::write(&path, jpeg).unwrap();
    path
}

fn sight(example: &str, name: &str, size: [f32; 2], theme: Theme) -> Hand {
    let folder = tempfile::tempdir().unwrap();
    let path = photographed(folder.path(), example);
    let mut hand = with(Start::default(), size.into(), theme);
    drop_photo(&mut hand, &path);
    see(&mut hand, name);
    hand
}

#[test]
fn a_pelt_with_its_marks() {
    sight("cheetah-run", "photo-light", [1280.0, 800.0], Theme::Light);
}

#[test]
fn stripes_in_a_small_dark_window() {
    sight("zebra", "photo-dark", [1024.0, 700.0], Theme::Dark);
}

#[test]
fn the_question_what_a_picture_is_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = pelt(folder.path());
    let mut hand = hand();
    drop_file(&mut hand, &path);
    see(&mut hand, "photo-question-light");
}

#[test]
fn a_photograph_taken_upright_lies_upright_under_the_canvas_too() {
    let folder = tempfile::tempdir().unwrap();
    let mut jpeg = Vec::new();
    let wide = image::open(pelt(folder.path())).unwrap().into_rgb8();
    wide.write_with_encoder(image::codecs::jpeg::JpegEncoder::new_with_quality(&mut jpeg, 90)).unwrap();
    // EXIF orientation 6: the photograph is to be rotated by 90°.
    let exif = b"Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
    let length = (exif.len() + 2) as u16;
    let path = folder.path().join("upright.jpg");
    let turned = [&jpeg[..2], &[0xff, 0xe1], &length.to_be_bytes(), &exif[..], &jpeg[2..]].concat();
    std::fs::write(&path, turned).unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &path);
    hand.press("Reference picture");
    hand.until("the picture", Window::has_reference);
    // 300 × 420 px, on a canvas of 512 × 512 px.
    assert_eq!(hand.window.state().reference().unwrap().scale, 512.0 / 420.0);
    drop_photo(&mut hand, &path);
    hand.press("Open the sketch");
    assert_eq!(hand.document().size, [300, 420]);
}

/// Resident memory of this process and its peak so far, MB.
#[cfg(target_os = "linux")]
fn memory() -> [u64; 2] {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    ["VmRSS:", "VmHWM:"].map(|name| {
        let line = status.lines().find(|line| line.starts_with(name)).unwrap();
        line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap() / 1024
    })
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "prints the figures of docs/window.md: time, longest frame and memory of a photograph of 24 Mpx"]
fn a_photograph_of_24_mpx() {
    let folder = tempfile::tempdir().unwrap();
    let tile = image::open(pelt(folder.path())).unwrap().into_rgb8();
    let path = folder.path().join("large.jpg");
    RgbImage::from_fn(6000, 4000, |x, y| *tile.get_pixel(x % 420, y % 300)).save(&path).unwrap();
    let mut hand = hand();
    drop_file(&mut hand, &path);
    let [before, _] = memory();
    let read = |hand: &mut Hand, what: &str| {
        let (began, mut longest) = (std::time::Instant::now(), 0.0_f64);
        while hand.window.state().importing().is_none_or(dapple::app::Importing::is_reading) {
            let frame = std::time::Instant::now();
            hand.window.step();
            longest = longest.max(frame.elapsed().as_secs_f64());
            hand.wait_for_tasks();
        }
        let took = began.elapsed().as_secs_f64();
        println!(
            "{what}: {took:.1} s, longest frame {:.0} ms, memory {:?} MB, {before} before",
            1e3 * longest,
            memory()
        );
    };
    hand.click_role(Role::Button, "Sketch from it");
    hand.window.step();
    read(&mut hand, "opened");
    hand.click_role(Role::RadioButton, "none: all marks are drawn");
    hand.window.step();
    hand.window.step();
    read(&mut hand, "all marks");
    hand.click_role(Role::RadioButton, "cover more");
    hand.window.step();
    hand.window.step();
    read(&mut hand, "the other phase");
}
