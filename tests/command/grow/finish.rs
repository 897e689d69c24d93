//! Documents with a finish: the picture has it, everything that is measured does not.

use crate::grow::folder::{Folder, document, spots, stripes};
use serde_json::{Value, json};

const KINDS: [&str; 9] =
    ["fur", "fish-scales", "reptile-scales", "skin", "leather", "cloth", "twill", "ink", "print"];

/// A tile of 96 × 96 px with five spots of different sizes.
fn tile() -> Value {
    let spot = |center: [f64; 2], radius: f64| json!({"kind": "ellipse", "center": center, "radii": [radius, radius - 1.0]});
    let strokes = [
        spot([20.0, 20.0], 9.0),
        spot([60.0, 24.0], 8.0),
        spot([40.0, 60.0], 10.0),
        spot([80.0, 66.0], 8.5),
        spot([12.0, 78.0], 7.5),
    ];
    let mut document = document([96, 96], &json!(strokes));
    document["edges"] = json!("wrap");
    document
}

fn with_finish(mut document: Value, kind: &str) -> Value {
    document["finish"] = json!({"kind": kind});
    document
}

fn without_seconds(mut report: Value) -> Value {
    assert!(report.as_object_mut().unwrap().remove("seconds").is_some());
    report
}

/// Number of pieces of ink on a tile, and px of ink.
pub(super) fn counted(([width, height], mask): &([usize; 2], Vec<u8>)) -> [usize; 2] {
    let (mut seen, mut pieces) = (vec![false; mask.len()], 0);
    for start in (0..mask.len()).filter(|px| mask[*px] > 0) {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        pieces += 1;
        let mut left = vec![start];
        while let Some(px) = left.pop() {
            let (x, y) = (px % width, px / width);
            for [x, y] in [[x + 1, y], [x + width - 1, y], [x, y + 1], [x, y + height - 1]] {
                let near = y % height * width + x % width;
                if mask[near] > 0 && !std::mem::replace(&mut seen[near], true) {
                    left.push(near);
                }
            }
        }
    }
    [pieces, mask.iter().filter(|label| **label > 0).count()]
}

#[test]
fn pattern_labels_outlines_and_report_are_those_without_the_finish() {
    const FILES: &str =
        "--pattern p.png --labels l.png --svg o.svg --dxf o.dxf --report r.json --no-document";
    for document in [tile(), stripes()] {
        let plain = Folder::with(&document);
        plain.grow(FILES);
        for kind in ["fur", "leather"] {
            let finished = Folder::with(&with_finish(document.clone(), kind));
            let said = finished.grow(FILES);
            assert!(said.contains("without the finish"), "{said}");
            assert!(plain.bytes("a.png") != finished.bytes("a.png"), "{kind}");
            for name in ["p.png", "l.png", "o.svg", "o.dxf"] {
                assert!(plain.bytes(name) == finished.bytes(name), "{name} with {kind}");
            }
            let [one, two] = [&plain, &finished].map(|folder| without_seconds(folder.json("r.json")));
            assert_eq!(one, two, "{kind}");
        }
    }
}

#[test]
fn the_mask_of_every_finish_keeps_the_number_of_marks_and_their_area() {
    for kind in KINDS {
        let folder = Folder::with(&with_finish(tile(), kind));
        folder.grow("--labels l.png --mask m.png --scale 2");
        let [before, after] = ["l.png", "m.png"].map(|name| counted(&folder.gray8(name)));
        assert_eq!(before[0], after[0], "{kind}");
        let change = after[1] as f64 / before[1] as f64 - 1.0;
        assert!(change.abs() <= 0.01, "{kind}: {change}");
    }
    let plain = Folder::with(&tile());
    plain.grow("--labels l.png --mask m.png");
    assert!(plain.bytes("l.png") == plain.bytes("m.png"));
}

#[test]
fn a_finish_has_the_same_bytes_with_any_number_of_threads_and_from_its_own_picture() {
    let folder = Folder::with(&with_finish(tile(), "fur"));
    folder.grow("--threads 1 --mask m1.png");
    let one = folder.bytes("a.png");
    folder.grow("--threads 3 --mask m3.png");
    assert!(one == folder.bytes("a.png") && folder.bytes("m1.png") == folder.bytes("m3.png"));
    folder.dapple("grow a.png -o b.png").assert().success();
    assert!(one == folder.bytes("b.png"));
    folder.grow("--seed 9");
    assert!(one != folder.bytes("a.png"));
}

#[test]
fn a_material_has_the_height_and_the_roughness_of_the_finish() {
    let [plain, finished] = [tile(), with_finish(tile(), "reptile-scales")].map(|document| {
        let folder = Folder::with(&document);
        folder.grow("--material set");
        folder
    });
    for map in ["BaseColor", "Height", "NormalGL", "Roughness", "AmbientOcclusion"] {
        let name = format!("set/a_{map}.png");
        assert!(plain.bytes(&name) != finished.bytes(&name), "{map}");
    }
    assert!(plain.bytes("set/a_ID.png") == finished.bytes("set/a_ID.png"));
    // Without relief of the marks the heights are those of the scales alone.
    finished.grow("--material flat --relief 0");
    let (_, heights) = finished.gray16("flat/a_Height.png");
    let (low, high) = (heights.iter().min().unwrap(), heights.iter().max().unwrap());
    assert!(*low < 2_000 && *high > 63_000, "{low} {high}");
}

#[test]
fn without_a_relief_marks_are_as_high_as_the_finish_wants() {
    for (kind, relief) in [("reptile-scales", 0), ("skin", 1), ("leather", 6)] {
        let folder = Folder::with(&with_finish(tile(), kind));
        folder.grow("--material usual");
        folder.grow(&format!("--material same --relief {relief}"));
        folder.grow("--material other --relief 3");
        let [usual, same, other] =
            ["usual", "same", "other"].map(|set| folder.bytes(&format!("{set}/a_Height.png")));
        assert!(usual == same && usual != other, "{kind}");
    }
}

#[test]
fn what_a_finish_cannot_do_is_refused_or_said() {
    let folder = Folder::with(&with_finish(tile(), "fur"));
    folder.refuses("grow a.dapple -o a.png --transparent", 2, &["--transparent", "finish fur"]);
    let mut map = with_finish(spots(), "fur");
    map["version"] = json!(2);
    map["model"] = json!({"height": "hills.png", "scale": 40});
    folder.write("b.dapple", &map.to_string());
    folder.refuses("grow b.dapple -o b.png", 1, &["finish", "would be stretched", "without \"model\""]);
}

#[test]
fn hair_follows_an_angle_or_the_strokes_of_a_layer_of_hair() {
    let mut angled = with_finish(tile(), "fur");
    angled["finish"]["flow"] = json!(90);
    let mut drawn = with_finish(tile(), "fur");
    let hair = json!({"system": "hair", "strokes": [{"kind": "line", "from": [40, 10], "to": [40, 80]}]});
    drawn["layers"].as_array_mut().unwrap().push(hair);
    let [usual, angled, drawn] = [with_finish(tile(), "fur"), angled, drawn].map(|document| {
        let folder = Folder::new();
        folder.write("a.dapple", &document.to_string());
        folder.grow("--labels l.png");
        ["a.png", "l.png"].map(|name| image::open(folder.path(name)).unwrap().into_rgb8().into_raw())
    });
    assert!(angled[1] == usual[1] && drawn[1] == usual[1]);
    let apart = |one: &[u8], other: &[u8]| {
        let sum: f64 = one.iter().zip(other).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
        sum / one.len() as f64
    };
    // A single line downwards gives nearly the same direction everywhere.
    let (same, other) = (apart(&angled[0], &drawn[0]), apart(&angled[0], &usual[0]));
    assert!(same < 1.0 && other > 5.0, "{same} {other}");
}

#[test]
fn the_coats_are_formatted_as_the_program_writes_them_and_each_has_a_finish_and_a_picture() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for entry in std::fs::read_dir(root.join("examples/coats")).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let document = dapple::document::Document::parse(&text, "example").unwrap();
        assert!(document.finish.is_some() && text == document.to_json(), "{}", path.display());
        let picture = root.join("assets/examples").join(path.file_stem().unwrap()).with_extension("png");
        assert!(picture.is_file(), "{}", picture.display());
        count += 1;
    }
    assert_eq!(count, 17);
}

#[test]
fn each_frame_of_a_film_has_the_finish_and_the_last_one_is_the_picture() {
    let folder = Folder::with(&with_finish(tile(), "fur"));
    folder.write("plain.dapple", &tile().to_string());
    folder.grow("");
    for (file, to, options) in [
        ("a", "one", "--side 96 --threads 1"),
        ("a", "three", "--side 96 --threads 3"),
        ("plain", "without", "--side 96"),
        ("a", "small", "--side 48"),
    ] {
        let film = format!("film {file}.dapple -o {to} --seconds 0.3 {options}");
        folder.dapple(&film).assert().success();
    }
    let frame = |film: &str, number: usize| {
        let bytes = folder.bytes(&format!("{film}/frame-{number:04}.png"));
        image::load_from_memory(&bytes).unwrap().into_rgb8().into_raw()
    };
    let picture = image::load_from_memory(&folder.bytes("a.png")).unwrap().into_rgb8().into_raw();
    assert!(frame("one", 6) == picture, "the last frame");
    for number in 1..=6 {
        assert!(frame("one", number) == frame("three", number), "{number}: as with other threads");
        let moved = frame("one", number)
            .iter()
            .zip(frame("without", number))
            .filter(|(a, b)| a.abs_diff(*b) > 8)
            .count();
        assert!(moved > 96 * 96, "{number}: {moved} of {} values differ", 3 * 96 * 96);
    }
    // The mean of a smaller frame is that of the picture.
    let mean = |rgb: &[u8]| rgb.iter().map(|part| f64::from(*part)).sum::<f64>() / rgb.len() as f64;
    assert!((mean(&frame("small", 6)) - mean(&picture)).abs() < 8.0);
}

#[test]
fn both_ends_of_a_film_between_two_documents_show_their_finishes() {
    let plain = document([96, 96], &json!([{"kind": "line", "from": [10, 20], "to": [80, 24], "width": 9}]));
    let folder = Folder::with(&with_finish(plain.clone(), "fur"));
    folder.write("b.dapple", &with_finish(plain.clone(), "leather").to_string());
    folder.write("plain.dapple", &plain.to_string());
    for (from, to, film) in [("a", "b", "changing"), ("plain", "plain", "without")] {
        let film = format!("film {from}.dapple --to {to}.dapple -o {film} --side 96 --seconds 0.3");
        folder.dapple(&film).assert().success();
    }
    for number in [1, 6] {
        let [changing, without] =
            ["changing", "without"].map(|film| folder.bytes(&format!("{film}/frame-000{number}.png")));
        assert!(changing != without, "{number}");
    }
}

#[test]
fn the_material_of_fur_has_reflections_across_the_hair_and_that_of_leather_none() {
    let mut furry = with_finish(tile(), "fur");
    // Towards +x and up the picture.
    furry["finish"]["flow"] = json!(-30);
    let folder = Folder::with(&furry);
    folder.write("b.dapple", &with_finish(tile(), "leather").to_string());
    folder.grow("--material fur");
    folder.dapple("grow b.dapple --material leather").assert().success();
    let map = image::load_from_memory(&folder.bytes("fur/a_Anisotropy.png")).unwrap().into_rgb8();
    assert_eq!(map.dimensions(), (96, 96));
    for px in map.pixels() {
        let [x, y] = [px[0], px[1]].map(|part| f64::from(part) / 127.5 - 1.0);
        let (cos, up) = (30_f64.to_radians().cos(), 30_f64.to_radians().sin());
        assert!((x * cos + y * up).abs() < 0.02 && (x * x + y * y - 1.0).abs() < 0.02, "{px:?}");
        assert!(px[2] > 100);
    }
    let text = |path: &str| String::from_utf8(folder.bytes(path)).unwrap();
    assert!(text("fur/a.gltf").contains("a_Anisotropy.png"));
    assert!(!text("leather/b.gltf").contains("Anisotropy"));
    assert!(!folder.path("leather/b_Anisotropy.png").exists());
}
