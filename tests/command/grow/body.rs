//! Documents on models: pictures, glTF and PLY files, reports, refusals.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// Spots of this radius and aspect in a hexagonal lattice, `spacing` px apart, on a model.
pub fn on(model: &Value, radius: f64, aspect: f64, angle: f64, spacing: f64) -> Value {
    let radii = [radius / aspect.sqrt(), radius * aspect.sqrt()];
    let rows = (0..4).flat_map(|row| (0..4).map(move |column| [f64::from(column), f64::from(row)]));
    let spots = rows.map(|[column, row]| {
        let center = [40.0 + spacing * (column + 0.5 * (row % 2.0)), 40.0 + spacing * 0.866 * row];
        json!({"kind": "ellipse", "center": center, "radii": radii, "angle": angle})
    });
    let spots: Vec<Value> = spots.collect();
    json!({"format": "dapple", "version": 2, "size": [220, 200], "model": model, "layers": [{"strokes": spots}]})
}

/// A document with 60 spots on a small sphere.
fn ball() -> Value {
    on(&json!({"file": "sphere", "px": 130}), 4.6, 1.0, 0.0, 28.0)
}

/// A region of a layer in a report.
fn region(folder: &Folder, name: &str, index: usize) -> Value {
    folder.json(name)["layers"][0]["regions"][index].clone()
}

#[test]
fn spots_on_a_sphere_have_the_drawn_area_and_spacing_and_none_of_them_dies() {
    let folder = Folder::with(&ball());
    folder.grow("--report r.json --size 300x200 -q");
    let picture = image::open(folder.path("a.png")).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (300, 200));
    let layer = folder.json("r.json")["layers"][0].clone();
    assert_eq!(layer["laid"], layer["spots"]);
    let region = region(&folder, "r.json", 0);
    assert!(region["marks"].as_u64().unwrap() > 40, "{region}");
    let error = |key: &str| region["error"][key].as_f64().unwrap();
    assert!(error("area").abs() < 0.005 && error("spacing").abs() < 0.03, "{region}");
    assert!(region["size_before_level"].as_f64().unwrap().abs() < 0.03, "{region}");
    assert!(error("aspect").abs() < 0.03, "{region}");
}

#[test]
fn the_picture_holds_the_document_and_grows_again_on_any_number_of_threads() {
    let folder = Folder::with(&ball());
    folder.grow("--size 120x120 --threads 1 -q");
    folder.dapple("grow a.png -o b.png --size 120x120 --threads 3 -q").assert().success();
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
    folder.dapple("grow a.dapple -o c.png --size 120x120 --view 90,40 -q").assert().success();
    assert_ne!(folder.bytes("a.png"), folder.bytes("c.png"));
}

#[test]
fn other_readers_open_the_model_with_its_colours() {
    let mut document = ball();
    // A body without texture coordinates.
    document["model"]["file"] = json!("shell");
    let folder = Folder::with(&document);
    folder.dapple("grow a.dapple -o a.glb -q").assert().success();
    let (document, buffers, _) = gltf::import(folder.path("a.glb")).unwrap();
    let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
    let colours: Vec<[f32; 4]> = reader.read_colors(0).unwrap().into_rgba_f32().collect();
    assert_eq!(colours.len(), reader.read_positions().unwrap().count());
    let lightness = |[r, g, b, _]: [f32; 4]| r + g + b;
    let [dark, light] =
        [f32::min, f32::max].map(|pick| colours.iter().map(|c| lightness(*c)).reduce(pick).unwrap());
    assert!(light > 2.0 * dark, "spots and ground: {dark} {light}");
    folder.dapple("grow a.dapple -o a.ply -q").assert().success();
    let head = String::from_utf8_lossy(&folder.bytes("a.ply")[..300]).into_owned();
    assert!(head.starts_with("ply\nformat binary_little_endian") && head.contains("uchar red"), "{head}");
}

#[test]
fn long_spots_have_the_aspect_and_the_direction_that_are_asked_for_at_their_places() {
    let model = json!({"file": "cylinder", "px": 200, "along": "y"});
    for angle in [0.0, 40.0] {
        let folder = Folder::with(&on(&model, 4.6, 0.5, angle, 28.0));
        folder.grow("--report r.json --size 64x64 -q");
        let region = region(&folder, "r.json", 0);
        assert!(region["error"]["angle"].as_f64().unwrap().abs() < 3.0, "{angle}: {region}");
        assert!(region["error"]["aspect"].as_f64().unwrap().abs() < 0.04, "{angle}: {region}");
    }
}

#[test]
fn pins_hold_regions_at_their_places() {
    let mut document = on(
        &json!({"file": "capsule", "px": 260, "pins": [
        {"region": [0, 0], "at": [0, -1, 0]}, {"region": [1, 0], "at": [0, 1, 0]}]}),
        4.0,
        1.0,
        0.0,
        26.0,
    );
    document["regions"] = json!([2, 1]);
    let spots = document["layers"][0]["strokes"].as_array_mut().unwrap();
    for spot in spots.iter_mut().filter(|spot| spot["center"][0].as_f64().unwrap() > 110.0) {
        spot["radii"] = json!([6.0, 6.0]);
    }
    let folder = Folder::with(&document);
    folder.grow("--report r.json --size 64x64 -q");
    let [small, large] = [0, 1].map(|index| region(&folder, "r.json", index));
    assert_eq!([&small["pin"], &large["pin"]], [0, 1]);
    let area = |region: &Value, key: &str| region[key]["area"].as_f64().unwrap();
    assert!(area(&large, "asked") > 1.5 * area(&small, "asked"));
    for region in [small, large] {
        assert!((area(&region, "got") / area(&region, "asked") - 1.0).abs() < 0.02, "{region}");
    }
}

#[test]
fn a_model_from_a_file_is_grown_on_and_parts_that_are_not_named_are_copied() {
    let mut document = on(&json!({"file": "two.obj", "px": 120, "only": ["skin"]}), 4.0, 1.0, 0.0, 26.0);
    document["layers"][0]["strokes"]
        .as_array_mut()
        .unwrap()
        .push(json!({"kind": "ellipse", "at": [0.5, 0.5, 1], "normal": [0, 0, 1], "radii": [4, 4]}));
    let folder = Folder::with(&document);
    folder.refuses("grow a.dapple -o a.png", 1, &["a.dapple: model.file: found", "two.obj", "--model FILE"]);
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\ng skin\nf 4 3 2 1\nf 5 6 7 8\n\
        f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\ng claw\nv 0 1.2 0\nv 1 1.2 0\nv 0.5 1.6 0\n\
        vt 0 0\nvt 1 0\nvt 0.5 0.25\nusemtl horn\nf 9/1 10/2 11/3\n";
    folder.write("two.obj", cube);
    folder.dapple("grow a.dapple -o a.glb --report r.json -q").assert().success();
    let (model, buffers, _) = gltf::import(folder.path("a.glb")).unwrap();
    let names: Vec<String> = model.meshes().filter_map(|mesh| mesh.name().map(str::to_owned)).collect();
    assert_eq!(names, ["grown", "claw"]);
    let claw = model.meshes().flat_map(|mesh| mesh.primitives()).nth(1).expect("a claw");
    assert_eq!(claw.material().name(), Some("horn"));
    let uvs = claw.reader(|buffer| Some(&buffers[buffer.index()])).read_tex_coords(0).expect("coordinates");
    // Measured from the upper left corner of that part.
    assert_eq!(uvs.into_f32().nth(2), Some([0.5, 0.75]));
    // The written model can be grown on again.
    document["model"]["only"] = json!(["grown"]);
    folder.write("b.dapple", &document.to_string());
    folder.dapple("grow b.dapple -o b.png --model a.glb --size 64x64 -q").assert().success();
    assert!(region(&folder, "r.json", 0)["mark"] == 0);
    document["model"]["only"] = json!(["fur"]);
    folder.write("a.dapple", &document.to_string());
    folder.refuses("grow a.dapple -o a.png", 1, &["a.dapple: model: two.obj", "'fur'", "'skin'"]);
}

#[test]
fn check_lists_what_will_grow_on_a_model_and_refuses_what_cannot() {
    let folder = Folder::with(&ball());
    let output = folder.dapple("check a.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("a.dapple: valid") && text.contains("sphere, 130 px along its longest side"),
        "{text}"
    );
    let mut document = ball();
    document["layers"][0]["system"] = json!("stucco");
    folder.write("a.dapple", &document.to_string());
    folder.refuses(
        "grow a.dapple -o a.png",
        1,
        &["layers[0].system: found \"stucco\" on a model", "turing-spots"],
    );
    document = ball();
    document["model"]["px"] = json!(60_000);
    folder.write("a.dapple", &document.to_string());
    folder.refuses("grow a.dapple -o a.png", 1, &["layer 1 "]);
}

#[test]
fn options_of_flat_pictures_are_refused_on_a_model_with_what_is_allowed() {
    let folder = Folder::with(&ball());
    for option in [
        "--pattern p.png",
        "--labels l.png",
        "--svg s.svg",
        "--concentrations c.exr",
        "--depth 16",
        "--displace 2",
    ] {
        let name = option.split(' ').next().unwrap();
        folder.refuses(&format!("grow a.dapple -o a.png {option}"), 2, &[name, "allowed: "]);
    }
    folder.refuses("grow a.dapple -o a.svg", 1, &["a.svg", ".ply"]);
    folder.refuses("grow a.dapple -o a.stl", 2, &["a.stl, which holds no colours", "--displace MM"]);
    folder.refuses("film a.dapple -o a.gif", 2, &["found a document on a model", "dapple grow a.dapple"]);
    let wrong = folder.dapple("grow a.dapple -o a.png --view 30").assert().code(2).get_output().clone();
    assert!(String::from_utf8(wrong.stderr).unwrap().contains("such as 30,15"));
}

#[test]
fn options_of_models_are_refused_for_flat_documents() {
    let mut document = ball();
    document.as_object_mut().unwrap().remove("model");
    let folder = Folder::with(&document);
    folder.refuses("grow a.dapple -o a.glb", 2, &["a.glb, which holds a model", "a.dapple has none"]);
    folder.refuses("grow a.dapple -o a.png --displace 1", 2, &["--displace", "\"model\""]);
    folder.refuses("film a.dapple --turn -o a.gif", 2, &["--turn", "grows on no model"]);
    folder.refuses("grow a.dapple -o a.png --view 30,10", 2, &["--view", "\"model\""]);
    folder.refuses("grow a.dapple -o a.png --model b.obj", 2, &["--model", "grows on no model"]);
}

#[test]
fn the_examples_on_models_are_formatted_as_the_program_writes_them_and_can_be_grown() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/bodies");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let document = dapple::document::Document::parse(&text, "example").unwrap();
        assert!(document.model.is_some() && text == document.to_json(), "{}", path.display());
        Folder::new().dapple(&format!("check {}", path.display())).assert().success();
        count += 1;
    }
    assert!(count > 0);
}
