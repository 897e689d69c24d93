//! Textures, textured models and reliefs of documents on models.

use std::collections::BTreeMap;

use serde_json::json;

use crate::grow::body::on;
use crate::grow::folder::Folder;

/// Round spots on a built-in body of this many px.
fn spots_on(body: &str, px: u32) -> Folder {
    Folder::with(&on(&json!({"file": body, "px": px}), 4.6, 1.0, 0.0, 28.0))
}

const MAPS: [&str; 9] =
    ["AmbientOcclusion", "BaseColor", "Height", "ID", "MaskMap", "NormalDX", "NormalGL", "ORM", "Roughness"];

#[test]
fn a_material_has_all_maps_on_the_coordinates_of_a_cube_on_any_number_of_threads() {
    let folder = spots_on("cube", 80);
    folder.dapple("grow a.dapple --material one --size 192x128 --threads 1 -q").assert().success();
    folder.dapple("grow a.dapple --material two --size 192x128 --threads 3 -q").assert().success();
    let files =
        MAPS.map(|map| format!("a_{map}.png")).into_iter().chain(["a.bin", "a.gltf"].map(String::from));
    for file in files {
        assert_eq!(folder.bytes(&format!("one/{file}")), folder.bytes(&format!("two/{file}")), "{file}");
    }
    let open = |map: &str| image::open(folder.path(&format!("one/a_{map}.png"))).unwrap();
    let (ids, heights, normals) =
        (open("ID").to_rgb8(), open("Height").to_luma16(), open("NormalGL").to_rgb8());
    assert_eq!(ids.dimensions(), (192, 128));
    let marks = ids.pixels().filter(|px| px.0 == [255, 0, 0]).count() as f64 / (192.0 * 128.0);
    // 66 px² of each 679.
    assert!((0.06..0.16).contains(&marks), "{marks}");
    // The texture of a cube lies in six squares of 64 texels: marks are higher than the ground in each of them, and its
    // normals look out of it.
    for square in 0..6 {
        let texels = (0..64 * 64).map(|at| [64 * (square % 3) + at % 64, 64 * (square / 3) + at / 64]);
        let mut sums: BTreeMap<bool, [f64; 2]> = BTreeMap::new();
        for [x, y] in texels {
            let sum = sums.entry(ids[(x, y)].0 == [255, 0, 0]).or_default();
            sum[0] += f64::from(heights[(x, y)].0[0]);
            sum[1] += 1.0;
            assert!(normals[(x, y)].0[2] > 140, "{x} {y}");
        }
        let mean = |is_mark: bool| sums.get(&is_mark).map(|[sum, count]| sum / count);
        if let (Some(mark), Some(ground)) = (mean(true), mean(false)) {
            assert!(mark > ground + 20_000.0, "{square}: {mark} {ground}");
        }
    }
    let (document, buffers, images) = gltf::import(folder.path("one/a.gltf")).unwrap();
    assert_eq!(images.len(), 3);
    let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
    assert_eq!(
        reader.read_tangents().unwrap().count(),
        reader.read_tex_coords(0).unwrap().into_f32().count()
    );
    assert!(primitive.material().normal_texture().is_some());
}

#[test]
fn a_glb_of_a_model_with_coordinates_has_its_texture_in_it() {
    let folder = spots_on("sphere", 90);
    folder.dapple("grow a.dapple -o a.glb --size 128 -q").assert().success();
    let (document, buffers, images) = gltf::import(folder.path("a.glb")).unwrap();
    assert_eq!(images.iter().map(|image| (image.width, image.height)).collect::<Vec<_>>(), [(128, 128); 3]);
    let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
    assert!(reader.read_colors(0).is_none() && reader.read_normals().is_some());
    // In the units of the model, a ball of radius 1.
    let radius = |[x, y, z]: [f32; 3]| (x * x + y * y + z * z).sqrt();
    assert!(reader.read_positions().unwrap().all(|at| (radius(at) - 1.0).abs() < 1e-3));
    // What was written can be grown on again, on its coordinates.
    folder.dapple("grow a.dapple --model a.glb -o b.glb --size 64 -q").assert().success();
    assert_eq!(gltf::import(folder.path("b.glb")).unwrap().2.len(), 3);
}

#[test]
fn a_model_without_coordinates_gets_automatic_ones_and_that_is_said() {
    let folder = spots_on("shell", 90);
    let output = folder.dapple("grow a.dapple -o a.obj --material m --size 128").assert().success();
    let text = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(text.contains("shell: it has no texture coordinates") && text.contains("automatic"), "{text}");
    let object = String::from_utf8(folder.bytes("a.obj")).unwrap();
    assert!(object.contains("mtllib a.mtl\n") && object.contains("usemtl grown\n"));
    let library = String::from_utf8(folder.bytes("a.mtl")).unwrap();
    for line in ["newmtl grown", "map_Kd a_BaseColor.png", "norm a_NormalGL.png", "map_Pr a_Roughness.png"] {
        assert!(library.contains(line), "{line}: {library}");
    }
    for picture in ["a_BaseColor.png", "a_NormalGL.png", "a_Roughness.png", "m/a_BaseColor.png"] {
        assert_eq!(image::open(folder.path(picture)).unwrap().width(), 128, "{picture}");
    }
    // It is a model with coordinates now.
    let output = folder.dapple("grow a.dapple --model a.obj --material n --size 64").assert().success();
    let text = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(!text.contains("automatic"), "{text}");
}

/// How often each edge of a binary STL is there, in its direction and against it: corners with the same bits are one.
fn edges(stl: &[u8]) -> BTreeMap<[[u32; 3]; 2], [usize; 2]> {
    let mut edges: BTreeMap<[[u32; 3]; 2], [usize; 2]> = BTreeMap::new();
    for face in stl[84..].chunks_exact(50) {
        let number = |at: usize| u32::from_le_bytes(face[4 * at..][..4].try_into().unwrap());
        let corners = [1, 2, 3].map(|corner| [0, 1, 2].map(|axis| number(3 * corner + axis)));
        for side in 0..3 {
            let (a, b) = (corners[side], corners[(side + 1) % 3]);
            edges.entry(if a < b { [a, b] } else { [b, a] }).or_default()[usize::from(a < b)] += 1;
        }
    }
    edges
}

#[test]
fn a_relief_for_a_printer_is_closed_and_as_high_as_asked_for() {
    let folder = spots_on("sphere", 130);
    let sides = |arguments: &str| -> f64 {
        let output = folder.dapple(&format!("grow a.dapple {arguments}")).assert().success();
        let text = String::from_utf8(output.get_output().stderr.clone()).unwrap();
        let line = text.lines().find(|line| line.contains(" mm")).unwrap_or_else(|| panic!("{text}"));
        line.split([' ', '×']).filter_map(|word| word.parse::<f64>().ok()).next().unwrap()
    };
    let [low, high] = [0.1, 1.1].map(|height| sides(&format!("-o a.stl --displace {height}")));
    // 130 px at 300 dpi are 11 mm; a mark on either side.
    assert!((low - 11.2).abs() < 0.2 && (high - low - 2.0).abs() < 0.3, "{low} {high}");
    let edges = edges(&folder.bytes("a.stl"));
    assert!(edges.len() > 10_000 && edges.values().all(|count| *count == [1, 1]));
    let hollow = sides("-o a.ply --displace -1");
    assert!((hollow - 11.0).abs() < 0.2, "{hollow}");
    assert!(folder.bytes("a.ply").starts_with(b"ply\n"));
}

#[test]
fn a_model_turns_once_in_a_film() {
    let folder = spots_on("cube", 80);
    folder.dapple("film a.dapple --turn -o film --side 48 --seconds 1 --fps 4 -q").assert().success();
    let frame =
        |index: usize| image::open(folder.path(&format!("film/frame-000{index}.png"))).unwrap().to_rgb8();
    assert_eq!(frame(1).dimensions(), (48, 48));
    assert!(!folder.path("film/frame-0005.png").exists());
    // A quarter turn shows the same cube with other spots.
    assert!(frame(1) != frame(2) && frame(2) != frame(3));
    let ground = |index: usize| frame(index).pixels().filter(|px| px.0 == frame(1)[(0, 0)].0).count() as i64;
    assert!((ground(1) - ground(3)).abs() < 40, "{} {}", ground(1), ground(3));
    folder.dapple("film a.dapple --turn -o a.gif --side 32 --seconds 1 --fps 4 -q").assert().success();
    assert!(folder.bytes("a.gif").starts_with(b"GIF89a"));
}
