//! Each option does what its help says.

use crate::grow::folder::{AREA, Folder, spots, stripes};
use serde_json::{Value, json};

fn dots_an_inch(folder: &Folder, name: &str) -> f64 {
    let bytes = folder.bytes(name);
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let dims = reader.info().pixel_dims.expect("a resolution");
    assert_eq!((dims.xppu, dims.unit), (dims.yppu, png::Unit::Meter));
    f64::from(dims.xppu) * 0.0254
}

#[test]
fn a_picture_has_the_size_and_resolution_of_its_document() {
    let mut document = spots();
    document["size"] = json!([144, 96]);
    document["dpi"] = json!(150);
    let folder = Folder::with(&document);
    folder.grow("");
    let picture = image::open(folder.path("a.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (144, 96));
    assert_eq!(picture.color(), image::ColorType::Rgb8);
    assert!((dots_an_inch(&folder, "a.png") - 150.0).abs() < 0.02);
    assert_eq!(folder.names(), ["a.dapple", "a.png"]);
    // The same texture, twice as fine.
    folder.grow("--scale 2");
    let picture = image::open(folder.path("a.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (288, 192));
    assert!((dots_an_inch(&folder, "a.png") - 300.0).abs() < 0.02);
}

#[test]
fn a_larger_size_gives_more_marks_of_the_same_size() {
    let folder = Folder::with(&spots());
    folder.grow("--pattern small.png");
    folder.grow("--pattern large.png --size 256x224");
    assert_eq!(folder.gray16("large.png").0, [256, 224]);
    let [small, large] = ["small.png", "large.png"].map(|name| folder.measured(name));
    let areas = [&small, &large].map(|measured| measured["area"].as_f64().unwrap());
    assert!((areas[1] / areas[0] - 1.0).abs() < 0.03 && (areas[1] / AREA - 1.0).abs() < 0.02, "{areas:?}");
    let marks = [small, large].map(|measured| measured["marks"].as_f64().unwrap());
    // The canvas is 3.5 times as large, with a smaller share of border.
    assert!((3.3..6.0).contains(&(marks[1] / marks[0])), "{marks:?}");
}

#[test]
fn a_larger_scale_is_the_same_pattern_smoothly_finer() {
    for document in [spots(), stripes()] {
        let folder = Folder::with(&document);
        folder.grow("--pattern one.png");
        folder.grow("--pattern three.png --scale 3 --labels labels.png");
        let ([width, height], one) = folder.gray16("one.png");
        let (sides, three) = folder.gray16("three.png");
        assert_eq!(sides, [3 * width, 3 * height]);
        let at = |x: usize, y: usize| f64::from(three[y * 3 * width + x]) / 65535.0;
        let mut worst: f64 = 0.0;
        for (px, value) in one.iter().enumerate() {
            let (x, y) = (px % width, px / width);
            let nine = (0..9).map(|k| at(3 * x + k % 3, 3 * y + k / 3)).sum::<f64>() / 9.0;
            worst = worst.max((nine - f64::from(*value) / 65535.0).abs());
        }
        assert!(worst < 0.03, "{worst}");
        // If px were only repeated, all steps would be between the former px, and none inside them.
        let (mut inside, mut between) = (0.0, 0.0);
        for y in 0..3 * height {
            for x in 0..3 * width - 3 {
                let step = (at(x + 1, y) - at(x, y)).abs();
                *(if x % 3 == 2 { &mut between } else { &mut inside }) += step;
            }
        }
        let share: f64 = inside / between / 2.0;
        assert!((share - 1.0).abs() < 0.05, "{share}");
        assert_eq!(folder.gray8("labels.png").0, sides);
    }
}

#[test]
fn a_pattern_has_both_sides_of_a_mark_s_edge() {
    for document in [spots(), stripes()] {
        let folder = Folder::with(&document);
        folder.grow("--pattern p.png");
        let ([width, height], values) = folder.gray16("p.png");
        assert_eq!(document["size"], json!([width, height]));
        let share = |within: &dyn Fn(u16) -> bool| {
            values.iter().filter(|value| within(**value)).count() as f64 / values.len() as f64
        };
        assert!(share(&|value| value < 16384) > 0.2 && share(&|value| value > 40000) > 0.02);
        // Values near the edge are not clipped: hardly any two px there are equal.
        let mut near: Vec<u16> =
            values.iter().copied().filter(|value| (16384..49152).contains(value)).collect();
        let all = near.len();
        near.sort_unstable();
        near.dedup();
        assert!(all > 500 && near.len() > all * 8 / 10, "{} of {all}", near.len());
    }
}

#[test]
fn the_pattern_of_layer_1_is_that_of_the_only_layer() {
    let folder = Folder::with(&spots());
    folder.grow("--pattern all.png");
    folder.grow("--pattern one.png --layer 1");
    assert!(folder.bytes("all.png") == folder.bytes("one.png"));
}

#[test]
fn labels_are_where_the_pattern_is_above_one_half() {
    let folder = Folder::with(&spots());
    folder.grow("--pattern p.png --labels l.png");
    let (sides, pattern) = folder.gray16("p.png");
    let (label_sides, labels) = folder.gray8("l.png");
    assert_eq!(sides, label_sides);
    assert!(labels.contains(&0) && labels.contains(&1));
    for (px, (label, value)) in labels.iter().zip(&pattern).enumerate() {
        assert_eq!(*label, u8::from(*value >= 32768), "px {px} of {value}");
    }
}

#[test]
fn an_invisible_layer_covers_nothing() {
    let mut document = spots();
    document["layers"][0]["visible"] = json!(false);
    let folder = Folder::with(&document);
    folder.grow("--labels l.png --pattern p.png --layer 1");
    assert!(folder.gray8("l.png").1.iter().all(|label| *label == 0));
    assert!(folder.gray16("p.png").1.iter().any(|value| *value > 32768));
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

#[test]
fn a_report_has_the_keys_of_the_format() {
    let mut document = spots();
    document["layers"][0]["name"] = json!("fur");
    document["regions"] = json!([2, 1]);
    let folder = Folder::with(&document);
    folder.grow("--report r.json --seed 5");
    let report = folder.json("r.json");
    assert_eq!(keys(&report), ["document", "size", "seed", "seconds", "layers"]);
    assert_eq!(report["document"], "a.dapple");
    assert_eq!((&report["size"], &report["seed"]), (&json!([128, 128]), &json!(5)));
    assert!(report["seconds"].as_f64().unwrap() > 0.0);
    let layer = &report["layers"][0];
    assert_eq!(keys(layer), ["name", "system", "inverted", "cell", "grid", "steps", "settled", "regions"]);
    assert_eq!((&layer["name"], &layer["settled"]), (&json!("fur"), &json!(true)));
    assert_eq!(layer["system"], "meinhardt-spots");
    assert!(layer["steps"].as_u64().unwrap() > 0);
    let cell = layer["cell"].as_f64().unwrap();
    let across = layer["grid"][0].as_f64().unwrap() * cell;
    assert!((across - 128.0).abs() < 1.0, "{across} px");
    let regions = layer["regions"].as_array().unwrap();
    assert_eq!(
        regions.iter().map(|region| &region["region"]).collect::<Vec<_>>(),
        [&json!([0, 0]), &json!([1, 0])]
    );
    let attributes = ["area", "aspect", "angle", "spacing"];
    for region in regions {
        let expected =
            ["region", "marks", "merged", "asked", "parameters", "predicted", "got", "error", "notes"];
        assert_eq!(keys(region), expected);
        for part in ["asked", "predicted", "got", "error"] {
            assert_eq!(keys(&region[part]), attributes, "{part}");
        }
        assert_eq!(region["parameters"]["cell"], layer["cell"]);
        assert!(region["marks"].as_u64().unwrap() > 5 && region["notes"].is_array());
    }
}

#[test]
fn a_report_of_stripes_leaves_out_what_only_spots_have() {
    let folder = Folder::with(&stripes());
    folder.grow("--report r.json");
    let report = folder.json("r.json");
    let layer = &report["layers"][0];
    assert_eq!(layer["system"], "meinhardt-stripes");
    let region = &layer["regions"][0];
    for part in ["asked", "predicted", "got"] {
        assert_eq!(keys(&region[part]), ["width", "angle"], "{part}");
    }
    assert!(region["error"]["width"].is_f64() && region["error"]["angle"].is_f64());
}

#[test]
fn without_refinement_the_level_is_that_of_the_lookup() {
    let mut document = spots();
    let folder = Folder::with(&document);
    folder.grow("--report refined.json --pattern refined.png --no-document");
    folder.grow("--report looked_up.json --pattern looked_up.png --no-refine --no-document");
    let region = |name: &str| folder.json(name)["layers"][0]["regions"][0].clone();
    let [refined, looked_up] = ["refined.json", "looked_up.json"].map(region);
    let error = |region: &Value| region["error"]["area"].as_f64().unwrap().abs();
    assert!(error(&refined) < 0.002 && error(&looked_up) > error(&refined), "{refined} {looked_up}");
    assert!(folder.bytes("refined.png") != folder.bytes("looked_up.png"));
    assert_eq!(refined["parameters"]["rate"], looked_up["parameters"]["rate"]);
    // The document has the same option.
    document["growth"] = json!({"refine": false});
    folder.write("a.dapple", &document.to_string());
    folder.grow("--pattern own.png --no-document");
    assert!(folder.bytes("own.png") == folder.bytes("looked_up.png"));
}

#[test]
fn quiet_prints_nothing() {
    // Marks below the range of the training rows, which gives a note.
    let mut document = spots();
    document["size"] = json!([20, 20]);
    document["layers"][0]["strokes"] =
        json!([{"kind": "ellipse", "center": [10, 10], "radii": [0.1, 0.1], "angle": 0}]);
    let folder = Folder::with(&document);
    assert!(folder.grow("").contains("note: layer 1, region [0,0]: "));
    assert_eq!(folder.grow("--quiet"), "");
    assert_eq!(folder.grow("-q --report r.json"), "");
    assert!(!folder.json("r.json")["layers"][0]["regions"][0]["notes"].as_array().unwrap().is_empty());
}

#[test]
fn a_growth_without_notes_prints_nothing() {
    let folder = Folder::with(&spots());
    assert_eq!(folder.grow(""), "");
}
