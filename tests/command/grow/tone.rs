//! Pictures that drive patterns: the local share of ink follows the tone, and lines run along edges.

use crate::grow::folder::{Folder, spots};
use crate::some;
use dapple::document::{Document, Layer, Stroke, SystemChoice};
use dapple::tone::{Drives, Tone, ToneImage};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::rd::pairs::PairKind;
use image::GrayImage;
use serde_json::{Value, json};
use test_pictures::tone_pictures::{ALL, SIDE, eye, face, picture, rings};

fn image(gray: &GrayImage) -> ToneImage {
    let size = [gray.width() as usize, gray.height() as usize];
    ToneImage::new(size, gray.as_raw().clone()).expect("a small picture")
}

/// A layer without strokes that a picture drives, on a canvas of `size` px.
fn driven(size: [u32; 2], tone: Tone) -> Document {
    Document::new(size).with_layer(Layer { tone: Some(tone), ..Layer::default() })
}

/// A document that a picture drives, with `stripes` stripes across the canvas, which are drawn as one line at `angle`
/// degrees.
fn coarse(size: u32, stripes: f64, angle: f64, tone: Tone) -> Document {
    let middle = 0.5 * f64::from(size);
    let (s, c) = angle.to_radians().sin_cos();
    let end = |along: f64| [middle + along * c, middle + along * s];
    let line = Stroke::line(end(-0.3 * middle), end(0.3 * middle), middle / stripes);
    Document::new([size; 2]).with_layer(Layer::new([line]).with_tone(tone))
}

fn plain(gray: &GrayImage) -> Tone {
    Tone { equalise: false, ..Tone::new(image(gray)) }
}

fn json_of(document: &Document) -> Value {
    serde_json::from_str(&document.to_json()).expect("JSON")
}

/// The report of `dapple grow` on the lowest layer.
fn reported(document: &Document) -> (Folder, Value) {
    let folder = Folder::with(&json_of(document));
    folder.grow("--report r.json --pattern p.png");
    let tone = folder.json("r.json")["layers"][0]["tone"].clone();
    (folder, tone)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The share of ink of a pattern in the square of `side` px about a place.
fn ink(pattern: &Field, [x, y]: [usize; 2], side: usize) -> f64 {
    let rows = y - side / 2..y + side / 2;
    let px: Vec<f32> = rows
        .flat_map(|y| (x - side / 2..x + side / 2).map(move |x| (x, y)))
        .map(|(x, y)| pattern.values[y * pattern.width + x])
        .collect();
    px.iter().filter(|value| **value >= 0.5).count() as f64 / px.len() as f64
}

/// Compares and prints the errors of a picture, for the table in `docs/tone.md`.
#[track_caller]
fn is_within_the_bounds(name: &str, report: &Value) {
    let [near, far] = [0, 1].map(|blur| number(&report["correlation"][blur]));
    let [off_near, off_far] = [0, 1].map(|blur| number(&report["difference"][blur]));
    let turned = number(&report["direction"]);
    println!("| {name} | {near:.4} / {off_near:.4} | {far:.4} / {off_far:.4} | {turned:.1}° |");
    assert!(near >= 0.985 && far >= 0.995, "{name}: {report}");
    assert!(off_near <= 0.02 && off_far <= 0.01, "{name}: {report}");
    assert!(turned <= 8.0, "{name}: {report}");
}

#[test]
fn tones_and_directions_of_pictures_are_within_the_bounds() {
    // DAPPLE_ALL=1 tries all of them; --nocapture prints the errors.
    println!("| picture | ½ λ | λ | direction |");
    for (name, light) in some(ALL, 2) {
        let (_, report) = reported(&driven([448; 2], Tone::new(image(&picture([SIDE; 2], light)))));
        is_within_the_bounds(name, &report);
        assert_eq!(number(&report["wavelength"]), 8.0);
    }
}

#[test]
fn tones_and_directions_of_pair_stripes_are_within_the_bounds() {
    println!("| picture | ½ λ | λ | direction |");
    for (name, light) in some(ALL, 3) {
        let mut document = driven([448; 2], Tone::new(image(&picture([SIDE; 2], light))));
        document.layers[0].system = SystemChoice::Of(PairKind::Stripes.description());
        let (_, report) = reported(&document);
        is_within_the_bounds(name, &report);
    }
}

#[test]
fn no_gray_area_is_painted_where_lines_end() {
    // Where a line ends between two others, the relief has a saddle. No gray area may be wider than an edge.
    let side = 512;
    let folder = Folder::with(&json_of(&driven([side; 2], Tone::new(image(&picture([SIDE; 2], face))))));
    picture([SIDE; 2], face).save(folder.path("face.png")).unwrap();
    // With the colours of ink on paper.
    folder.grow("--tone face.png --scale 2");
    let painted = image::open(folder.path("a.png")).unwrap().into_luma8();
    let is_gray = |x: u32, y: u32| (60..200).contains(&painted.get_pixel(x, y).0[0]);
    let (width, height) = painted.dimensions();
    let block = |x: u32, y: u32| (0..36).all(|k| is_gray(x + k % 6, y + k / 6));
    let smudges = (0..height - 6).flat_map(|y| (0..width - 6).map(move |x| (x, y)));
    let smudges = smudges.filter(|(x, y)| is_gray(*x, *y) && block(*x, *y)).count();
    assert_eq!(smudges, 0);
}

#[test]
fn the_share_of_ink_is_the_linear_tone_of_the_picture() {
    // Linear light 0 to 1 from left to right.
    let tone = Tone { range: [0.1, 0.9], ..plain(&picture([SIDE; 2], |u, _| u)) };
    let (folder, _) = reported(&coarse(512, 32.0, 20.0, tone));
    let pattern = folder.pattern("p.png", Edges::Closed);
    for x in [64, 128, 256, 384, 448] {
        let wanted = 0.9 - 0.8 * x as f64 / 512.0;
        let found: f64 = [100, 200, 300, 400].map(|y| ink(&pattern, [x, y], 64)).iter().sum::<f64>() / 4.0;
        assert!((found - wanted).abs() < 0.02, "{x}: {found} for {wanted}");
    }
}

#[test]
fn a_negative_has_ink_where_the_picture_is_white() {
    let tone = Tone { range: [0.8, 0.2], ..plain(&picture([64; 2], |u, _| if u < 0.5 { 1.0 } else { 0.0 })) };
    let (folder, _) = reported(&coarse(256, 20.0, 90.0, tone));
    let pattern = folder.pattern("p.png", Edges::Closed);
    let [left, right] = [64, 192].map(|x| ink(&pattern, [x, 128], 100));
    assert!((left - 0.8).abs() < 0.02 && (right - 0.2).abs() < 0.02, "{left} {right}");
}

/// The direction of the pattern about a place, degrees: from its gradients within `reach` px.
fn direction(pattern: &Field, [x, y]: [usize; 2], reach: usize) -> f64 {
    let at = |x: usize, y: usize| f64::from(pattern.values[y * pattern.width + x]);
    let [mut c, mut s] = [0.0; 2];
    for y in y - reach..y + reach {
        for x in x - reach..x + reach {
            let [dx, dy] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
            c += dy * dy - dx * dx;
            s -= 2.0 * dx * dy;
        }
    }
    0.5 * s.atan2(c).to_degrees()
}

fn turn(a: f64, b: f64) -> f64 {
    ((a - b + 90.0).rem_euclid(180.0) - 90.0).abs()
}

#[test]
fn lines_run_along_the_rings_of_a_picture_whatever_was_drawn() {
    let (folder, _) = reported(&coarse(384, 30.0, 20.0, plain(&picture([SIDE; 2], rings))));
    let pattern = folder.pattern("p.png", Edges::Closed);
    let mut turns = Vec::new();
    for step in 0..24 {
        let (s, c) = (15.0 * f64::from(step)).to_radians().sin_cos();
        let at = [0.45 * 384.0 + 110.0 * c, 0.55 * 384.0 + 110.0 * s].map(|at: f64| at as usize);
        turns.push(turn(direction(&pattern, at, 14), 15.0 * f64::from(step) + 90.0));
    }
    turns.sort_by(f64::total_cmp);
    // With only two periods of curved lines, no closer bound is possible.
    assert!(turns[12] < 8.0 && turns[21] < 15.0, "{turns:?}");
}

#[test]
fn flat_grounds_hatch_along_the_drawn_line() {
    for angle in [20.0, 110.0] {
        let (folder, _) = reported(&coarse(256, 20.0, angle, plain(&picture([64; 2], |_, _| 0.5))));
        let pattern = folder.pattern("p.png", Edges::Closed);
        for at in [[64, 64], [128, 128], [190, 70], [60, 190]] {
            let found = direction(&pattern, at, 30);
            assert!(turn(found, angle) < 4.0, "{found} for {angle}");
        }
    }
}

#[test]
fn the_weight_of_the_sketch_decides_between_the_picture_and_the_drawn_line() {
    let found = |sketch: f64| {
        let tone = Tone { sketch, ..plain(&picture([SIDE; 2], |u, _| 0.5 + 0.3 * (40.0 * u).sin())) };
        let (folder, _) = reported(&coarse(256, 20.0, 20.0, tone));
        direction(&folder.pattern("p.png", Edges::Closed), [128, 128], 60)
    };
    assert!(turn(found(0.0), 90.0) < 6.0 && turn(found(10.0), 20.0) < 6.0);
}

#[test]
fn attributes_that_are_not_driven_do_not_follow_the_picture() {
    let tone = |drives: Drives| Tone { drives, ..plain(&picture([SIDE; 2], |u, _| u)) };
    let only = Drives { level: false, direction: true, spacing: false };
    let (folder, _) = reported(&coarse(256, 20.0, 20.0, tone(only)));
    let pattern = folder.pattern("p.png", Edges::Closed);
    let [left, right] = [40, 216].map(|x| ink(&pattern, [x, 128], 70));
    assert!((left - right).abs() < 0.06, "{left} {right}");
    // Along the edges of this picture, lines would be vertical.
    let only = Drives { level: true, direction: false, spacing: false };
    let (folder, report) = reported(&coarse(256, 20.0, 20.0, tone(only)));
    let found = direction(&folder.pattern("p.png", Edges::Closed), [128, 128], 50);
    assert!(turn(found, 20.0) < 4.0, "{found}");
    assert_eq!(report["drives"], json!(["level"]));
}

/// The connected pieces of ink of a pattern.
fn pieces(pattern: &Field, columns: std::ops::Range<usize>) -> usize {
    let width = pattern.width;
    let is_ink = |cell: usize| columns.contains(&(cell % width)) && pattern.values[cell] >= 0.5;
    let mut seen = vec![false; pattern.values.len()];
    let mut count = 0;
    for start in 0..seen.len() {
        if seen[start] || !is_ink(start) {
            continue;
        }
        count += 1;
        let mut left = vec![start];
        seen[start] = true;
        while let Some(cell) = left.pop() {
            let beside = [cell.wrapping_sub(1), cell + 1, cell.wrapping_sub(width), cell + width];
            for next in beside.into_iter().filter(|next| *next < pattern.values.len()) {
                if !seen[next] && is_ink(next) {
                    seen[next] = true;
                    left.push(next);
                }
            }
        }
    }
    count
}

fn dots(drives: Drives) -> Document {
    let tone = Tone {
        drives,
        range: [0.08, 0.45],
        ..plain(&picture([SIDE; 2], |u, _| if u < 0.5 { 0.9 } else { 0.1 }))
    };
    let spot = Stroke::ellipse([128.0, 128.0], [3.0, 3.0], 0.0);
    Document::new([256; 2]).with_layer(Layer::new([spot]).with_tone(tone))
}

#[test]
fn spots_carry_tones_by_their_size() {
    let (folder, report) = reported(&dots(Drives { level: true, direction: false, spacing: false }));
    let pattern = folder.pattern("p.png", Edges::Closed);
    let [light, dark] = [64, 192].map(|x| ink(&pattern, [x, 128], 100));
    assert!((light - 0.117).abs() < 0.02 && (dark - 0.413).abs() < 0.02, "{light} {dark} {report}");
    assert!(number(&report["correlation"][1]) > 0.995, "{report}");
    let [light, dark] = [0..128, 128..256].map(|columns| pieces(&pattern, columns) as f64);
    assert!((light / dark - 1.0).abs() < 0.15, "{light} {dark}");
}

#[test]
fn there_are_more_dots_where_the_picture_is_darker_if_it_drives_their_spacing() {
    let (folder, report) = reported(&dots(Drives { level: true, direction: false, spacing: true }));
    let pattern = folder.pattern("p.png", Edges::Closed);
    let [light, dark] = [0..128, 128..256].map(|columns| pieces(&pattern, columns) as f64);
    // The number of dots grows in proportion to the ink, within the limits of how close dots can be.
    assert!((2.2..4.5).contains(&(dark / light)), "{light} {dark}");
    assert!(number(&report["correlation"][1]) > 0.995, "{report}");
}

#[test]
fn a_wider_picture_shows_its_middle() {
    // White, except for a black band in the middle third.
    let gray = picture([300, 100], |u, _| if (1.0 / 3.0..2.0 / 3.0).contains(&u) { 0.0 } else { 1.0 });
    let (folder, _) = reported(&coarse(200, 16.0, 0.0, plain(&gray)));
    let pattern = folder.pattern("p.png", Edges::Closed);
    assert!((ink(&pattern, [100, 100], 190) - 0.9).abs() < 0.02);
}

#[test]
fn the_number_of_threads_changes_no_byte_and_the_picture_holds_its_document() {
    let mut document = coarse(128, 14.0, 20.0, Tone::new(image(&picture([90, 60], eye))));
    document.edges = Edges::Wrap;
    let folder = Folder::with(&json_of(&document));
    let grown = [1, 4].map(|threads| {
        folder.grow(&format!("--threads {threads} --pattern p.png"));
        (folder.bytes("a.png"), folder.bytes("p.png"))
    });
    assert!(grown[0] == grown[1]);
    folder.dapple("grow a.png -o b.png").assert().success();
    assert!(folder.bytes("b.png") == grown[0].0);
}

#[test]
fn a_picture_of_any_kind_drives_the_lowest_layer_of_a_document_that_has_none() {
    let folder = Folder::with(&json_of(&Document::new([160; 2]).with_layer(Layer::new([Stroke::line(
        [20.0, 40.0],
        [90.0, 40.0],
        5.0,
    )]))));
    let gray = picture([120, 90], eye);
    let rgb = image::DynamicImage::ImageLuma8(gray).into_rgb8();
    for name in ["eye.jpg", "eye.png", "eye.webp", "eye.tif"] {
        rgb.save(folder.path(name)).unwrap();
        folder.grow(&format!("--tone {name} --report r.json"));
        let report = folder.json("r.json")["layers"][0]["tone"].clone();
        assert_eq!(report["image"], json!([120, 90]), "{name}");
        // The picture grows again without the file.
        std::fs::remove_file(folder.path(name)).unwrap();
        let before = folder.bytes("a.png");
        folder.dapple("grow a.png -o b.png").assert().success();
        assert!(folder.bytes("b.png") == before, "{name}");
    }
}

#[test]
fn a_picture_painted_as_ink_on_paper_has_the_tone_of_the_picture() {
    let document =
        Document::new([256; 2]).with_layer(Layer::new([Stroke::line([20.0, 40.0], [90.0, 60.0], 6.0)]));
    let folder = Folder::with(&json_of(&document));
    picture([SIDE; 2], |_, _| 0.5).save(folder.path("gray.png")).unwrap();
    let mut driven = document;
    driven.layers[0].tone = Some(plain(&picture([SIDE; 2], |_, _| 0.9)));
    folder.write("a.dapple", &driven.to_json());
    folder.grow("--tone gray.png");
    let painted = image::open(folder.path("a.png")).unwrap().into_luma8();
    let linear = |value: u8| ((f64::from(value) / 255.0 + 0.055) / 1.055).powf(2.4);
    let light = painted.pixels().map(|px| linear(px.0[0])).sum::<f64>() / 65_536.0;
    // Half of the paper's light (0.95) and half of the ink's (0.01).
    assert!((light - 0.48).abs() < 0.02, "{light}");
}

#[test]
fn settings_that_are_not_allowed_with_a_picture_are_refused_with_the_reason() {
    let least = json_of(&driven([96; 2], Tone::new(image(&picture([8; 2], eye)))));
    let with = |change: &dyn Fn(&mut Value)| {
        let mut document = least.clone();
        change(&mut document["layers"][0]);
        Folder::with(&document)
    };
    let options =
        [("keep", json!(true)), ("duty", json!(0.3)), ("seeding", json!("segments")), ("spread", json!(0.2))];
    for (option, value) in options {
        let folder = with(&|layer| layer["options"] = json!({ option: value }));
        folder.refuses("grow a.dapple -o a.png", 1, &[&format!("layers[0].options.{option}"), "picture"]);
    }
    for system in ["weave", "patches", "turing-spots", "meinhardt-lines"] {
        let folder = with(&|layer| layer["system"] = json!(system));
        let words = ["layers[0].system", system, "meinhardt-stripes", "A picture drives"];
        folder.refuses("grow a.dapple -o a.png", 1, &words);
    }
    let mut above = json_of(&Document::new([96; 2]));
    above["layers"] = json!([spots()["layers"][0], least["layers"][0]]);
    Folder::with(&above).refuses("grow a.dapple -o a.png", 1, &["layers[1].tone", "the lowest layer"]);
    let folder = Folder::with(&spots());
    folder.write("text.png", "no picture");
    folder.refuses("grow a.dapple -o a.png --tone text.png", 1, &["text.png", "cannot be read as a picture"]);
    folder.refuses("grow a.dapple -o a.png --tone a.png", 2, &["--tone", "two files"]);
}

#[test]
fn spots_grow_between_the_lines_of_a_picture_beneath_but_not_round_them() {
    let mut document = json_of(&coarse(192, 8.0, 0.0, plain(&picture([64; 2], |_, _| 0.9))));
    let spot = json!({"kind": "ellipse", "center": [100, 100], "radii": [4, 3]});
    document["layers"].as_array_mut().unwrap().push(json!({"name": "spots", "strokes": [spot]}));
    let folder = Folder::with(&document);
    folder.grow("--labels l.png");
    let (_, labels) = folder.gray8("l.png");
    assert!([1, 2].iter().all(|label| labels.iter().filter(|found| *found == label).count() > 500));
    document["layers"][1]["after"] = json!("inside");
    Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &["layers[1].after", "picture"]);
}

#[test]
fn outlines_of_a_picture_in_lines_are_paths() {
    let document = coarse(160, 16.0, 20.0, Tone::new(image(&picture([SIDE; 2], eye))));
    let folder = Folder::with(&json_of(&document));
    folder.dapple("grow a.dapple -o a.svg").assert().success();
    let svg = String::from_utf8(folder.bytes("a.svg")).unwrap();
    assert!(svg.contains("<path") && svg.len() > 5_000, "{}", svg.len());
}

#[test]
fn check_lists_what_drives_a_layer() {
    let folder = Folder::with(&json_of(&driven([224; 2], Tone::new(image(&picture([80, 60], eye))))));
    let output = folder.dapple("check a.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("a picture of 80 × 60 px, equalised drives its level, direction, spacing"),
        "{text}"
    );
    assert!(text.contains("marks 4.0 px apart"), "{text}");
    let output = folder.dapple("check a.dapple --json").assert().success().get_output().clone();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["layers"][0]["tone"]["image"], json!([80, 60]));
}
