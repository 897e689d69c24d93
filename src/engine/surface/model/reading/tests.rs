use super::*;
use proptest::prelude::*;
use serde_json::json;

const OBJ: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\no a\nusemtl b\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf -1//-1 -2//-1 -3//-1\n";
const STL: &[u8] = b"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
const PLY: &[u8] = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
    property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// The places of a triangle's corners, as bytes.
fn places() -> Vec<u8> {
    let numbers: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// A triangle of binary formats.
fn binary() -> [Vec<u8>; 2] {
    let places = places();
    let mut stl = vec![b' '; 80];
    stl.extend([1, 0, 0, 0]);
    stl.extend([0; 12]);
    stl.extend(&places);
    stl.extend([0; 2]);
    let text = String::from_utf8_lossy(PLY);
    let header = text.split_inclusive("end_header\n").next().unwrap_or_default();
    let mut ply = header.replace("ascii", "binary_little_endian").into_bytes();
    ply.extend(&places);
    ply.extend([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    [stl, ply]
}

/// A triangle in a GLB file.
fn glb() -> Vec<u8> {
    let json = json!({
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}]
    });
    gltf::tests::glb(&json, places())
}

/// A triangle or two of each format.
fn seeds() -> Vec<Vec<u8>> {
    let [stl, ply] = binary();
    vec![OBJ.to_vec(), STL.to_vec(), PLY.to_vec(), stl, ply, glb()]
}

/// Whether all indices of a model are in range.
pub fn is_whole(model: &Model) -> bool {
    model.faces.iter().all(|face| {
        (face.part as usize) < model.parts.len()
            && face.corners.iter().all(|corner| {
                (corner.position as usize) < model.positions.len()
                    && corner.uv.is_none_or(|uv| (uv as usize) < model.uvs.len())
                    && corner.normal.is_none_or(|normal| (normal as usize) < model.normals.len())
            })
    })
}

#[test]
fn the_first_bytes_tell_the_format() {
    for (at, bytes) in seeds().iter().enumerate() {
        let model = read_model(bytes, "x").expect("a model");
        assert!(is_whole(&model) && !model.faces.is_empty(), "{at}");
    }
    for bytes in [&b"PK\x03\x04"[..], b"", b"<x3d>", b"Kaydara FBX Binary"] {
        let error = read_model(bytes, "x").unwrap_err().to_string();
        assert!(error.starts_with("x: found ") && error.contains("allowed: an OBJ, PLY, STL"), "{error}");
    }
}

proptest! {
    #[test]
    fn any_bytes_give_a_whole_model_or_an_error(
        seed in 0_usize..7,
        bytes in prop::collection::vec(any::<u8>(), 0..300),
    ) {
        let mut all = seeds().get(seed).map_or_else(Vec::new, |seed| seed[..seed.len() / 2].to_vec());
        all.extend(bytes);
        prop_assert!(read_model(&all, "x").map_or(true, |model| is_whole(&model)));
    }

    #[test]
    fn a_file_with_changed_bytes_gives_a_whole_model_or_an_error(
        seed in 0_usize..6,
        changes in prop::collection::vec((0_usize..2_000, any::<u8>()), 1..6),
    ) {
        let mut bytes = seeds().swap_remove(seed);
        for (at, byte) in changes {
            let count = bytes.len();
            bytes[at % count] = byte;
        }
        match read_model(&bytes, "x") {
            Ok(model) => prop_assert!(is_whole(&model)),
            Err(error) => prop_assert!(!error.to_string().contains(char::is_control), "{}", error),
        }
    }
}
