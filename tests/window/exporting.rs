//! The export dialog: what it shows is what it writes, and that is what `dapple grow` and `dapple film` write.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assert_cmd::Command;
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

/// Opens the dialog at one of its kinds.
fn open(hand: &mut Hand, kind: &str) {
    hand.key(Modifiers::COMMAND, Key::E);
    hand.press(kind);
}

/// Takes one of a list.
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
    hand.window.get_by_role_and_label(Role::Button, text).click();
    hand.rest();
}

/// What is seen, once it is made.
fn seen(hand: &mut Hand) -> Arc<FinishedPreview> {
    hand.until("a preview", |window| window.previewed().is_some());
    hand.window.state().previewed().unwrap()
}

/// Writes it, and waits.
fn write(hand: &mut Hand, path: &Path) {
    hand.press("Export…");
    let into = hand.window.query_by_role_and_label(Role::TextInput, "File").is_none();
    hand.type_path(if into { "Folder" } else { "File" }, path);
    hand.until("written", |window| window.notices().iter().any(|notice| notice.text.contains("Written")));
    assert!(hand.window.state().notices().iter().all(|notice| !notice.wrong));
    hand.rest();
    hand.press("OK");
}

/// By a reader of its own kind, not by what made the preview.
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

/// What the command line writes of the same document.
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
fn pictures_of_every_format_equal_the_preview_and_those_of_the_command_line() {
    for (format, name, options) in [
        ("PNG", "x.png", &[][..]),
        ("TIFF", "x.tif", &[]),
        ("JPEG", "x.jpg", &[]),
        ("WebP", "x.webp", &[]),
        ("OpenEXR", "x.exr", &[]),
    ] {
        let (mut hand, folder) = small();
        open(&mut hand, "Picture");
        if format != "PNG" {
            take(&mut hand, "Format", format);
        }
        let made = seen(&mut hand);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if format != "OpenEXR" {
            same(&made.pictures()[0].1, &path);
        }
        let other = grown(folder.path(), &format!("cli-{name}"), options);
        assert!(fs::read(&path).unwrap() == fs::read(other).unwrap(), "{format}");
    }
}

#[test]
fn a_transparent_picture_of_16_bit_equals_the_preview_and_an_exr_looks_like_it() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.press("16 bit");
    hand.press("transparent");
    let made = seen(&mut hand);
    let image = made.pictures()[0].1.clone();
    assert!(image.pixels.iter().any(|px| px.a() == 0) && image.pixels.iter().any(|px| px.a() == 255));
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    same(&image, &path);
    let other = grown(folder.path(), "cli.png", &["--depth", "16", "--transparent"]);
    assert_eq!(fs::read(&path).unwrap(), fs::read(other).unwrap());

    hand.key(Modifiers::COMMAND, Key::E);
    take(&mut hand, "Format", "OpenEXR");
    let light = seen(&mut hand).pictures()[0].1.clone();
    let near = |(a, b): (&egui::Color32, &egui::Color32)| {
        a.to_array().into_iter().zip(b.to_array()).all(|(a, b)| a.abs_diff(b) <= 2)
    };
    assert!(light.pixels.iter().zip(&image.pixels).all(near));
}

#[test]
fn patterns_labels_and_concentrations_are_written_from_the_dialog() {
    let (mut hand, folder) = small();
    for (shows, name, option) in [
        ("The pattern, 0 to 1", "p.png", "--pattern"),
        ("Labels, a number a layer", "l.png", "--labels"),
        ("Concentrations", "c.exr", "--concentrations"),
    ] {
        open(&mut hand, "Picture");
        take(&mut hand, "Shows", shows);
        if option == "--concentrations" {
            hand.press("Show it");
        }
        let made = seen(&mut hand);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if name.ends_with("png") {
            same(&made.pictures()[0].1, &path);
        } else {
            assert!(made.pictures().len() >= 2, "a picture a chemical");
        }
        let other = folder.path().join(format!("cli-{name}"));
        grown(folder.path(), "t.png", &[option, other.to_str().unwrap()]);
        assert!(decoded_or_bytes(&path) == decoded_or_bytes(&other), "{shows}");
    }
}

/// The px where it is a PNG, which may hold a document too; else all bytes.
fn decoded_or_bytes(path: &Path) -> Vec<u8> {
    match image::open(path) {
        Ok(image) => image.into_bytes(),
        Err(_) => fs::read(path).unwrap(),
    }
}

#[test]
fn larger_pictures_have_a_smaller_preview_and_are_written_in_full_size() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.type_into("Scale", "30");
    let made = seen(&mut hand);
    assert!(!made.whole && made.pictures()[0].1.size[0] < 30 * 96);
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    assert_eq!(decoded(&path).size, [30 * 96, 30 * 80]);
}

#[test]
fn more_texture_is_grown_for_the_preview_and_not_again_for_the_file() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.press("More texture");
    hand.press("Show it");
    let made = seen(&mut hand);
    assert_eq!(made.pictures()[0].1.size, [192, 160]);
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    same(&made.pictures()[0].1, &path);
    let other = grown(folder.path(), "cli.png", &["--size", "192x160"]);
    assert_eq!(fs::read(&path).unwrap(), fs::read(other).unwrap());
}

#[test]
fn every_map_of_a_material_equals_its_preview() {
    let (mut hand, folder) = small();
    open(&mut hand, "Material");
    hand.type_into("Relief of spots", "9");
    let made = seen(&mut hand);
    let path = folder.path().join("maps");
    write(&mut hand, &path);
    assert!(made.pictures().len() >= 9);
    for (name, image) in made.pictures() {
        same(image, &path.join(format!("a_{name}.png")));
    }
    let (plane, _, images) = gltf::import(path.join("a.gltf")).unwrap();
    assert_eq!((plane.meshes().len(), images.len()), (1, 3));
    let other = folder.path().join("cli");
    grown(folder.path(), "", &["--material", other.to_str().unwrap(), "--relief", "9"]);
    for file in fs::read_dir(&other).unwrap().flatten() {
        let written = fs::read(path.join(file.file_name())).unwrap();
        assert!(written == fs::read(file.path()).unwrap(), "{:?}", file.file_name());
    }
}

#[test]
fn outlines_drawn_by_another_renderer_look_like_the_preview() {
    let (mut hand, folder) = small();
    open(&mut hand, "Outlines");
    hand.press("hatch");
    hand.press("stroke");
    hand.type_into("Spacing of the hatch", "0.2");
    hand.type_into("Pen", "0.06");
    let made = seen(&mut hand);
    let path = folder.path().join("x.svg");
    write(&mut hand, &path);
    let told = made.message.clone().unwrap();
    assert!(told.contains("in the air"), "{told}");
    let options = usvg::Options::default();
    let tree = usvg::Tree::from_data(&fs::read(&path).unwrap(), &options).unwrap();
    let seen = &made.pictures()[0].1;
    let mut paper = resvg::tiny_skia::Pixmap::new(seen.size[0] as u32, seen.size[1] as u32).unwrap();
    paper.fill(resvg::tiny_skia::Color::WHITE);
    let scale = seen.size[0] as f32 / tree.size().width();
    resvg::render(&tree, resvg::tiny_skia::Transform::from_scale(scale, scale), &mut paper.as_mut());
    let off: u64 = seen
        .pixels
        .iter()
        .zip(paper.pixels())
        .map(|(a, b)| u64::from(a.r().abs_diff(b.red())) + u64::from(a.b().abs_diff(b.blue())))
        .sum();
    let mean = off as f64 / (2.0 * seen.pixels.len() as f64);
    assert!(mean < 2.0, "they differ by {mean} of 255 in the mean");

    let options = ["--style", "fill,stroke,hatch:0.2:45", "--pen", "0.06"];
    let other = grown(folder.path(), "cli.svg", &options);
    assert_eq!(fs::read_to_string(&path).unwrap(), fs::read_to_string(other).unwrap());

    open(&mut hand, "Outlines");
    hand.press("DXF");
    let path = folder.path().join("x.dxf");
    seen_again(&mut hand, &path);
    assert!(dxf::Drawing::load_file(&path).unwrap().entities().count() > 2);
}

fn seen_again(hand: &mut Hand, path: &Path) {
    seen(hand);
    write(hand, path);
}

#[test]
fn strokes_are_cut_only_where_nothing_is_filled() {
    let (mut hand, _folder) = small();
    open(&mut hand, "Outlines");
    hand.press("stroke");
    hand.press("fill");
    hand.press("cut");
    assert!(hand.window.state().choices().unwrap().outlines.cut);
    hand.press("fill");
    assert!(!hand.window.state().choices().unwrap().outlines.cut);
}

#[test]
fn lengths_are_converted_when_their_unit_changes() {
    let (mut hand, _folder) = small();
    open(&mut hand, "Outlines");
    hand.press("px");
    let outlines = hand.window.state().choices().unwrap().outlines;
    // 300 dpi.
    assert!((outlines.pen - 0.3 * 300.0 / 25.4).abs() < 1e-3, "{}", outlines.pen);
}

#[test]
fn a_film_plays_in_the_preview_and_is_written_as_shown() {
    for (format, name) in [("GIF", "x.gif"), ("Animated PNG", "x.png"), ("Single PNG, in a folder", "frames")]
    {
        let (mut hand, folder) = small();
        open(&mut hand, "Film");
        if format != "GIF" {
            take(&mut hand, "Format of the film", format);
        }
        hand.type_into("Length", "0.4");
        hand.press("Make the film");
        let made = seen(&mut hand);
        assert_eq!(made.frames().len(), 8);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if path.is_dir() {
            for (index, (frame, _)) in made.frames().iter().enumerate() {
                same(frame, &path.join(format!("frame-{:04}.png", index + 1)));
            }
            continue;
        }
        let dapple = assert_cmd::cargo::cargo_bin!("dapple");
        let other = folder.path().join(format!("cli-{name}"));
        let mut film = Command::new(dapple);
        film.arg("film").arg(folder.path().join("a.dapple")).arg("-o").arg(&other);
        film.args(["--seconds", "0.4", "-q"]).assert().success();
        assert!(fs::read(&path).unwrap() == fs::read(&other).unwrap(), "{format}");
        if format != "GIF" {
            // The first frame of an animated PNG is what readers of plain ones see.
            same(&made.frames()[0].0, &path);
        }
    }
}

#[test]
fn one_document_becomes_another_in_a_film() {
    let (mut hand, folder) = small();
    let other = folder.path().join("other.dapple");
    let text = r#"{"format": "dapple", "version": 1, "size": [96, 80], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [40, 40], "radii": [7, 6], "angle": 80}]}]}"#;
    Document::parse(text, "other").unwrap().write(&other).unwrap();
    open(&mut hand, "Film");
    hand.press("The change into another document");
    hand.press("Choose a document…");
    hand.type_path("File", &other);
    hand.type_into("Length", "0.3");
    hand.press("Make the film");
    let made = seen(&mut hand);
    assert_eq!(made.frames().len(), 6);
    let path = folder.path().join("x.gif");
    write(&mut hand, &path);
    let dapple = assert_cmd::cargo::cargo_bin!("dapple");
    let cli = folder.path().join("cli.gif");
    let mut film = Command::new(dapple);
    film.arg("film").arg(folder.path().join("a.dapple")).arg("-o").arg(&cli).arg("--to").arg(&other);
    film.args(["--seconds", "0.3", "-q"]).assert().success();
    assert_eq!(fs::read(&path).unwrap(), fs::read(&cli).unwrap());
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
    hand.press("Make the film");
    let mut found = false;
    for _ in 0..2000 {
        hand.window.step();
        found = hand.window.query_by_label_contains("one has spots and the other stripes").is_some();
        if found {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
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
