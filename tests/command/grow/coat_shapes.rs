//! What coats have beyond their marks: a second colour of the ground by place, no halo, marks near those beneath, and a warp. The picture
//! shows it, and what was asked for stays.

use dapple_engine::grid::Edges;
use serde_json::{Value, json};

use crate::grow::finish::counted;
use crate::grow::folder::Folder;

const ORANGE: [u8; 3] = [0xe0, 0x90, 0x40];
const BLACK: [u8; 3] = [0x10, 0x0c, 0x08];

/// A seamless document with five spots on orange ground, black with a wide halo.
fn spots() -> Value {
    let spot = |center: [f64; 2]| json!({"kind": "ellipse", "center": center, "radii": [10, 8], "angle": 30});
    json!({"format": "dapple", "version": 2, "size": [240, 240], "edges": "wrap", "layers": [{
        "system": "meinhardt-spots",
        "strokes": [spot([60.0, 60.0]), spot([92.0, 60.0]), spot([76.0, 88.0]), spot([108.0, 88.0]), spot([92.0, 116.0])],
        "colours": {"stops": [{"at": 0, "colour": "#e09040"}, {"at": 1, "colour": "#100c08"}]}}]})
}

/// The picture of a folder: red, green, blue a px.
fn rgb(folder: &Folder) -> Vec<[u8; 3]> {
    let picture = image::open(folder.path("a.png")).unwrap().into_rgb8();
    picture.pixels().map(|px| px.0).collect()
}

fn distance(a: [u8; 3], b: [u8; 3]) -> i32 {
    a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(b)).abs()).sum()
}

const ALL: &str = "--pattern p.png --labels l.png --report r.json --no-document";

fn without_seconds(folder: &Folder) -> Value {
    let mut report = folder.json("r.json");
    report.as_object_mut().unwrap().remove("seconds");
    report
}

#[test]
fn the_ground_gets_its_second_colour_where_the_map_says() {
    let plain = Folder::with(&spots());
    plain.grow(ALL);
    let mut document = spots();
    document["layers"][0]["colours"]["ground"] = json!("#f8f0e8");
    let folder = Folder::with(&document);
    // From black at the left to white at the right.
    let ramp = image::GrayImage::from_fn(64, 2, |x, _| image::Luma([(x * 4 + x / 16) as u8]));
    ramp.save(folder.path("ramp.png")).unwrap();
    folder.grow(&format!("--map ground=ramp.png:-1:2 {ALL}"));
    for name in ["p.png", "l.png"] {
        assert!(folder.bytes(name) == plain.bytes(name), "{name}");
    }
    assert_eq!(without_seconds(&folder)["layers"], without_seconds(&plain)["layers"]);
    let (before, after) = (rgb(&plain), rgb(&folder));
    let pattern = folder.pattern("p.png", Edges::Wrap).values;
    for px in 0..before.len() {
        let column = px % 240;
        // Black gives the first colour, white the second one; within marks nothing changes.
        if column < 60 || pattern[px] > 0.999 {
            assert!(distance(before[px], after[px]) <= 3, "{px}");
        } else if column > 185 && pattern[px] < 0.001 {
            assert!(distance(after[px], [0xf8, 0xf0, 0xe8]) <= 3, "{px}: {:?}", after[px]);
        }
    }
}

#[test]
fn without_a_halo_the_ground_has_its_own_colour_up_to_the_marks() {
    let [with, without] = [1.0, 0.05].map(|halo| {
        let mut document = spots();
        document["layers"][0]["colours"]["halo"] = json!(halo);
        let folder = Folder::with(&document);
        folder.grow(ALL);
        folder
    });
    assert!(with.bytes("l.png") == without.bytes("l.png"));
    let pattern = with.pattern("p.png", Edges::Wrap).values;
    let (halo, none) = (rgb(&with), rgb(&without));
    let rim: Vec<usize> = (0..pattern.len()).filter(|px| (0.2..0.45).contains(&pattern[*px])).collect();
    assert!(rim.len() > 500, "{}", rim.len());
    assert!(rim.iter().all(|px| distance(none[*px], ORANGE) <= 2));
    assert!(rim.iter().all(|px| distance(halo[*px], ORANGE) > 30));
    let inside = (0..pattern.len()).filter(|px| pattern[*px] > 0.55);
    assert!(inside.clone().all(|px| distance(none[px], halo[px]) <= 3));
    assert!(inside.clone().any(|px| distance(none[px], BLACK) <= 12));
}

#[test]
fn warped_marks_keep_their_number_their_mean_area_and_the_report() {
    let (plain, mut document) = (Folder::with(&spots()), spots());
    plain.grow(ALL);
    document["warp"] = json!({"size": 60, "by": 5});
    let folder = Folder::with(&document);
    folder.grow(ALL);
    assert_eq!(without_seconds(&folder)["layers"], without_seconds(&plain)["layers"]);
    let labels = [&plain, &folder].map(|folder| folder.gray8("l.png"));
    let [[marks, before], [still, after]] = labels.each_ref().map(counted);
    assert_eq!(marks, still);
    assert!((after as f64 / before as f64 - 1.0).abs() < 0.005, "{before} {after}");
    let [one, other] = labels.map(|(_, labels)| labels);
    let moved = one.iter().zip(&other).filter(|(a, b)| a != b).count();
    assert!(moved > one.len() / 20, "{moved}");
    // The number of threads changes nothing. Outlines are bent, too.
    folder.grow("--threads 3 --pattern q.png --svg o.svg --no-document");
    assert!(folder.bytes("p.png") == folder.bytes("q.png"));
    plain.grow("--svg o.svg --no-document");
    assert!(folder.bytes("o.svg") != plain.bytes("o.svg"));
}

/// Large spots, and small ones that meet them like this.
fn specks(after: &str) -> Value {
    let mut document = spots();
    document["size"] = json!([400, 400]);
    document["layers"][0]["strokes"] = json!([{"kind": "ellipse", "center": [200, 200], "radii": [26, 22]}]);
    document["layers"][0]["system"] = json!("patches");
    let small = |center: [f64; 2]| json!({"kind": "ellipse", "center": center, "radii": [4, 4]});
    let options = if after == "near" { json!({"keep": false, "near": 8}) } else { json!({"keep": false}) };
    document["layers"].as_array_mut().unwrap().push(json!({"system": "meinhardt-spots", "after": after,
        "options": options, "strokes": [small([60.0, 60.0]), small([76.0, 60.0]), small([68.0, 74.0])]}));
    document["layers"][0]["maps"] = json!({});
    document
}

#[test]
fn marks_near_those_beneath_are_some_of_those_that_grow_between_them() {
    let [between, near] = ["between", "near"].map(|after| {
        let folder = Folder::with(&specks(after));
        folder.grow("--pattern p.png --layer 2 --labels l.png --report r.json");
        folder
    });
    assert_eq!(
        without_seconds(&between)["layers"][1]["regions"],
        without_seconds(&near)["layers"][1]["regions"]
    );
    let [all, some] = [&between, &near].map(|folder| folder.pattern("p.png", Edges::Wrap).values);
    let ink = |pattern: &[f32]| pattern.iter().filter(|value| **value >= 0.5).count();
    assert!(ink(&some) * 5 < ink(&all) * 4 && ink(&some) > 200, "{} {}", ink(&all), ink(&some));
    // No mark is where none was before.
    let new = all.iter().zip(&some).filter(|(all, some)| **all < 0.45 && **some >= 0.5).count();
    assert_eq!(new, 0);
}

#[test]
fn what_has_no_marks_beneath_or_no_plane_is_refused_with_the_reason() {
    let mut lowest = spots();
    lowest["layers"][0]["after"] = json!("near");
    Folder::with(&lowest).refuses("grow a.dapple -o a.png", 1, &["\"near\"", "no other beneath"]);
    let mut on_model = spots();
    on_model["model"] = json!({"file": "sphere"});
    on_model["warp"] = json!({"size": 40, "by": 3});
    Folder::with(&on_model).refuses("grow a.dapple -o a.png", 1, &["warp", "no plane"]);
}
