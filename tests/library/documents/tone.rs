//! The `tone` of a layer: a gray picture in the document.

use super::*;
use dapple::document::{Drives, Tone, ToneImage};
use dapple::editor::session::Session;

fn image() -> ToneImage {
    let values = (0..35 * 20).map(|px: usize| (px % 35 * 7) as u8).collect();
    ToneImage::new([35, 20], values).unwrap()
}

fn png() -> String {
    image().base64().to_owned()
}

/// The shortest document with a tone, without strokes.
fn driven(tone: &Value) -> Value {
    let mut document = least();
    document["layers"] = json!([{"strokes": [], "tone": tone}]);
    document
}

fn plain() -> Value {
    driven(&json!({"image": {"png": png()}}))
}

#[test]
fn a_tone_has_defaults_and_needs_no_strokes() {
    let document = accepted(&plain());
    assert_eq!(document.layers[0].tone, Some(Tone::new(image())));
    assert!(!document.layers[0].is_blank() && !document.keeps_marks(0));
    let mut without = plain();
    without["layers"][0].as_object_mut().unwrap().remove("tone");
    refused(&without, "layers[0].strokes", "no strokes", "at least one stroke");
}

#[test]
fn a_tone_is_written_as_it_was_read() {
    let tone = json!({"image": {"png": png()}, "range": [0.85, 0.2], "drives": ["direction", "spacing"],
        "sketch": 0.5, "equalise": false});
    let document = accepted(&driven(&tone));
    let read = document.layers[0].tone.as_ref().unwrap();
    assert_eq!(read.drives, Drives { level: false, direction: true, spacing: true });
    assert_eq!((read.range, read.sketch, read.equalise), ([0.85, 0.2], 0.5, false));
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    assert_eq!(written["layers"][0]["tone"], tone);
    assert_eq!(accepted(&written), document);
}

#[test]
fn a_picture_keeps_its_values_and_other_data_of_its_file_is_dropped() {
    // A text chunk between the header and the px, like those that cameras and editors write.
    let bytes = base64_decoded(&png());
    let chunk = |kind: &[u8; 4], data: &[u8]| {
        let body: Vec<u8> = kind.iter().chain(data).copied().collect();
        let length = u32::try_from(data.len()).unwrap().to_be_bytes();
        [&length[..], &body, &crc(&body).to_be_bytes()].concat()
    };
    let told = [&bytes[..33], &chunk(b"tEXt", b"Location\0 52.5, 13.4"), &bytes[33..]].concat();
    let document = accepted(&driven(&json!({"image": {"png": base64_encoded(&told)}})));
    assert_eq!(document.layers[0].tone.as_ref().unwrap().image, image());
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    assert_eq!(written["layers"][0]["tone"]["image"]["png"], json!(png()));
}

#[test]
fn data_that_is_not_a_gray_picture_is_refused_with_the_remedy() {
    let place = "layers[0].tone.image.png";
    let allowed = "a gray PNG of 8 bits and at most 1024 px a side in base64 (dapple grow --tone embeds any picture so)";
    let wrong =
        |png: &str, found: &str| refused(&driven(&json!({"image": {"png": png}})), place, found, allowed);
    wrong("?", "no base64 (Invalid byte 63, offset 0.)");
    let mut wide = Vec::new();
    let encoder = image::codecs::png::PngEncoder::new(&mut wide);
    image::ImageEncoder::write_image(encoder, &[0; 1025], 1025, 1, image::ExtendedColorType::L8).unwrap();
    wrong(&base64_encoded(&wide), "a PNG of 1025×1 px");
    let mut colours = Vec::new();
    let encoder = image::codecs::png::PngEncoder::new(&mut colours);
    image::ImageEncoder::write_image(encoder, &[0; 12], 2, 2, image::ExtendedColorType::Rgb8).unwrap();
    wrong(&base64_encoded(&colours), "a PNG of red, green and blue, 8 bits");
    let message = error_of_text(&driven(&json!({"image": {"png": "R0lGODlh"}})).to_string());
    assert!(message.contains(&format!("{place}: found no whole PNG")), "{message}");
    refused(
        &driven(&json!({"range": [0, 1]})),
        "layers[0].tone",
        "no key \"image\"",
        "\"image\": an object {\"png\": a gray PNG in base64}",
    );
}

#[test]
fn wrong_values_of_a_tone_are_refused() {
    let with = |key: &str, value: Value| {
        let mut document = plain();
        document["layers"][0]["tone"][key] = value;
        document
    };
    let drives = "a list of one or more of level, direction, spacing, each once";
    refused(&with("range", json!([0.1, 1.2])), "layers[0].tone.range[1]", "1.2", "a number from 0 to 1");
    refused(&with("sketch", json!(-1)), "layers[0].tone.sketch", "-1", "a number from 0 to 10");
    refused(&with("equalise", json!(1)), "layers[0].tone.equalise", "1", "true or false");
    refused(&with("drives", json!([])), "layers[0].tone.drives", "nothing", drives);
    refused(&with("drives", json!(["level", "level"])), "layers[0].tone.drives[1]", "\"level\"", drives);
    refused(
        &with("drives", json!(["levels"])),
        "layers[0].tone.drives[0]",
        "\"levels\"",
        "level, direction, spacing (did you mean level?)",
    );
}

#[test]
fn the_editor_keeps_a_layer_without_marks_that_a_picture_drives() {
    let document = accepted(&plain());
    let mut session = Session::open(document.clone(), None);
    assert_eq!(session.finished(), document);
    session.edit(|document| document.seed = 5);
    session.commit();
    assert_eq!(session.finished().layers, document.layers);
    assert_eq!(accepted(&serde_json::from_str(&session.finished().to_json()).unwrap()), session.finished());
}

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

fn base64_encoded(bytes: &[u8]) -> String {
    let group = |three: &[u8]| {
        let all = (0..3).fold(0u32, |all, k| all << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        let letter = |k: u32| char::from(ALPHABET[(all >> (18 - 6 * k) & 63) as usize]);
        (0..4).map(move |k| if k as usize <= three.len() { letter(k) } else { '=' }).collect::<String>()
    };
    bytes.chunks(3).map(group).collect()
}

fn base64_decoded(text: &str) -> Vec<u8> {
    let value = |letter: u8| ALPHABET.iter().position(|one| *one == letter).unwrap_or(0) as u32;
    let mut bytes = Vec::new();
    for four in text.as_bytes().chunks(4) {
        let all = four.iter().fold(0u32, |all, letter| all << 6 | value(*letter));
        let padded = four.iter().filter(|letter| **letter == b'=').count();
        bytes.extend_from_slice(&all.to_be_bytes()[1..4 - padded]);
    }
    bytes
}

fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| crc >> 1 ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 })
    })
}
