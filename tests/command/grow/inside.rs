//! A layer inside another one: the lower one is neither painted nor labelled. All commands report sparse spots.

use crate::grow::folder::{Folder, document};
use dapple::document::Edges;
use serde_json::{Value, json};

fn ellipse(center: [f64; 2], radii: [f64; 2]) -> Value {
    json!({"kind": "ellipse", "center": center, "radii": radii, "angle": 30})
}

/// Small black marks on white with hard edges, inside large red ones on green.
fn inside() -> Value {
    let stops = |ground: &str, mark: &str| json!({"stops": [{"at": 0, "colour": ground}, {"at": 0.5, "colour": ground}, {"at": 0.5, "colour": mark}]});
    let large = [ellipse([60.0, 60.0], [13.0, 12.0]), ellipse([108.0, 60.0], [13.0, 12.0])];
    let mut document = document([200, 160], &json!(large));
    document["edges"] = json!("wrap");
    document["layers"][0]["name"] = json!("places");
    document["layers"][0]["colours"] = stops("#00ff00", "#ff0000");
    let small = json!([ellipse([60.0, 60.0], [6.0, 4.0])]);
    let above = json!({"after": "inside", "strokes": small, "colours": stops("#ffffff", "#000000")});
    document["layers"].as_array_mut().unwrap().push(above);
    document
}

#[test]
fn the_layer_that_gives_the_places_is_neither_painted_nor_labelled() {
    let folder = Folder::with(&inside());
    let printed = folder.grow("--labels l.png --pattern p.png --layer 1 --report r.json");
    assert!(printed.contains("one mark inside each mark of \"places\", which is not shown"), "{printed}");
    let labels = folder.gray8("l.png").1;
    assert!(labels.iter().all(|label| [0, 2].contains(label)) && labels.contains(&2));
    let picture = image::open(folder.path("a.png")).unwrap().into_rgb8();
    let black_or_white = |px: &image::Rgb<u8>| px.0 == [0; 3] || px.0 == [255; 3];
    assert!(picture.pixels().all(black_or_white));
    // The pattern of that layer can still be written separately.
    let large = dapple_engine::measure::spots(&folder.pattern("p.png", Edges::Wrap), 0.5);
    let report = folder.json("r.json");
    assert_eq!(report["layers"][0]["shown"], json!(false));
    assert!(report["layers"][1]["shown"].is_null());
    assert_eq!(report["layers"][1]["regions"][0]["marks"], json!(large.len()));
    let spacing = |layer: usize| report["layers"][layer]["regions"][0]["asked"]["spacing"].as_f64().unwrap();
    assert!((spacing(1) / spacing(0) - 1.0).abs() < 0.02, "{} {}", spacing(0), spacing(1));
}

#[test]
fn check_and_grow_report_marks_that_do_not_fit_inside() {
    let mut document = inside();
    document["layers"][1]["strokes"] = json!([ellipse([60.0, 60.0], [20.0, 20.0])]);
    let folder = Folder::with(&document);
    for command in ["check a.dapple", "grow a.dapple -o a.png"] {
        folder.refuses(command, 1, &["a.dapple", "layers[1].strokes", "1257 px²", "smaller"]);
    }
    let output = Folder::with(&inside()).dapple("check a.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("(auto, inside)") && text.contains("layer 2: grown by meinhardt-spots"), "{text}");
}

#[test]
fn lookup_check_and_grow_report_sparse_spots_alike() {
    let sparse = [ellipse([100.0, 100.0], [4.0, 3.0]), ellipse([180.0, 100.0], [4.0, 3.0])];
    let folder = Folder::with(&document([400, 300], &json!(sparse)));
    let said = |arguments: &str| {
        let output = folder.dapple(arguments).assert().success().get_output().clone();
        String::from_utf8([output.stdout, output.stderr].concat()).unwrap()
    };
    let area = std::f64::consts::PI * 12.0;
    let lookup =
        format!("lookup --system meinhardt-spots --area {area} --aspect 0.75 --angle 30 --spacing 80");
    for arguments in [lookup.as_str(), "check a.dapple", "grow a.dapple -o a.png"] {
        let said = said(arguments);
        assert!(said.contains("spots are placed one by one, 5.2 times as far apart"), "{said}");
    }
    let answer: Value = serde_json::from_str(&said(&format!("{lookup} --json"))).unwrap();
    assert!(answer["parameters"]["pitch"].as_f64().unwrap() > 4.0, "{answer}");
    assert_eq!((&answer["coverage"], &answer["nearest"]), (&json!("edge"), &answer["predicted"]));
    assert!((answer["predicted"]["spacing"].as_f64().unwrap() - 80.0).abs() < 1e-9, "{answer}");
}
