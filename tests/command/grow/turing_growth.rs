//! The system Turing's growth, driven by a picture or a map, and Lawlor's documents.

use std::path::Path;

use crate::grow::folder::Folder;
use crate::some;
use dapple::ReadFile;
use dapple::document::systems::TURING_GROWTH;
use dapple::document::{Document, Layer, Stroke, SystemChoice};
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::{Tone, ToneImage};
use dapple_engine::grid::{Edges, Field};
use image::GrayImage;
use serde_json::{Value, json};
use test_pictures::portrait::portrait;
use test_pictures::tone_pictures::{ALL, SIDE, illumination, picture, px};

fn image(gray: &GrayImage) -> ToneImage {
    let size = [gray.width() as usize, gray.height() as usize];
    ToneImage::new(size, gray.as_raw().clone()).expect("a small picture")
}

/// A document of 256 × 256 px of Turing's growth, whose marks have the distance of one ellipse.
fn growth(layer: Layer) -> Document {
    let mark = Stroke::ellipse([128.0, 128.0], [2.5, 2.5], 0.0);
    Document::new([256; 2]).with_layer(Layer {
        system: SystemChoice::Of(TURING_GROWTH),
        strokes: vec![mark],
        ..layer
    })
}

fn json_of(document: &Document) -> Value {
    serde_json::from_str(&document.to_json()).expect("JSON")
}

/// The folder of a growth, and the report of `dapple grow` on its layer.
fn grown(document: &Document) -> (Folder, Value) {
    let folder = Folder::with(&json_of(document));
    folder.grow("--report r.json --pattern p.png");
    let layer = folder.json("r.json")["layers"][0].clone();
    (folder, layer)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The share of ink in columns of a pattern.
fn ink(pattern: &Field, columns: std::ops::Range<usize>) -> f64 {
    let px = (0..pattern.height).flat_map(|y| columns.clone().map(move |x| (x, y)));
    let ink: Vec<bool> = px.map(|(x, y)| pattern.values[y * pattern.width + x] >= 0.5).collect();
    ink.iter().filter(|ink| **ink).count() as f64 / ink.len() as f64
}

#[test]
fn a_tone_gets_its_share_of_ink_and_dots_change_to_worms_and_to_holes() {
    println!("| picture | ½ λ | λ |");
    let formulas = some(ALL, 2).into_iter().map(|(name, light)| (name, image(&picture([SIDE; 2], light))));
    for (name, picture) in formulas.chain([("portrait", embedded(PORTRAIT, of_tone))]) {
        let layer = Layer { tone: Some(Tone::new(picture)), ..Layer::default() };
        let document =
            Document::new([320; 2]).with_layer(Layer { system: SystemChoice::Of(TURING_GROWTH), ..layer });
        let (_, report) = grown(&document);
        let [near, far] = [0, 1].map(|blur| number(&report["tone"]["correlation"][blur]));
        let [off_near, off_far] = [0, 1].map(|blur| number(&report["tone"]["difference"][blur]));
        println!("| {name} | {near:.4} / {off_near:.4} | {far:.4} / {off_far:.4} |");
        assert!(near >= 0.985 && far >= 0.995, "{name}: {report}");
        assert!(off_near <= 0.02 && off_far <= 0.01, "{name}: {report}");
        assert_eq!(report["settled"], json!(true), "{name}");
    }
}

#[test]
fn the_share_of_ink_follows_a_map_of_the_growth() {
    // The map has the stored values, from black on the left to white on the right.
    let ramp = GrayImage::from_fn(256, 2, |x, _| image::Luma([x as u8]));
    let source = MapSource::Image { image: image(&ramp), factor: false };
    let layer = Layer::default().with_map(MapKey::Growth, LayerMap { source, range: [18.0, 27.0] });
    let (folder, report) = grown(&growth(layer));
    let pattern = folder.pattern("p.png", Edges::Closed);
    for (columns, wanted) in [(16..48, 0.465), (112..144, 0.60), (208..240, 0.775)] {
        let found = ink(&pattern, columns.clone());
        assert!((found - wanted).abs() < 0.03, "{columns:?}: {found} of {wanted}");
    }
    let [low, high] = [0, 1].map(|end| number(&report["growth"]["range"][end]));
    assert!((low - 18.0).abs() < 0.1 && (high - 27.0).abs() < 0.1, "{report}");
}

#[test]
fn noise_multiplies_the_usual_growth() {
    let source = MapSource::Noise { size: 60.0, octaves: 1 };
    let layer = Layer::default().with_map(MapKey::Growth, LayerMap { source, range: [0.84, 1.2] });
    let (_, report) = grown(&growth(layer));
    let [low, high] = [0, 1].map(|end| number(&report["growth"]["range"][end]));
    assert!((18.4..20.0).contains(&low) && (24.0..26.5).contains(&high), "{report}");
}

#[test]
fn the_same_bytes_grow_on_one_thread_and_on_two() {
    let folder = Folder::with(&json_of(&growth(Layer::default())));
    folder.grow("--threads 1");
    let one = folder.bytes("a.png");
    folder.grow("--threads 2");
    assert!(one == folder.bytes("a.png"));
}

/// The document with the portrait.
const PORTRAIT: &str = "gallery/lawlor-3-photograph-with-its-tone.dapple";

/// A picture in a document of the repository.
fn embedded(file: &str, of: fn(&Layer) -> Option<&ToneImage>) -> ToneImage {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(file);
    let document = Document::read(path).unwrap();
    of(&document.layers[0]).expect("a picture").clone()
}

fn of_growth(layer: &Layer) -> Option<&ToneImage> {
    match &layer.maps.get(MapKey::Growth)?.source {
        MapSource::Image { image, .. } => Some(image),
        MapSource::Noise { .. } => None,
    }
}

fn of_tone(layer: &Layer) -> Option<&ToneImage> {
    Some(&layer.tone.as_ref()?.image)
}

#[test]
fn the_pictures_in_examples_are_rendered_from_our_own_formulas() {
    for (file, of, light) in [
        (PORTRAIT, of_tone as fn(&Layer) -> Option<&ToneImage>, portrait as fn(f64, f64) -> f64),
        ("gallery/lawlor-illumination.dapple", of_growth, illumination),
    ] {
        let found = embedded(file, of);
        assert_eq!(found.size(), [256; 2], "{file}");
        // Only every fourth px of every fourth row, because the portrait takes long.
        let places = (1..256).step_by(4).flat_map(|y| (1..256).step_by(4).map(move |x| [x, y]));
        // The last bits of sines differ between machines.
        let off = |[x, y]: [u32; 2]| {
            f64::from(found.values()[(256 * y + x) as usize].abs_diff(px([256; 2], [x, y], light)))
        };
        let mean = places.map(off).sum::<f64>() / 4_096.0;
        assert!(mean < 0.05, "{file}: {mean}");
    }
    let other = embedded("gallery/lawlor-3-photograph.dapple", of_growth);
    assert_eq!(other.values(), embedded(PORTRAIT, of_tone).values());
}
