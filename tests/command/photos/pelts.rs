//! Grown pelts, photographed, as documents, and grown again: what is measured stays.

use std::fs;
use std::path::Path;

use dapple::document::{Document, Finish, FinishKind, Finishing, FlowChoice};
use dapple_engine::marks::turn;
use dapple_engine::measure::Picture;
use dapple_engine::photo::{Raster, Reading, read};
use image::RgbImage;

use crate::photos::{done, grown, read_document};

/// How far the camera moves px by waves of [`WAVE`] px, px.
const WARP: f64 = 2.0;
const WAVE: f64 = 170.0;
/// Light at the darker side ÷ that at the lighter one.
const DARKER: f64 = 0.7;
/// Quality of the JPEG.
const QUALITY: u8 = 85;

/// The JPEG of a picture that is warped by a few px and lit from one side.
fn photograph(picture: &RgbImage) -> Vec<u8> {
    let size = [picture.width() as usize, picture.height() as usize];
    let raster = Raster { size, rgb: picture.as_raw().clone(), dpi: None };
    let wave = |at: f64| WARP * (at * std::f64::consts::TAU / WAVE).sin();
    let mut warped = raster.warped(size, |[x, y]| [x + wave(y + 20.0), y + wave(x)]);
    for (at, channel) in warped.rgb.iter_mut().enumerate() {
        let across = (at / 3 % size[0]) as f64 / size[0] as f64;
        *channel = (f64::from(*channel) * (DARKER + (1.0 - DARKER) * across)) as u8;
    }
    let picture = RgbImage::from_raw(picture.width(), picture.height(), warped.rgb).expect("as many px");
    let mut bytes = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, QUALITY);
    picture.write_with_encoder(encoder).expect("a picture can be written as JPEG");
    bytes
}

/// What a photograph of a picture shows.
fn seen(picture: &RgbImage) -> Reading {
    let picture = image::load_from_memory(&photograph(picture)).expect("a JPEG").into_rgb8();
    let size = [picture.width() as usize, picture.height() as usize];
    read(&Raster { size, rgb: picture.into_raw(), dpi: None }, false).expect("marks")
}

/// The share of the picture that is ink.
fn ink(reading: &Reading) -> f64 {
    let (field, level) = match &reading.rosettes {
        Some(rosettes) => (&rosettes.ink, rosettes.level),
        None => (&reading.segmentation.field, reading.segmentation.level),
    };
    field.values.iter().filter(|value| **value > level).count() as f64 / field.values.len() as f64
}

/// Area, spacing, raggedness and share of ink of the marks in a photograph, and their direction.
fn measured(reading: &Reading) -> ([f64; 4], f64) {
    let Picture::Spots { got, raggedness, .. } = reading.picture else { panic!("{:?}", reading.picture) };
    let spacing = got.spacing.expect("a spacing");
    ([got.area, spacing, raggedness.unwrap_or(1.0), ink(reading)], got.angle)
}

/// A pelt of one layer on a tile.
fn pelt(layer: &str) -> Document {
    let text = format!(
        r#"{{"format": "dapple", "version": 2, "size": [448, 448], "edges": "wrap", "seed": 3, "layers": [{layer}]}}"#
    );
    Document::parse(&text, "pelt").expect("a pelt")
}

const STROKES: &str = r#""strokes": [
    {"kind": "ellipse", "center": [200, 200], "radii": [22, 15], "angle": 20},
    {"kind": "ellipse", "center": [254, 205], "radii": [22, 15], "angle": 25},
    {"kind": "ellipse", "center": [226, 252], "radii": [22, 15], "angle": 30}
]"#;

/// Imports a photograph of the pelt, and compares that of what grows from it: no attribute changes by more than `most`.
fn comes_back(name: &str, pelt: &Document, most: f64) -> (Reading, Document) {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = grown(pelt);
    fs::write(folder.path().join("a.jpg"), photograph(&picture)).expect("written");
    done(folder.path(), "import a.jpg -o b.dapple -q");
    let sketch = read_document(folder.path(), "b.dapple");
    let before = seen(&picture);
    let ((was, from), (is, to)) = (measured(&before), measured(&seen(&grown(&sketch))));
    for (attribute, (was, is)) in ["area", "spacing", "raggedness", "share"].iter().zip(was.iter().zip(&is)) {
        println!("{name}: {attribute} {was:.3} → {is:.3}");
    }
    for (attribute, (was, is)) in ["area", "spacing", "raggedness", "share"].iter().zip(was.iter().zip(&is)) {
        assert!((is / was - 1.0).abs() < most, "{name}: {attribute} {was} → {is}");
    }
    assert!(turn(from, to).abs() < 5.0, "{name}: direction {from} → {to}");
    (before, sketch)
}

#[test]
fn ragged_patches_come_back_from_a_photograph() {
    let options = r#""system": "patches", "options": {"keep": false, "ragged": 0.25}"#;
    let (before, _) = comes_back("patches", &pelt(&format!("{{{STROKES}, {options}}}")), 0.1);
    assert!(before.rosettes.is_none());
}

#[test]
fn rosettes_come_back_from_a_photograph() {
    let options = r#""system": "patches", "options": {"keep": false, "ragged": 0.1, "rosette": {"width": 8, "solid": 0.15}}"#;
    let (before, sketch) = comes_back("rosettes", &pelt(&format!("{{{STROKES}, {options}}}")), 0.1);
    let found = before.rosettes.expect("rosettes").like;
    assert!(found.parts[0] >= 2 && (4..=6).contains(&found.parts[1]), "{found:?}");
    assert!((found.width.expect("a width") / 8.0 - 1.0).abs() < 0.1, "{found:?}");
    assert!(sketch.layers[0].options.rosette.is_some());
}

/// The direction that the finish gets from a photograph of a pelt with hair at `angle`.
fn hair(folder: &Path, angle: f64) -> FlowChoice {
    let spots = r#""system": "patches", "options": {"keep": false}"#;
    let finish = Finish { size: 10.0, ..Finish::new(FinishKind::Fur) };
    let finish = Finishing { flow: FlowChoice::Angle(angle), ..finish.into() };
    let document = Document { finish: Some(finish), ..pelt(&format!("{{{STROKES}, {spots}}}")) };
    fs::write(folder.join("a.jpg"), photograph(&grown(&document))).expect("written");
    done(folder, "import a.jpg -o b.dapple --finish fur -q");
    read_document(folder, "b.dapple").finish.expect("a finish").flow
}

#[test]
fn hair_lies_as_in_the_photograph() {
    let folder = tempfile::tempdir().expect("a folder");
    for angle in [120.0, 190.0] {
        let flow = hair(folder.path(), angle);
        let FlowChoice::Angle(found) = flow else { panic!("{angle}: {flow:?}") };
        assert!((found - angle).abs() < 6.0, "{angle}: {found}");
    }
}

#[test]
fn flat_colours_have_no_direction_of_hair() {
    let folder = tempfile::tempdir().expect("a folder");
    let spots = r#""system": "patches", "options": {"keep": false}"#;
    fs::write(folder.path().join("a.jpg"), photograph(&grown(&pelt(&format!("{{{STROKES}, {spots}}}")))))
        .expect("written");
    done(folder.path(), "import a.jpg -o b.dapple --finish fur -q");
    let finish = read_document(folder.path(), "b.dapple").finish.expect("a finish");
    assert_eq!(finish.flow, FlowChoice::Usual);
    done(folder.path(), "import a.jpg -o b.dapple -q");
    assert!(read_document(folder.path(), "b.dapple").finish.is_none());
}

#[test]
fn a_ground_of_two_colours_comes_back_at_its_places() {
    let folder = tempfile::tempdir().expect("a folder");
    let ramp = image::GrayImage::from_fn(16, 2, |x, _| image::Luma([(x * 17) as u8]));
    ramp.save(folder.path().join("ramp.png")).expect("written");
    let colours = r##""colours": {"stops": [{"at": 0, "colour": "#c87830"}, {"at": 0.45, "colour": "#c87830"}, {"at": 0.55, "colour": "#1c120c"}], "ground": "#f4ecdc"}"##;
    fs::write(folder.path().join("a.dapple"), pelt(&format!("{{{STROKES}, {colours}}}")).to_json())
        .expect("written");
    done(folder.path(), "grow a.dapple -o a.png --map ground=ramp.png:0:1 -q");
    done(folder.path(), "import a.png -o b.dapple -q");
    let sketch = read_document(folder.path(), "b.dapple");
    assert!(sketch.layers[0].maps.get(dapple::document::MapKey::Ground).is_some());
    // The lightest px of the left and of the right quarter are ground.
    let sides = |picture: &RgbImage| {
        [0, picture.width() * 3 / 4].map(|left| {
            let px =
                picture.enumerate_pixels().filter(|(x, _, _)| (left..left + picture.width() / 4).contains(x));
            let mut green: Vec<u8> = px.map(|(_, _, px)| px.0[1]).collect();
            green.sort_unstable();
            f64::from(green[green.len() * 3 / 4])
        })
    };
    let before = sides(&image::open(folder.path().join("a.png")).expect("a picture").into_rgb8());
    let after = sides(&grown(&sketch));
    assert!(before[1] - before[0] > 60.0, "{before:?}");
    for (before, after) in before.iter().zip(&after) {
        assert!((before - after).abs() < 20.0, "{before} {after}");
    }
}
