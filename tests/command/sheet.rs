//! `dapple sheet` through the real binary: the content of the sheet, also for documents that cannot be grown.

use assert_cmd::Command;
use image::RgbImage;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Writes a document of this size whose spots are red (`#ff0000`) from their edge inwards, and whose ground is green.
fn document(folder: &TempDir, name: &str, [width, height]: [u32; 2]) -> PathBuf {
    let path = folder.path().join(format!("{name}.dapple"));
    let stops = r##"[{"at": 0.5, "colour": "#00ff00"}, {"at": 0.5, "colour": "#ff0000"}]"##;
    let text = format!(
        r#"{{"format": "dapple", "version": 1, "name": "{name}", "size": [{width}, {height}], "layers": [{{
            "strokes": [{{"kind": "ellipse", "center": [32, 32], "radii": [8, 5], "angle": 30}}],
            "colours": {{"stops": {stops}}}}}]}}"#
    );
    fs::write(&path, text).unwrap();
    path
}

fn sheet(files: &[&Path], output: &Path, options: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    command.arg("sheet").args(files).arg("-o").arg(output).args(options).assert()
}

fn read(path: &Path) -> RgbImage {
    image::open(path).unwrap().into_rgb8()
}

/// The number of px close to this colour.
fn count(picture: &RgbImage, colour: [u8; 3]) -> usize {
    let near = |px: &[u8; 3]| px.iter().zip(colour).all(|(a, b)| a.abs_diff(b) < 3);
    picture.pixels().filter(|px| near(&px.0)).count()
}

const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const EMPTY: [u8; 3] = [232, 229, 222];

#[test]
fn each_document_has_its_picture_and_its_name() {
    let folder = TempDir::new().unwrap();
    let [wide, high] = [document(&folder, "wide", [128, 64]), document(&folder, "high", [64, 128])];
    let output = folder.path().join("sheet.png");
    sheet(&[&wide, &high], &output, &["--thumb", "96", "--columns", "2"]).success();
    let picture = read(&output);
    // Two tiles of 96 px with a gap of 8 beside and between them.
    assert_eq!(picture.width(), 8 + 96 + 8 + 96 + 8);
    let [left, right] =
        [8, 112].map(|x| image::imageops::crop_imm(&picture, x, 0, 96, picture.height()).to_image());
    for tile in [left, right] {
        let painted = count(&tile, RED) + count(&tile, GREEN);
        assert!((2000..=96 * 48).contains(&painted), "{painted} px of 96 × 48 or 48 × 96");
        assert!(count(&tile, RED) > 100 && count(&tile, GREEN) > 1000);
        let dark = tile.pixels().filter(|px| px.0.iter().all(|value| *value < 90)).count();
        assert!(dark > 20, "no name is written: {dark} dark px");
    }
}

#[test]
fn the_place_of_a_document_that_cannot_be_grown_stays_empty() {
    let folder = TempDir::new().unwrap();
    let good = document(&folder, "good", [64, 64]);
    let broken = folder.path().join("broken.dapple");
    fs::write(&broken, "{").unwrap();
    let alone = document(&folder, "alone", [64, 64]);
    let inside =
        fs::read_to_string(&alone).unwrap().replace(r#""strokes""#, r#""after": "inside", "strokes""#);
    fs::write(
        &alone,
        inside.replacen(
            r#"[{"#,
            r#"[{"after": "between", "strokes": [{"kind": "line", "from": [9, 9], "to": [50, 9]}]}, {"#,
            1,
        ),
    )
    .unwrap();
    let output = folder.path().join("sheet.png");
    let options = ["--thumb", "64", "--columns", "3"];
    let outcome = sheet(&[&broken, &good, &alone], &output, &options).code(1).get_output().clone();
    let message = String::from_utf8(outcome.stderr).unwrap();
    for word in ["error: 2 of 3", "sheet.png", "broken.dapple", "alone.dapple", "layer beneath grows stripes"]
    {
        assert!(message.contains(word), "{word} in {message}");
    }
    let picture = read(&output);
    let tiles: Vec<_> =
        (0..3).map(|tile| image::imageops::crop_imm(&picture, 5 + 69 * tile, 5, 64, 64).to_image()).collect();
    assert_eq!([0, 1, 2].map(|tile| count(&tiles[tile], EMPTY) > 1000), [true, false, true]);
    assert!(count(&tiles[1], GREEN) > 1000);
}

#[test]
fn seeds_stand_side_by_side() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", [96, 96]);
    let [three, one] = ["three.png", "one.png"].map(|name| folder.path().join(name));
    sheet(&[&file], &three, &["--thumb", "96", "--seeds", "3"]).success();
    sheet(&[&file], &one, &["--thumb", "96"]).success();
    let [three, one] = [read(&three), read(&one)];
    let tile = |picture: &RgbImage, x| image::imageops::crop_imm(picture, x, 8, 96, 96).to_image();
    let tiles = [8, 106, 204].map(|x| tile(&three, x));
    assert_eq!(tiles[0], tile(&one, 8), "the first is the document's own seed");
    assert!(tiles[0] != tiles[1] && tiles[1] != tiles[2]);
    assert!(tiles.iter().all(|tile| count(tile, GREEN) > 1000));
}

#[test]
fn lit_pictures_show_a_relief() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", [96, 96]);
    let pictures = ["--quiet", "--lit", "--lit=-4"].map(|option| {
        let output = folder.path().join(format!("{option}.png"));
        sheet(&[&file], &output, &["--thumb", "96", option]).success();
        image::imageops::crop_imm(&read(&output), 8, 8, 96, 96).to_image()
    });
    let [plain, raised, hollow] = &pictures;
    let sum = |picture: &RgbImage, x: u32, y: u32| {
        picture.get_pixel(x, y).0.iter().map(|value| i64::from(*value)).sum::<i64>()
    };
    let is_red = |x: u32, y: u32| plain.get_pixel(x, y).0[0] > 200;
    // The difference in brightness of slopes between raised and hollow marks, where a spot ends to the upper left and
    // to the lower right.
    let mut brighter = [0; 2];
    for (x, y) in (3..93).flat_map(|x| (3..93).map(move |y| (x, y))).filter(|(x, y)| is_red(*x, *y)) {
        let difference = sum(raised, x, y) - sum(hollow, x, y);
        for (side, beyond) in [is_red(x - 3, y - 3), is_red(x + 3, y + 3)].into_iter().enumerate() {
            brighter[side] += if beyond { 0 } else { difference };
        }
    }
    assert!(brighter[0] > 1_000 && brighter[1] < -1_000, "{brighter:?}");
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", [96, 64]);
    let bytes = ["1", "3"].map(|threads| {
        let output = folder.path().join(format!("{threads}.png"));
        sheet(&[&file], &output, &["--threads", threads, "--thumb", "50"]).success();
        fs::read(output).unwrap()
    });
    assert!(bytes[0] == bytes[1]);
}

#[test]
fn impossible_options_are_refused_before_anything_grows() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", [64, 64]);
    let output = folder.path().join("sheet.png");
    let refused = |files: &[&Path], output: &Path, options: &[&str], code: i32, words: &[&str]| {
        let outcome = sheet(files, output, options).code(code).get_output().clone();
        let message = String::from_utf8(outcome.stderr).unwrap();
        for word in words {
            assert!(message.contains(word), "{word} in {message}");
        }
    };
    refused(&[], &output, &[], 2, &["<FILE>"]);
    refused(&[&file], &file, &[], 2, &["--output", "spots.dapple", "two files"]);
    refused(&[&file], &output, &["--columns", "0"], 2, &["--columns", "1 to 1000"]);
    refused(&[&file], &output, &["--seeds", "0"], 2, &["--seeds", "1 to 1000"]);
    refused(&[&file], &output, &["--thumb", "8"], 2, &["--thumb", "32"]);
    refused(&[&file], &output, &["--lit=high"], 2, &["--lit", "-100000 to 100000"]);
    refused(&[&file], &output, &["--thumb", "4096", "--seeds", "900"], 2, &["px", "--thumb"]);
    refused(&[&file], &folder.path().join("no/sheet.png"), &[], 1, &["does not exist"]);
    refused(&[&file], &output.with_extension("gif"), &[], 1, &[".png"]);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "only the document is there");
}
