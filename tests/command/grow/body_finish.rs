//! Documents on models with a finish: textures and pictures have it, what is measured does not.

use serde_json::{Value, json};

use crate::grow::body::on;
use crate::grow::folder::Folder;

/// Spots on a small built-in body with a finish.
fn finished(body: &str, finish: &Value) -> Value {
    let mut document = on(&json!({"file": body, "px": 90}), 4.6, 1.0, 0.0, 28.0);
    if !finish.is_null() {
        document["finish"] = finish.clone();
    }
    document
}

fn rgb(folder: &Folder, name: &str) -> image::RgbImage {
    image::open(folder.path(name)).unwrap().to_rgb8()
}

/// The mean difference of two pictures.
fn apart(one: &image::RgbImage, other: &image::RgbImage) -> f64 {
    let sum: f64 = one.iter().zip(other.iter()).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / one.len() as f64
}

#[test]
fn a_finish_changes_colours_height_normals_and_roughness_and_not_the_ids_and_the_report() {
    let plain = Folder::with(&finished("sphere", &Value::Null));
    plain.grow("--material m --report r.json --size 128 -q");
    for kind in ["fur", "fish-scales", "reptile-scales", "skin", "leather", "ink"] {
        let folder = Folder::with(&finished("sphere", &json!({"kind": kind})));
        folder.grow("--material m --report r.json --size 128 -q");
        for map in ["BaseColor", "Height", "NormalGL", "NormalDX", "Roughness", "ORM"] {
            let name = format!("m/a_{map}.png");
            assert!(plain.bytes(&name) != folder.bytes(&name), "{kind}: {map}");
        }
        assert!(plain.bytes("m/a_ID.png") == folder.bytes("m/a_ID.png"), "{kind}");
        assert!(plain.bytes("m/a.bin") == folder.bytes("m/a.bin"), "{kind}");
        let change = apart(&rgb(&plain, "a.png"), &rgb(&folder, "a.png"));
        assert!(change > 0.5, "{kind}: the picture changes by {change}");
        let reports = [&plain, &folder].map(|folder| {
            let mut report = folder.json("r.json");
            report.as_object_mut().unwrap().remove("seconds");
            report
        });
        assert_eq!(reports[0], reports[1], "{kind}");
    }
}

#[test]
fn a_finish_on_a_model_has_the_same_bytes_with_any_number_of_threads() {
    for kind in ["fur", "skin"] {
        let folder = Folder::with(&finished("cube", &json!({"kind": kind})));
        folder.grow("--material one --size 192x128 --threads 1 -q");
        let picture = folder.bytes("a.png");
        folder.grow("--material two --size 192x128 --threads 3 -q");
        assert!(picture == folder.bytes("a.png"), "{kind}");
        for map in ["BaseColor", "Height", "NormalGL", "Roughness"] {
            let [one, two] = ["one", "two"].map(|set| folder.bytes(&format!("{set}/a_{map}.png")));
            assert!(one == two, "{kind}: {map}");
        }
    }
}

#[test]
fn both_sides_of_a_seam_show_the_same_hairs() {
    // The texture of a sphere ends at a meridian, the first and the last column.
    let folder = Folder::with(&finished("sphere", &json!({"kind": "fur"})));
    folder.grow("--material m --size 1024x512 -q");
    let picture = rgb(&folder, "m/a_BaseColor.png");
    let [width, height] = [picture.width(), picture.height()];
    // Near the poles a texel is small.
    let rows = height / 4..3 * height / 4;
    let difference = |[a, b]: [u32; 2]| {
        let of_row = |y: u32| {
            let pair = picture[(a, y)].0.iter().zip(picture[(b, y)].0);
            pair.map(|(a, b)| f64::from(a.abs_diff(b))).sum::<f64>()
        };
        rows.clone().map(of_row).sum::<f64>() / f64::from(3 * rows.len() as u32)
    };
    let (across, inside, strangers) = (
        difference([width - 1, 0]),
        difference([width / 2 - 1, width / 2]),
        difference([width / 4, 3 * width / 4]),
    );
    println!("{across:.2} across the seam, {inside:.2} inside, {strangers:.2} between two places");
    assert!(across < 1.5 * inside && across < 0.6 * strangers, "{across} {inside} {strangers}");
}

#[test]
fn hair_on_a_model_has_reflections_with_a_direction_and_skin_has_none() {
    let folder = Folder::with(&finished("sphere", &json!({"kind": "fur", "flow": 180})));
    folder.grow("--material m --size 64 -q");
    folder.dapple("grow a.dapple -o a.glb --size 64 -q").assert().success();
    let text = String::from_utf8(folder.bytes("m/a.gltf")).unwrap();
    assert!(text.contains("KHR_materials_anisotropy") && text.contains("a_Anisotropy.png"), "{text}");
    assert_eq!(gltf::import(folder.path("a.glb")).unwrap().2.len(), 4);
    for px in rgb(&folder, "m/a_Anisotropy.png").pixels() {
        let [x, y] = [px[0], px[1]].map(|part| f64::from(part) / 127.5 - 1.0);
        assert!((x * x + y * y - 1.0).abs() < 0.03 && px[2] > 100, "{px:?}");
    }
    let folder = Folder::with(&finished("sphere", &json!({"kind": "skin"})));
    folder.grow("--material m --size 64 -q");
    assert!(!folder.path("m/a_Anisotropy.png").exists());
}

#[test]
fn a_glb_of_a_model_without_coordinates_has_its_finish_on_automatic_ones() {
    let folder = Folder::with(&finished("shell", &json!({"kind": "leather"})));
    let output = folder.dapple("grow a.dapple -o a.glb --size 128").assert().success();
    let said = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(said.contains("automatic"), "{said}");
    assert_eq!(gltf::import(folder.path("a.glb")).unwrap().2.len(), 3);
    let output = folder.dapple("grow a.dapple -o a.ply").assert().success();
    let said = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(said.contains("without the finish leather"), "{said}");
}

#[test]
fn finishes_that_are_lattices_and_strokes_of_hair_are_refused_on_a_model_with_the_reason() {
    for kind in ["cloth", "twill", "print"] {
        let folder = Folder::with(&finished("sphere", &json!({"kind": kind})));
        let words = ["finish.kind: found", kind, "no closed surface has without a seam", "fur, fish-scales"];
        folder.refuses("grow a.dapple -o a.png", 1, &words);
    }
    let mut combed = finished("sphere", &json!({"kind": "fur"}));
    let hair = json!({"system": "hair", "strokes": [{"kind": "line", "from": [40, 10], "to": [40, 80]}]});
    combed["layers"].as_array_mut().unwrap().push(hair);
    let folder = Folder::with(&combed);
    folder.refuses("grow a.dapple -o a.png", 1, &["layers[1]", "no place on the model", "\"flow\""]);
}

#[test]
fn a_film_of_a_model_that_turns_has_the_finish() {
    let [plain, furry] = [Value::Null, json!({"kind": "fur"})].map(|finish| {
        let folder = Folder::with(&finished("sphere", &finish));
        folder.dapple("film a.dapple --turn -o film --side 96 --seconds 1 --fps 2 -q").assert().success();
        folder.dapple("film a.dapple --turn -o a.gif --side 48 --seconds 1 --fps 2 -q").assert().success();
        folder
    });
    for frame in ["film/frame-0001.png", "film/frame-0002.png"] {
        let change = apart(&rgb(&plain, frame), &rgb(&furry, frame));
        assert!(change > 0.5, "{frame}: {change}");
    }
    assert!(furry.bytes("a.gif").starts_with(b"GIF89a") && furry.bytes("a.gif") != plain.bytes("a.gif"));
}
