//! Patches: blotches with the area, distance, shape, direction and raggedness that were drawn.

use dapple_engine::measure::raggedness;
use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// A blotch with this area (px²), aspect and direction, whose radius varies by the share `rough`.
fn blot([x, y]: [f64; 2], area: f64, aspect: f64, angle: f64, rough: f64) -> Vec<[f64; 2]> {
    let major = (area / std::f64::consts::PI / aspect).sqrt();
    let (s, c) = angle.to_radians().sin_cos();
    let corner = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / 60.0;
        let wave = |n: f64| (n * turn + 0.7 * n * x + 0.3 * y).sin() / n.sqrt();
        let r = major * (1.0 + rough * (wave(3.0) + wave(5.0) + wave(7.0)));
        let [u, v] = [r * turn.cos(), aspect * r * turn.sin()];
        [x + c * u - s * v, y + s * u + c * v]
    };
    (0..60).map(corner).collect()
}

fn outline(points: &[[f64; 2]]) -> Value {
    json!({"kind": "outline", "points": points})
}

/// The values of a sketch: canvas side, coverage, area, aspect, angle, roughness, edges.
struct Sketch(f64, f64, f64, f64, f64, f64, &'static str);

impl Sketch {
    /// A document with nine blotches on a hexagonal lattice, at the distance at which they cover the share.
    fn document(&self) -> Value {
        let Self(side, coverage, area, aspect, angle, rough, edges) = *self;
        let apart = (area * 2.0 / (3f64.sqrt() * coverage)).sqrt();
        let place = |k: usize| {
            let (column, row) = ((k % 3) as f64, (k / 3) as f64);
            let x = (column - 1.0 + 0.5 * (row % 2.0)) * apart;
            [0.5 * side + x, 0.5 * side + (row - 1.0) * 0.75f64.sqrt() * apart]
        };
        let strokes: Vec<Value> =
            (0..9).map(|k| outline(&blot(place(k), area, aspect, angle, rough))).collect();
        json!({"format": "dapple", "version": 2, "size": [side, side], "edges": edges,
            "layers": [{"strokes": strokes, "options": {"keep": false}}]})
    }
}

fn report(document: &Value, more: &str) -> (Folder, Value) {
    let folder = Folder::with(document);
    folder.grow(&format!("--report r.json {more}"));
    let report = folder.json("r.json");
    (folder, report)
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn patches_have_the_drawn_area_spacing_aspect_direction_and_raggedness() {
    for sketch in [
        Sketch(640.0, 0.25, 1500.0, 0.55, 30.0, 0.12, "wrap"),
        Sketch(640.0, 0.4, 1500.0, 0.7, 120.0, 0.2, "closed"),
        Sketch(560.0, 0.6, 1000.0, 0.6, 80.0, 0.1, "wrap"),
    ] {
        let document = sketch.document();
        let Sketch(_, coverage, ..) = sketch;
        let (_, report) = report(&document, "");
        let layer = &report["layers"][0];
        assert_eq!(layer["system"], "patches");
        let region = &layer["regions"][0];
        assert!(number(region, "marks") > 60.0, "{region}");
        for (key, value) in [("asked", 0.0), ("got", 1.0), ("error", 2.0)] {
            for attribute in ["area", "spacing", "aspect", "angle", "raggedness"] {
                assert!(number(&region[key], attribute).is_finite() && value < 3.0);
            }
        }
        let within = |attribute: &str, most: f64| number(&region["error"], attribute).abs() < most;
        assert!(within("area", 0.03) && within("spacing", 0.06), "coverage {coverage}: {region}");
        assert!(within("aspect", 0.08) && within("angle", 8.0), "coverage {coverage}: {region}");
        assert!(within("raggedness", 0.15), "coverage {coverage}: {region}");
    }
}

#[test]
fn patches_are_asked_to_have_the_attributes_of_the_drawn_outlines() {
    let drawn =
        [blot([150.0, 140.0], 2400.0, 0.6, 30.0, 0.18), blot([250.0, 150.0], 2400.0, 0.6, 30.0, 0.18)];
    let ragged: f64 = drawn.iter().map(|points| raggedness(points).unwrap()).sum::<f64>() / 2.0;
    let strokes: Vec<Value> = drawn.iter().map(|points| outline(points)).collect();
    let mut document =
        json!({"format": "dapple", "version": 2, "size": [400, 300], "layers": [{"strokes": strokes}]});
    let folder = Folder::with(&document);
    let checked = |folder: &Folder| -> Value {
        let output = folder.dapple("check a.dapple --json").assert().success().get_output().clone();
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let layer = &checked(&folder)["layers"][0];
    assert_eq!((&layer["system"], &layer["drawn"]["outline"]), (&json!("patches"), &json!(2)));
    let region = &layer["regions"][0];
    assert!((number(region, "raggedness") / ragged - 1.0).abs() < 0.02, "{region} for {ragged}");
    assert!((number(&region["asked"], "spacing") / 100.5 - 1.0).abs() < 0.1, "{region}");
    // Where the raggedness is given, the drawn outlines do not matter for it.
    let given = |sigma: f64, document: &mut Value| {
        document["layers"][0]["options"] = json!({"ragged": sigma});
        number(&checked(&Folder::with(document))["layers"][0]["regions"][0], "raggedness")
    };
    assert!(given(0.0, &mut document) < 1.15 && given(0.45, &mut document) > 1.7);
}

#[test]
fn a_picture_of_patches_has_the_raggedness_that_the_report_says() {
    let (folder, report) =
        report(&Sketch(640.0, 0.3, 1500.0, 0.6, 40.0, 0.18, "closed").document(), "--pattern p.png");
    let region = &report["layers"][0]["regions"][0]["got"];
    for picture in ["a.png", "p.png"] {
        let output = folder.dapple(&format!("measure {picture} --patches --json")).assert().success();
        let found: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
        assert_eq!(found["kind"], "spots");
        assert!(
            (number(&found, "raggedness") / number(region, "raggedness") - 1.0).abs() < 0.03,
            "{found} {region}"
        );
        assert!((number(&found, "area") / number(region, "area") - 1.0).abs() < 0.02, "{found} {region}");
    }
}

#[test]
fn kept_patches_are_the_drawn_outlines() {
    let drawn = [
        blot([120.0, 120.0], 6000.0, 0.8, 20.0, 0.2),
        blot([300.0, 160.0], 4000.0, 0.6, 100.0, 0.1),
        vec![[180.0, 260.0], [270.0, 240.0], [230.0, 330.0]],
    ];
    let strokes: Vec<Value> = drawn.iter().map(|points| outline(points)).collect();
    let document =
        json!({"format": "dapple", "version": 2, "size": [440, 400], "layers": [{"strokes": strokes}]});
    let (folder, report) = report(&document, "--pattern p.png");
    let marks = report["layers"][0]["drawn"].as_array().unwrap();
    assert_eq!(marks.len(), 3);
    for mark in marks {
        assert!(mark["there"] == true && number(mark, "off") <= 0.15, "{mark}");
    }
    // Checked in the picture itself: inside each outline nearly all px are above the edge.
    let ([width, _], values) = folder.gray16("p.png");
    for points in &drawn {
        let (mut inside, mut grown) = (0, 0);
        for (px, value) in values.iter().enumerate() {
            if holds(points, [(px % width) as f64 + 0.5, (px / width) as f64 + 0.5]) {
                (inside, grown) = (inside + 1, grown + i32::from(*value >= 32_768));
            }
        }
        assert!(f64::from(grown) > 0.92 * f64::from(inside), "{grown} of {inside}");
    }
}

/// Whether a point lies in a polygon.
fn holds(points: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let sides = points.iter().zip(points.iter().cycle().skip(1));
    let crossed = sides
        .filter(|(a, b)| (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    crossed.count() % 2 == 1
}

#[test]
fn ellipses_give_smooth_patches_and_regions_differ() {
    let ellipse = |x: f64, y: f64, r: f64| json!({"kind": "ellipse", "center": [x, y], "radii": [r, 0.7 * r], "angle": 40});
    let strokes = [
        ellipse(90.0, 100.0, 16.0),
        ellipse(140.0, 110.0, 16.0),
        ellipse(110.0, 150.0, 16.0),
        ellipse(400.0, 100.0, 28.0),
        ellipse(500.0, 110.0, 28.0),
        ellipse(440.0, 180.0, 28.0),
    ];
    let document = json!({"format": "dapple", "version": 2, "size": [600, 400], "regions": [2, 1],
        "layers": [{"system": "patches", "strokes": strokes}]});
    let (_, report) = report(&document, "");
    let regions = report["layers"][0]["regions"].as_array().unwrap();
    assert_eq!(regions.len(), 2);
    for region in regions {
        assert!(number(&region["error"], "area").abs() < 0.08, "{region}");
        assert!((1.0..1.08).contains(&number(&region["got"], "raggedness")), "{region}");
    }
    assert!(number(&regions[1]["got"], "area") > 1.8 * number(&regions[0]["got"], "area"));
}

#[test]
fn patches_do_not_touch_layers_beneath_and_layers_above_do_not_touch_patches() {
    let layer = |name: &str, at: [f64; 2], area: f64, apart: f64| {
        let strokes = [
            outline(&blot(at, area, 0.7, 0.0, 0.1)),
            outline(&blot([at[0] + apart, at[1]], area, 0.7, 0.0, 0.1)),
        ];
        json!({"name": name, "strokes": strokes, "options": {"keep": false}})
    };
    let spots = json!({"name": "spots", "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [7, 6]},
        {"kind": "ellipse", "center": [100, 60], "radii": [7, 6]}]});
    let document = json!({"format": "dapple", "version": 2, "size": [320, 320], "edges": "wrap",
        "layers": [layer("large", [100.0, 100.0], 3000.0, 90.0), layer("small", [160.0, 200.0], 700.0, 60.0), spots]});
    let folder = Folder::with(&document);
    folder.grow("--labels l.png --report r.json --svg o.svg");
    let ([width, height], labels) = folder.gray8("l.png");
    let share = |label: u8| labels.iter().filter(|px| **px == label).count() as f64 / labels.len() as f64;
    assert!(share(1) > 0.1 && share(2) > 0.03 && share(3) > 0.005, "{} {} {}", share(1), share(2), share(3));
    // No px of the second layer touches one of the first.
    let at = |x: usize, y: usize| labels[(y % height) * width + x % width];
    let touching = (0..labels.len()).filter(|px| {
        let (x, y) = (px % width, px / width);
        let beside = [at(x + 1, y), at(x, y + 1)];
        (at(x, y) == 1 && beside.contains(&2)) || (at(x, y) == 2 && beside.contains(&1))
    });
    let touching = touching.count();
    assert!(touching < 12, "{touching} px touch");
    assert!(String::from_utf8(folder.bytes("o.svg")).unwrap().contains("<path"));
}

#[test]
fn the_number_of_threads_of_the_computer_changes_no_byte() {
    let folder = Folder::with(&Sketch(256.0, 0.4, 900.0, 0.7, 10.0, 0.15, "wrap").document());
    let grown = [1, 3].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
}

#[test]
fn a_larger_canvas_gives_more_patches_of_the_same_size() {
    let folder = Folder::with(&Sketch(256.0, 0.4, 900.0, 0.7, 10.0, 0.15, "closed").document());
    let regions = ["", "--size 512x384"].map(|size| {
        folder.grow(&format!("--report r.json {size}"));
        folder.json("r.json")["layers"][0]["regions"][0].clone()
    });
    assert!(number(&regions[1], "marks") > 2.0 * number(&regions[0], "marks"));
    assert!((number(&regions[1]["got"], "area") / 900.0 - 1.0).abs() < 0.1, "{}", regions[1]);
}

#[test]
fn impossible_patches_are_refused_with_the_reason() {
    let small = || Sketch(200.0, 0.3, 400.0, 0.8, 0.0, 0.1, "closed").document();
    let mut above = small();
    let own = above["layers"][0].clone();
    above["layers"].as_array_mut().unwrap().push(own);
    for after in ["around", "net", "inside"] {
        above["layers"][1]["system"] = json!("patches");
        above["layers"][1]["options"] = json!({});
        above["layers"][1]["after"] = json!(after);
        let folder = Folder::with(&above);
        folder.refuses("grow a.dapple -o a.png", 1, &["layers[1]", "found"]);
        folder.refuses("check a.dapple", 1, &["layers[1]"]);
    }
    let ring = json!({"name": "rings", "after": "around", "strokes": [{"kind": "line", "from": [10, 10], "to": [60, 10], "width": 4}]});
    above["layers"][1] = ring;
    Folder::with(&above).refuses(
        "grow a.dapple -o a.png",
        1,
        &["layers[1].after", "allowed: between", "scattered points"],
    );
    let mut lines = small();
    lines["layers"][0] =
        json!({"system": "patches", "strokes": [{"kind": "line", "from": [10, 10], "to": [60, 10]}]});
    Folder::with(&lines).refuses("check a.dapple", 1, &["layers[0].system", "spots", "lines"]);
}

#[test]
fn rosettes_are_measured_by_their_outlines_and_have_less_ink_than_solid_patches() {
    let patches = |options: Value| {
        let ellipse = |x: u32, y: u32| json!({"kind": "ellipse", "center": [x, y], "radii": [20, 16]});
        json!({"format": "dapple", "version": 2, "size": [256, 256], "edges": "wrap", "layers": [{
            "system": "patches", "strokes": [ellipse(80, 80), ellipse(126, 84), ellipse(102, 126)], "options": options
        }]})
    };
    let grown = |options: Value| {
        let folder = Folder::with(&patches(options));
        folder.grow("--labels l.png --report r.json");
        let ink = image::open(folder.path("l.png")).unwrap().into_luma8();
        let ink = ink.pixels().filter(|px| px.0[0] > 0).count();
        (ink, folder.json("r.json")["layers"][0]["regions"][0]["got"].clone())
    };
    let (solid, of_patches) = grown(json!({"keep": false}));
    let (broken, of_rosettes) = grown(json!({"keep": false, "rosette": {"solid": 0}}));
    assert!(broken * 10 < solid * 9 && broken * 4 > solid, "{broken} of {solid}");
    for key in ["area", "spacing", "raggedness"] {
        let [of_patches, of_rosettes] = [&of_patches, &of_rosettes].map(|got| got[key].as_f64().unwrap());
        assert!((of_rosettes / of_patches - 1.0).abs() < 0.05, "{key}: {of_rosettes} of {of_patches}");
    }
}
