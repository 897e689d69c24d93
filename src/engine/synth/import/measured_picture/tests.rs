//! Pictures that are measured, and pictures that are refused.

use super::*;
use crate::colour::{BY_LAYER, Bend, COATS, Set, Stop};
use crate::document::{Document, Extent, Layer, Stroke};
use crate::export::png::{self, Header, Samples};
use std::io::Cursor;

/// Measures a picture, written in the format of the ending of `name`.
fn measured(name: &str, picture: &DynamicImage, invert: bool) -> Result<Picture, MeasureError> {
    let mut file = Cursor::new(Vec::new());
    picture.write_to(&mut file, image::ImageFormat::from_path(name).unwrap()).unwrap();
    file.set_position(0);
    measured_stream(file, name, invert, None)
}

fn measured_stream(
    file: Cursor<Vec<u8>>,
    name: &str,
    invert: bool,
    free: Option<f64>,
) -> Result<Picture, MeasureError> {
    let framing = Framing { invert, ..Framing::default() };
    measure_stream(file, Path::new(name), &framing, free).map(|measured| measured.picture)
}

/// The gray value 0..1 of a lightness in OKLab, in which edges lie halfway: L³ as linear light, encoded by sRGB.
fn gray(lightness: f64) -> f64 {
    let light = lightness.powi(3);
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// Ellipses of radii 9 and 6 along 30° on a lattice of 32 px; `tone` gives the tone by the distance out from the centre.
fn dots(tone: impl Fn(f64) -> f64) -> image::ImageBuffer<image::Luma<u16>, Vec<u16>> {
    image::ImageBuffer::from_fn(256, 256, |x, y| {
        let near = |x: u32| (f64::from(x) + 0.5).rem_euclid(32.0) - 16.0;
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let (x, y) = (near(x), near(y));
        let out = ((x * cos + y * sin) / 9.0).hypot((y * cos - x * sin) / 6.0);
        image::Luma([(65535.0 * tone(out)) as u16])
    })
}

#[test]
fn a_pattern_is_measured_at_one_half_and_other_pictures_between_their_tones() {
    let soft = |out: f64| (0.5 + 0.7 * (1.0 - out)).clamp(0.0, 1.0);
    let ink = |out: f64| gray(0.9 - 0.6 * (0.5 + 3.0 * (1.0 - out)).clamp(0.0, 1.0));
    let colour = DynamicImage::ImageLuma16(dots(ink)).to_rgb8();
    for (name, image) in [
        ("pattern.png", DynamicImage::ImageLuma16(dots(soft))),
        ("ink.png", DynamicImage::ImageRgb8(colour.clone())),
        ("ink.bmp", DynamicImage::ImageRgb8(colour)),
    ] {
        let Picture::Spots { marks, got, .. } = measured(name, &image, false).unwrap() else {
            panic!("{name}")
        };
        assert_eq!(marks, 64, "{name}");
        assert!((got.area / (54.0 * std::f64::consts::PI) - 1.0).abs() < 0.01, "{name} {got:?}");
        assert!((got.aspect - 2.0 / 3.0).abs() < 0.005, "{name} {got:?}");
        assert!((got.angle - 30.0).abs() < 0.3, "{name} {got:?}");
        assert!((got.spacing.unwrap() / 32.0 - 1.0).abs() < 0.01, "{name} {got:?}");
    }
}

/// A pattern of stripes of 12 px every 24 px.
fn stripes() -> impl Iterator<Item = f32> {
    let across = |px: u32| 0.8 * f64::from(px % 240) + 0.6 * f64::from(px / 240);
    (0..240 * 240).map(move |px| (0.5 - 0.48 * (across(px) * std::f64::consts::TAU / 24.0).cos()) as f32)
}

fn gradient(stops: &[(f32, [u8; 3])], bend: [f64; 4]) -> Gradient {
    let stops: Vec<_> = stops.iter().map(|(at, colour)| Stop::opaque(*at, *colour)).collect();
    Gradient { bends: vec![Bend(bend); stops.len() - 1], stops }
}

/// Width of the stripes in a PNG with this text, painted with a gradient.
fn painted_width(gradient: &Gradient, texts: &[(&'static str, String)]) -> f64 {
    let rgb = gradient.colours(stripes()).concat();
    let mut png = Vec::new();
    let header = Header { texts, ..Header::new([240; 2], Samples::Rgb8) };
    png::write(&mut png, header, |rows, bytes| {
        bytes.copy_from_slice(&rgb[3 * 240 * rows.start..3 * 240 * rows.end]);
        Ok(())
    })
    .unwrap();
    let measured = measured_stream(Cursor::new(png), "a.png", false, None).unwrap();
    let Picture::Stripes { got, .. } = measured else { panic!("{measured:?}") };
    got.width
}

#[test]
fn coloured_stripes_are_as_wide_as_in_their_pattern() {
    let soft = [(0.0, [0xf4, 0xe3, 0xc1]), (1.0, [0x3b, 0x23, 0x14])];
    let light = [(0.0, [0x24, 0x40, 0x4f]), (1.0, [0xef, 0xf6, 0xf2])];
    let mut gradients = vec![gradient(&soft, [0.0, 0.0, 1.0, 1.0]), gradient(&soft, [0.42, 0.0, 0.58, 1.0])];
    gradients.push(gradient(&light, [0.0, 0.0, 1.0, 1.0]));
    gradients.extend(BY_LAYER.iter().chain(&COATS).map(Set::gradient));
    for gradient in gradients {
        let width = painted_width(&gradient, &[]);
        assert!((width / 12.0 - 1.0).abs() < 0.02, "{width} {gradient:?}");
    }
}

#[test]
fn the_document_in_a_picture_says_which_of_three_tones_is_the_edge() {
    let ripples = [(0.0, [176, 128, 73]), (0.5, [217, 176, 116]), (1.0, [253, 236, 203])];
    let gradient = gradient(&ripples, [0.3, 0.0, 0.7, 1.0]);
    let line = Stroke::line([20.0, 20.0], [20.0, 200.0], 12.0);
    let mut document = Document::new([240, 240]).with_layer(Layer::new([line]));
    document.layers[0].colours = Some(Colours::from(&gradient));
    let texts = embedded::embedded(&document, Extent::default());
    let [with, without] = [&texts[..], &[]].map(|texts| painted_width(&gradient, texts));
    assert!((with / 12.0 - 1.0).abs() < 0.01, "{with}");
    assert!((without / 12.0 - 1.0).abs() > 0.02, "{without}");
    // Other colours than those of the document: the picture was painted again.
    let changed = painted_width(&BY_LAYER[0].gradient(), &texts);
    assert!((changed / 12.0 - 1.0).abs() < 0.02, "{changed}");
}

#[test]
fn one_large_disc_is_neither_spots_nor_stripes() {
    let disc = image::ImageBuffer::from_fn(200, 200, |x, y| {
        let out = (f64::from(x) - 100.0).hypot(f64::from(y) - 100.0);
        image::Luma([if out < 60.0 { 20 } else { 220_u8 }])
    });
    let told = measured("disc.png", &DynamicImage::ImageLuma8(disc), false).unwrap_err().to_string();
    assert!(
        told.ends_with(
            "neither spots nor stripes: 1 whole spots are too few, at least 8 are needed; take a larger part of the pattern"
        ),
        "{told}"
    );
}

#[test]
fn inverted_the_ground_is_measured() {
    let disc = |out: f64| (0.5 + 0.7 * (1.0 - out)).clamp(0.0, 1.0);
    let net = DynamicImage::ImageLuma16(dots(disc));
    let Picture::Stripes { marks, .. } = measured("net.png", &net, true).unwrap() else { panic!() };
    assert_eq!(marks, 1);
}

#[test]
fn stripes_of_a_picture_have_width_wavelength_and_direction() {
    let image = image::ImageBuffer::from_fn(200, 300, |x, y| {
        let (sin, cos) = 20_f64.to_radians().sin_cos();
        let across = (f64::from(y) + 0.5) * cos - (f64::from(x) + 0.5) * sin;
        let inside = 3.0 - (across.rem_euclid(18.0) - 9.0).abs();
        image::Luma([(255.0 * gray(0.2 + 0.7 * (0.5 + inside).clamp(0.0, 1.0)) + 0.5) as u8])
    });
    let image = DynamicImage::ImageLuma8(image);
    let Picture::Stripes { got, .. } = measured("stripes.png", &image, false).unwrap() else { panic!() };
    assert!((got.width - 6.0).abs() < 0.06, "{got:?}");
    assert!((got.wavelength - 18.0).abs() < 0.3, "{got:?}");
    assert!((got.angle - 20.0).abs() < 0.2, "{got:?}");
    assert!(got.coherence > 0.9, "{got:?}");
}

/// The head of a gray TIFF with this size, without px.
fn head_of_tiff(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = b"II*\0\x08\0\0\0".to_vec();
    let tags = [(256, width), (257, height), (258, 8), (259, 1), (262, 1), (273, 8), (278, height), (279, 1)];
    bytes.extend_from_slice(&(tags.len() as u16).to_le_bytes());
    for (tag, value) in tags {
        // A LONG, one of it.
        for number in [tag | 4 << 16, 1, value] {
            bytes.extend_from_slice(&u32::to_le_bytes(number));
        }
    }
    bytes.extend_from_slice(&[0; 4]);
    bytes
}

#[test]
fn a_picture_larger_than_memory_is_refused_before_it_is_decoded() {
    let bytes = head_of_tiff(1_000_000, 1_000_000);
    let error = measured_stream(Cursor::new(bytes), "bomb.tiff", false, Some(8e9)).unwrap_err();
    let message = error.to_string();
    assert!(
        message.starts_with("bomb.tiff: 1000000×1000000 px need about 16000.0 GB of memory"),
        "{message}"
    );
}

/// Found by fuzzing: the JPEG decoder's message ends with a line break.
#[test]
fn messages_are_on_one_line() {
    let mut bytes = Cursor::new(Vec::new());
    let picture = DynamicImage::new_luma8(16, 16);
    picture.write_to(&mut bytes, image::ImageFormat::Jpeg).unwrap();
    let whole = bytes.into_inner();
    for length in 3..whole.len() {
        let cut = Cursor::new(whole[..length].to_vec());
        let message = measured_stream(cut, "a.jpg", false, None).unwrap_err().to_string();
        assert!(!message.contains(char::is_control), "{message:?}");
    }
}

#[test]
fn a_picture_without_marks_is_an_error() {
    let blank = DynamicImage::ImageLuma8(image::ImageBuffer::from_pixel(50, 50, image::Luma([7])));
    assert!(matches!(measured("blank.png", &blank, false), Err(MeasureError::Blank { .. })));
    let mut state = 1_u32;
    let noise = image::ImageBuffer::from_fn(200, 200, |_, _| {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        image::Luma([(state >> 24) as u8])
    });
    let told = measured("noise.png", &DynamicImage::ImageLuma8(noise), false);
    assert!(matches!(told, Err(MeasureError::Neither { .. })), "{told:?}");
}
