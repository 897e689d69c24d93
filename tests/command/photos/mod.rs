//! Photographs → sketches, by the whole command. All pictures are grown or drawn here.

mod degrade;
mod figures;
mod others;
mod pelts;
mod random;
mod round_trip;
mod textures;

use crate::some;
use assert_cmd::Command;
use dapple::ReadFile;
use dapple::document::{Document, Kind, Stroke};
use dapple_engine::attributes::Attributes;
use dapple_engine::marks::turn;
use dapple_engine::photo::{Raster, read};
use image::RgbImage;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

use degrade::degraded;

fn dapple(at: &Path) -> Command {
    let mut dapple = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    dapple.current_dir(at);
    dapple
}

/// Runs a command that must succeed; returns what it prints.
#[track_caller]
fn done(at: &Path, command: &str) -> String {
    let output = dapple(at).args(command.split(' ')).assert().success().get_output().clone();
    String::from_utf8(output.stdout).expect("text")
}

/// Runs a command that must fail with this exit code; returns its message.
#[track_caller]
fn fails(at: &Path, command: &str, code: i32) -> String {
    let output = dapple(at).args(command.split(' ')).assert().code(code).get_output().clone();
    String::from_utf8(output.stderr).expect("text")
}

fn read_document(at: &Path, name: &str) -> Document {
    Document::read(at.join(name)).expect("a document")
}

fn grown(document: &Document) -> RgbImage {
    let [width, height] = document.size;
    RgbImage::from_raw(width, height, document.grow().expect("it grows").rgb()).expect("as many px")
}

/// The mean attributes of what has grown in the first layer, by region.
fn got(document: &Document) -> Vec<Attributes> {
    let report = document.grow().expect("it grows").report();
    report.layers[0].regions.iter().filter_map(|region| region.got).collect()
}

/// A folder with `a.jpg`, a degraded photograph of a document.
fn photographed(document: &Document) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.jpg"), degraded(&grown(document), 3)).expect("written");
    folder
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn spots_are_found_in_a_bad_photograph_with_their_grown_attributes() {
    let document = random::document(0);
    let folder = photographed(&document);
    let printed = json(&done(folder.path(), "import a.jpg -o b.dapple --json"));
    assert_eq!((&printed["kind"], &printed["neither"]), (&Value::from("spots"), &Value::Null));
    let sketch = read_document(folder.path(), "b.dapple");
    assert_eq!((sketch.size, sketch.name.as_str()), (document.size, "a"));
    let strokes = &sketch.layers[0].strokes;
    assert!(strokes.iter().all(|stroke| stroke.kind() == Some(Kind::Ellipse)));
    let [columns, rows] = sketch.regions.expect("regions");
    assert!(strokes.len() <= 7 * (columns * rows) as usize, "{} {columns} {rows}", strokes.len());
    let mean = |document: &Document| {
        let spots: Vec<_> = got(document)
            .into_iter()
            .filter_map(|got| if let Attributes::Spots(spots) = got { Some(spots) } else { None })
            .collect();
        let n = spots.len() as f64;
        let mean = |value: &dyn Fn(usize) -> f64| (0..spots.len()).map(value).sum::<f64>() / n;
        [mean(&|k| spots[k].area), mean(&|k| spots[k].aspect), mean(&|k| spots[k].spacing.unwrap_or(0.0))]
    };
    let ([area, aspect, spacing], back) = (mean(&document), mean(&sketch));
    assert!((back[0] / area - 1.0).abs() < 0.12, "{back:?} {area}");
    assert!((back[1] - aspect).abs() < 0.04, "{back:?} {aspect}");
    assert!((back[2] / spacing - 1.0).abs() < 0.05, "{back:?} {spacing}");
}

#[test]
fn stripes_are_found_with_their_width_direction_and_period() {
    let document = random::document(5);
    let folder = photographed(&document);
    done(folder.path(), "import a.jpg -o b.dapple --regions 1x1 -q");
    let sketch = read_document(folder.path(), "b.dapple");
    assert_eq!(sketch.layers[0].strokes.len(), 3);
    assert!(sketch.layers[0].strokes.iter().all(|stroke| stroke.kind() == Some(Kind::Line)));
    let mean = |document: &Document| {
        let all = got(document);
        let Some(Attributes::Stripes(stripes)) = all.first().copied() else { panic!("{all:?}") };
        stripes
    };
    let whole = Document { regions: Some([1, 1]), ..document };
    let (wanted, back) = (mean(&whole), mean(&sketch));
    assert!((back.width / wanted.width - 1.0).abs() < 0.12, "{back:?} {wanted:?}");
    assert!(turn(back.angle, wanted.angle).abs() < 6.0, "{back:?} {wanted:?}");
}

#[test]
fn measure_and_import_find_the_same_marks() {
    let folder = photographed(&random::document(2));
    let measured = json(&done(folder.path(), "measure a.jpg --json"));
    let imported = json(&done(folder.path(), "import a.jpg -o b.dapple --regions 1x1 --layers 1 --json"));
    assert_eq!(measured["marks"], imported["layers"][0]["found"]);
    let sketch = read_document(folder.path(), "b.dapple");
    let areas = sketch.layers[0].strokes.iter().map(|stroke| match stroke {
        Stroke::Ellipse(ellipse) => ellipse.area(),
        other => panic!("{other:?}"),
    });
    let mean = areas.sum::<f64>() / sketch.layers[0].strokes.len() as f64;
    assert!((mean / measured["area"].as_f64().expect("an area") - 1.0).abs() < 1e-3, "{mean} {measured}");
}

#[test]
fn colours_are_those_of_ground_and_marks() {
    let document = random::document(4);
    let folder = photographed(&document);
    fs::write(folder.path().join("b.png"), png(&grown(&document))).expect("written");
    done(folder.path(), "import b.png -o b.dapple -q");
    let [found, wanted] = [&read_document(folder.path(), "b.dapple"), &document]
        .map(|document| document.layers[0].colours.clone().expect("colours").gradient());
    for at in [0.0, 0.2, 0.8, 1.0] {
        let (found, wanted) = (found.colour(at), wanted.colour(at));
        assert!((0..3).all(|k| found[k].abs_diff(wanted[k]) <= 8), "{at}: {found:?} {wanted:?}");
    }
}

fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).expect("written");
    bytes.into_inner()
}

/// Discs of two sizes on a lattice; every large one has small ones around it.
fn two_sizes() -> RgbImage {
    RgbImage::from_fn(400, 400, |x, y| {
        let far = |x: f64, y: f64| (x.rem_euclid(80.0) - 40.0).hypot(y.rem_euclid(80.0) - 40.0);
        let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let small = far(x + 40.0, y + 40.0).min(far(x + 40.0, y)).min(far(x, y + 40.0));
        let inside = (16.0 - far(x, y)).max(6.0 - small);
        let share = (0.5 + inside).clamp(0.0, 1.0);
        image::Rgb(
            [230.0 - 180.0 * share, 210.0 - 170.0 * share, 180.0 - 160.0 * share].map(|value| value as u8),
        )
    })
}

#[test]
fn two_sizes_become_two_layers_or_one_where_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.jpg"), degraded(&two_sizes(), 1)).expect("written");
    let printed = json(&done(folder.path(), "import a.jpg -o b.dapple --json"));
    let found: Vec<u64> = printed["layers"]
        .as_array()
        .expect("layers")
        .iter()
        .map(|layer| layer["found"].as_u64().expect("a number"))
        .collect();
    // There are 25 large discs. Of the small ones, those on the border are cut.
    assert_eq!(found.len(), 2, "{printed}");
    assert!(found[0] == 25 && (50..=64).contains(&found[1]), "{found:?}");
    done(folder.path(), "import a.jpg -o b.dapple --layers 1 -q");
    assert_eq!(read_document(folder.path(), "b.dapple").layers.len(), 1);
}

#[test]
fn a_picture_of_neither_spots_nor_stripes_is_refused_with_the_reason() {
    let pictures = others::others();
    assert!(pictures.len() >= 40, "{}", pictures.len());
    for (name, picture) in some(pictures, 2) {
        let size = [picture.width() as usize, picture.height() as usize];
        let found = read(&Raster { size, rgb: picture.into_raw(), dpi: None }, false);
        assert!(found.is_err() || found.is_ok_and(|reading| reading.neither.is_some()), "{name} was taken");
    }
}

#[test]
fn a_refusal_names_the_reason_and_the_remedy_and_both_commands_refuse_alike() {
    let folder = tempfile::tempdir().expect("a folder");
    let board =
        others::others().into_iter().find(|(name, _)| name == "chessboard-12").expect("one of them").1;
    fs::write(folder.path().join("board.png"), png(&board)).expect("written");
    let refused = fails(folder.path(), "import board.png -o b.dapple", 1);
    assert!(refused.contains("neither spots nor stripes") && refused.contains("--take-it"), "{refused}");
    assert!(!folder.path().join("b.dapple").exists());
    let measured = fails(folder.path(), "measure board.png", 1);
    let reason = measured.trim_end().split("stripes: ").nth(1).expect("a reason");
    assert!(refused.contains(reason), "{refused} {measured}");
    let taken = json(&done(folder.path(), "import board.png -o b.dapple --take-it --json"));
    assert!(taken["neither"].is_string(), "{taken}");
    read_document(folder.path(), "b.dapple");
}

#[test]
fn all_marks_are_drawn_where_they_are() {
    let folder = photographed(&random::document(6));
    let printed = json(&done(folder.path(), "import a.jpg -o b.dapple --all-marks --json"));
    let sketch = read_document(folder.path(), "b.dapple");
    assert_eq!(sketch.regions, None);
    assert_eq!(printed["layers"][0]["found"].as_u64(), Some(sketch.layers[0].strokes.len() as u64));
    let folder = photographed(&random::document(7));
    done(folder.path(), "import a.jpg -o b.dapple --all-marks -q");
    let sketch = read_document(folder.path(), "b.dapple");
    assert!(sketch.layers[0].strokes.len() > 10, "{}", sketch.layers[0].strokes.len());
    assert!(sketch.layers[0].strokes.iter().all(|stroke| stroke.kind() == Some(Kind::Line)));
}

#[test]
fn a_part_of_a_photograph_has_its_own_size_and_marks() {
    let folder = photographed(&random::document(8));
    let all = json(&done(folder.path(), "import a.jpg -o b.dapple --layers 1 --json"));
    let part = json(&done(folder.path(), "import a.jpg -o c.dapple --layers 1 --crop 100,50,240,300 --json"));
    assert_eq!(part["size"], serde_json::json!([240, 300]));
    let found = |printed: &Value| printed["layers"][0]["found"].as_f64().expect("a number");
    let share = found(&part) / found(&all);
    // Marks near the border are cut, so there are fewer than in proportion to the area.
    assert!((0.3..0.55).contains(&share), "{share}");
    let refused = fails(folder.path(), "import a.jpg -o c.dapple --crop 300,300,200,200", 1);
    assert!(refused.contains("--crop") && refused.contains("384×384"), "{refused}");
}

#[test]
fn an_oblique_photograph_is_flattened_by_its_corners() {
    let folder = tempfile::tempdir().expect("a folder");
    let flat = two_sizes();
    let raster = Raster { size: [400, 400], rgb: flat.into_raw(), dpi: None };
    // The view from the side: a trapezium whose left side is 280 px long and whose right side is 400 px long.
    let oblique = raster.warped([400, 400], |[x, y]| {
        let depth = 400.0 / (280.0 + 120.0 * x / 400.0);
        [x * depth, 200.0 + (y - 200.0) * depth]
    });
    let picture = RgbImage::from_raw(400, 400, oblique.rgb).expect("as many px");
    fs::write(folder.path().join("a.png"), png(&picture)).expect("written");
    let command = "import a.png -o b.dapple --all-marks --layers 1 -q";
    let spread = |command: &str| {
        done(folder.path(), command);
        let sketch = read_document(folder.path(), "b.dapple");
        let large = sketch.layers[0].strokes.iter().filter_map(|stroke| match stroke {
            Stroke::Ellipse(ellipse) if ellipse.area() > 400.0 => Some(ellipse.area()),
            _ => None,
        });
        let areas: Vec<f64> = large.collect();
        let most = areas.iter().copied().fold(0.0, f64::max);
        let least = areas.iter().copied().fold(f64::INFINITY, f64::min);
        (areas.len(), most / least)
    };
    let (_, oblique) = spread(command);
    let (count, flat) = spread(&format!("{command} --corners 0,60,400,0,400,400,0,340"));
    assert!(count == 25 && flat < 1.08 && oblique > 1.5, "{count} {flat} {oblique}");
    let refused = fails(folder.path(), &format!("{command} --corners 0,60,400,400,400,0,0,340"), 1);
    assert!(refused.contains("--corners") && refused.contains("clockwise"), "{refused}");
}

/// A JPEG with this EXIF orientation and 150 px per inch.
fn turned(picture: &RgbImage, orientation: u8) -> Vec<u8> {
    let mut jpeg = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut jpeg, 90);
    picture.write_with_encoder(encoder).expect("written");
    let mut exif = b"Exif\0\0MM\0*\0\0\0\x08\0\x03".to_vec();
    exif.extend([1, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0]);
    exif.extend([1, 0x1a, 0, 5, 0, 0, 0, 1, 0, 0, 0, 50]);
    exif.extend([1, 0x28, 0, 3, 0, 0, 0, 1, 0, 2, 0, 0]);
    exif.extend([0, 0, 0, 0, 0, 0, 0, 150, 0, 0, 0, 1]);
    let length = (exif.len() + 2) as u16;
    [&jpeg[..2], &[0xff, 0xe1], &length.to_be_bytes(), &exif, &jpeg[2..]].concat()
}

#[test]
fn a_photograph_taken_upright_is_turned_and_has_its_resolution() {
    let folder = tempfile::tempdir().expect("a folder");
    let wide = RgbImage::from_fn(360, 240, |x, y| {
        let near = |px: u32, every: f64| (f64::from(px) + 0.5).rem_euclid(every) - 0.5 * every;
        let inside = 1.0 - (near(x, 40.0) / 12.0).hypot(near(y, 30.0) / 6.0);
        let share = (0.5 + 6.0 * inside).clamp(0.0, 1.0);
        image::Rgb([(220.0 - 180.0 * share) as u8; 3])
    });
    fs::write(folder.path().join("a.jpg"), turned(&wide, 6)).expect("written");
    let measured = json(&done(folder.path(), "measure a.jpg --json"));
    assert!(turn(measured["angle"].as_f64().expect("an angle"), 90.0).abs() < 1.0, "{measured}");
    done(folder.path(), "import a.jpg -o b.dapple -q");
    let sketch = read_document(folder.path(), "b.dapple");
    assert_eq!((sketch.size, sketch.dpi), ([240, 360], 150.0));
    done(folder.path(), "import a.jpg -o b.dapple --dpi 72 -q");
    assert_eq!(read_document(folder.path(), "b.dapple").dpi, 72.0);
}

#[test]
fn every_format_gives_the_same_sketch() {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = two_sizes();
    for name in ["a.png", "a.tiff", "a.webp"] {
        picture.save(folder.path().join(name)).expect("written");
    }
    // The content decides, whatever the file name is.
    fs::copy(folder.path().join("a.png"), folder.path().join("a.jpeg")).expect("copied");
    let documents = ["a.png", "a.tiff", "a.webp", "a.jpeg"].map(|name| {
        done(folder.path(), &format!("import {name} -o b.dapple -q"));
        Document { dpi: 1.0, ..read_document(folder.path(), "b.dapple") }
    });
    assert!(documents.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let folder = photographed(&random::document(10));
    let bytes = |threads: &str| {
        let arguments = ["import", "a.jpg", "-o", "b.dapple", "--all-marks", "-q"];
        dapple(folder.path()).args(arguments).env("RAYON_NUM_THREADS", threads).assert().success();
        fs::read(folder.path().join("b.dapple")).expect("written")
    };
    assert_eq!(bytes("1"), bytes("3"));
}

#[test]
fn with_invert_the_marks_are_the_other_phase() {
    let folder = photographed(&random::document(1));
    let measured = |command: &str| {
        let printed = json(&done(folder.path(), command));
        ["width", "wavelength"].map(|key| printed[key].as_f64().expect("a length"))
    };
    let [marks, period] = measured("measure a.jpg --json");
    let [ground, _] = measured("measure a.jpg --json --invert");
    assert!(((marks + ground) / period - 1.0).abs() < 0.05, "{marks} {ground} {period}");
    done(folder.path(), "import a.jpg -o b.dapple --invert --regions 1x1 -q");
    let width = match &read_document(folder.path(), "b.dapple").layers[0].strokes[0] {
        Stroke::Line(line) => line.width,
        Stroke::Path(path) => path.width,
        other => panic!("{other:?}"),
    };
    assert!((width / ground - 1.0).abs() < 0.02, "{width} {ground}");
}

#[test]
fn the_level_moves_the_edge_and_marks_below_the_smallest_area_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.jpg"), degraded(&two_sizes(), 1)).expect("written");
    let areas = |options: &str| {
        done(folder.path(), &format!("import a.jpg -o b.dapple --all-marks --layers 1 -q {options}"));
        let sketch = read_document(folder.path(), "b.dapple");
        let area = |stroke: &Stroke| match stroke {
            Stroke::Ellipse(ellipse) => ellipse.area(),
            other => panic!("{other:?}"),
        };
        sketch.layers[0].strokes.iter().map(area).collect::<Vec<f64>>()
    };
    let mean = |areas: &[f64]| areas.iter().sum::<f64>() / areas.len() as f64;
    let [wide, narrow] =
        ["--level 0.3", "--level 0.7"].map(|level| areas(&format!("{level} --smallest 300")));
    assert_eq!((wide.len(), narrow.len()), (25, 25));
    assert!(mean(&narrow) < 0.95 * mean(&wide), "{} {}", mean(&narrow), mean(&wide));
    let (usual, all) = (areas("--level 0.5"), areas("--level 0.5 --smallest 20"));
    assert!(usual.len() >= 75 && all.len() >= usual.len(), "{} {}", usual.len(), all.len());
    assert!(areas("--smallest 300").iter().all(|area| *area > 600.0));
}

#[test]
fn options_for_photographs_are_refused_with_drawings_and_wrong_values_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let svg =
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><circle cx="4" cy="4" r="2"/></svg>"#;
    fs::write(folder.path().join("in.svg"), svg).expect("written");
    for (options, word) in [
        ("--crop 0,0,4,4", "--crop"),
        ("--layers 3", "--layers"),
        ("--regions 0x2", "COLUMNSxROWS"),
        ("--crop 1,2,3", "X,Y,WIDTH,HEIGHT"),
        ("--corners 1,2,3", "four corners"),
        ("--level 0.5", "--level"),
        ("--level 1", "0.05 to 0.95"),
        ("--smallest 30", "--smallest"),
        ("--smallest 0", "above 0"),
        ("--all-marks --regions 2x2", "--all-marks"),
    ] {
        let message = fails(folder.path(), &format!("import in.svg -o b.dapple {options}"), 2);
        assert!(message.contains(word), "{options}: {message}");
    }
    fs::write(folder.path().join("bad.jpg"), "no picture").expect("written");
    let message = fails(folder.path(), "import bad.jpg -o b.dapple", 1);
    assert!(message.contains("bad.jpg") && message.contains("cannot be read"), "{message}");
}
