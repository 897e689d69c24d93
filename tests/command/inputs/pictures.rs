//! Pictures from other programs.

use crate::outlines::bench::Bench;
use image::{ImageBuffer, Luma, Rgb, RgbImage, Rgba, RgbaImage};
use serde_json::Value;

/// The signed distance of a px from the nearest ellipse (radii 9 and 6, at 30°, on a lattice of 32 px); positive
/// outside.
fn out(x: u32, y: u32) -> f64 {
    let near = |x: u32| (f64::from(x) + 0.5).rem_euclid(32.0) - 16.0;
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let (x, y) = (near(x), near(y));
    ((x * cos + y * sin) / 9.0).hypot((y * cos - x * sin) / 6.0)
}

/// The share of a px that marks cover.
fn share(x: u32, y: u32) -> f64 {
    (0.5 + 7.0 * (1.0 - out(x, y))).clamp(0.0, 1.0)
}

#[track_caller]
fn measured(bench: &Bench, arguments: &str) -> Value {
    serde_json::from_str(&bench.prints(&format!("measure {arguments} --json"))).unwrap()
}

#[track_caller]
fn has_64_spots(found: &Value, name: &str) {
    let area = found["area"].as_f64().unwrap();
    assert_eq!(found["marks"], 64, "{name}: {found}");
    assert!((area / (54.0 * std::f64::consts::PI) - 1.0).abs() < 0.05, "{name}: {found}");
}

#[test]
fn transparent_px_are_ground() {
    let bench = Bench::new();
    for (name, colour) in [("dark.png", [40, 20, 10]), ("light.png", [250, 240, 230])] {
        let [r, g, b] = colour;
        let cut_out = RgbaImage::from_fn(256, 256, |x, y| Rgba([r, g, b, (255.0 * share(x, y)) as u8]));
        cut_out.save(bench.path(name)).unwrap();
        has_64_spots(&measured(&bench, name), name);
        bench.does(&format!("import {name} -o x.dapple"));
    }
}

#[test]
fn a_transparent_texture_is_measured_as_the_opaque_one() {
    let bench = Bench::new();
    bench.does("grow a.dapple --size 400x300 -o opaque.png");
    bench.does("grow a.dapple --size 400x300 --transparent -o transparent.png");
    let [opaque, transparent] = ["opaque.png", "transparent.png"].map(|name| measured(&bench, name));
    assert_eq!(opaque["marks"], transparent["marks"]);
    let area = |found: &Value| found["area"].as_f64().unwrap();
    assert!((area(&transparent) / area(&opaque) - 1.0).abs() < 0.02, "{opaque} {transparent}");
}

#[test]
fn gray_of_16_bits_is_read_like_gray_of_8_bits() {
    let bench = Bench::new();
    let tone = |x, y| 0.70 - 0.20 * share(x, y);
    let deep: ImageBuffer<Luma<u16>, Vec<u16>> =
        ImageBuffer::from_fn(256, 256, |x, y| Luma([(65535.0 * tone(x, y)) as u16]));
    let flat: ImageBuffer<Luma<u8>, Vec<u8>> =
        ImageBuffer::from_fn(256, 256, |x, y| Luma([(255.0 * tone(x, y)) as u8]));
    deep.save(bench.path("deep.png")).unwrap();
    flat.save(bench.path("flat.png")).unwrap();
    let [deep, flat] = ["deep.png", "flat.png"].map(|name| measured(&bench, name));
    let area = |found: &Value| found["area"].as_f64().unwrap();
    assert!((area(&deep) / area(&flat) - 1.0).abs() < 0.01, "{deep} {flat}");
    assert!(deep["notes"][0].as_str().is_some_and(|note| note.contains("stretched")), "{deep}");
}

#[test]
fn black_and_white_of_16_bits_is_read_as_a_pattern_with_a_note() {
    let bench = Bench::new();
    let full: ImageBuffer<Luma<u16>, Vec<u16>> =
        ImageBuffer::from_fn(256, 256, |x, y| Luma([(65535.0 * share(x, y)) as u16]));
    full.save(bench.path("full.png")).unwrap();
    let as_pattern = measured(&bench, "full.png");
    assert!(
        as_pattern["notes"][0].as_str().is_some_and(|note| note.contains("--no-pattern")),
        "{as_pattern}"
    );
    let as_picture = measured(&bench, "full.png --no-pattern");
    assert!(as_picture["notes"].is_null() && as_picture["area"] != as_pattern["area"]);
    bench.does("grow a.dapple -o a.png --pattern p.png");
    assert!(measured(&bench, "p.png --patches")["notes"].is_null(), "dapple's own");
}

#[test]
fn measure_takes_a_part_and_the_smallest_area() {
    let bench = Bench::new();
    let specks = RgbImage::from_fn(256, 256, |x, y| {
        let speck = (x % 32 < 4 && y % 32 < 4) as u8;
        let dark = (220.0 - 180.0 * share(x, y)) as u8 - 150 * speck;
        Rgb([dark; 3])
    });
    specks.save(bench.path("specks.png")).unwrap();
    has_64_spots(&measured(&bench, "specks.png --smallest 60"), "specks");
    assert_eq!(measured(&bench, "specks.png --smallest 60 --crop 0,0,128,256")["marks"], 32);
    bench.refuses("measure specks.png --crop 200,0,128,256", 1, &["--crop: found 200,0,128,256"]);
}

#[test]
fn dots_of_many_colours_on_a_dark_cloth_with_dust_are_spots() {
    let bench = Bench::new();
    const COLOURS: [[u8; 3]; 5] =
        [[220, 60, 60], [70, 130, 210], [235, 215, 60], [60, 160, 110], [235, 225, 230]];
    let mut state = 7_u32;
    let mut random = move || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    let cloth = RgbImage::from_fn(300, 300, |x, y| {
        let near = |x: u32| f64::from(x % 60) + 0.5 - 30.0;
        let which = (x / 60 * 3 + y / 60 * 2) as usize % 5;
        let radius = 11.0 + 2.0 * f64::from((x / 60 + 2 * (y / 60)) % 4);
        if near(x).hypot(near(y)) < radius {
            return Rgb(COLOURS[which]);
        }
        let noise = 8.0 * (random() - 0.5);
        let dust = if random() < 0.003 { 160.0 } else { 0.0 };
        Rgb([(34.0 + noise + dust) as u8; 3])
    });
    cloth.save(bench.path("dots.png")).unwrap();
    let said = bench.does("import dots.png -o dots.dapple --take-it");
    let found: usize =
        said.split("spots: ").nth(1).and_then(|rest| rest.split(' ').next()?.parse().ok()).unwrap();
    assert!((22..=27).contains(&found), "{said}");
}

#[test]
fn every_truncated_picture_is_refused_with_the_same_message() {
    let bench = Bench::new();
    let picture = RgbImage::from_fn(96, 96, |x, y| Rgb([(220.0 - 180.0 * share(x, y)) as u8; 3]));
    for name in ["a.png", "a.jpg", "a.tif", "a.gif", "a.bmp", "a.webp"] {
        picture.save(bench.path(name)).unwrap();
        let whole = std::fs::read(bench.path(name)).unwrap();
        for share in [0.5, 0.9, 0.98] {
            std::fs::write(bench.path(name), &whole[..(share * whole.len() as f64) as usize]).unwrap();
            bench.refuses(
                &format!("measure {name}"),
                1,
                &["damaged or cut short", "copy or download it again"],
            );
        }
    }
}

#[test]
fn files_that_are_not_pictures_are_named_with_the_remedy() {
    let bench = Bench::new();
    for (name, bytes, words) in [
        (
            "a.heic",
            &b"\0\0\0\x24ftypheic\0\0\0\0mif1heic\0\0\0\0\0\0\0\0"[..],
            ["HEIC", "save or export it as JPEG or PNG"],
        ),
        (
            "a.avif",
            b"\0\0\0\x1cftypavif\0\0\0\0avifmif1\0\0\0\0\0\0\0\0",
            ["AVIF", "save or export it as JPEG or PNG"],
        ),
        (
            "a.jpg",
            b"<!DOCTYPE html><html><img src='a.jpg'></html>",
            ["a web page", "save the picture itself"],
        ),
        ("a.png", b"", ["an empty file", "copy or download it again"]),
        ("a.pdf", b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", ["a PDF document", "save or export it"]),
    ] {
        std::fs::write(bench.path(name), bytes).unwrap();
        bench.refuses(&format!("measure {name}"), 1, &words);
        bench.refuses(&format!("import {name} -o x.dapple"), 1, &words);
        if name != "a.png" && name != "a.jpg" {
            bench.refuses(&format!("grow {name} -o x.png"), 1, &words);
        }
    }
}
