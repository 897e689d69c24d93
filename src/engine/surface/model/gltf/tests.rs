use serde_json::{Value, json};

use super::*;

/// A triangle in a buffer: three positions, then three texture coordinates, then indices of two bytes.
fn buffer() -> Vec<u8> {
    let numbers: [f32; 15] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    let mut bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    bytes.extend([0u16, 1, 2].iter().flat_map(|index| index.to_le_bytes()));
    bytes
}

fn document() -> Value {
    let data = format!("data:application/octet-stream;base64,{}", base64::encode(buffer()));
    let accessor = |view: usize, kind: u32, count: u32, dimensions: &str| {
        json!({"bufferView": view, "componentType": kind, "count": count, "type": dimensions,
            "min": [0, 0, 0], "max": [1, 1, 0]})
    };
    json!({
        "asset": {"version": "2.0"},
        "buffers": [{"uri": data, "byteLength": 66}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
            {"buffer": 0, "byteOffset": 60, "byteLength": 6}],
        "accessors": [accessor(0, 5126, 3, "VEC3"), accessor(1, 5126, 3, "VEC2"), accessor(2, 5123, 3, "SCALAR")],
        "materials": [{"name": "fur"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "nodes": [{"name": "cat", "mesh": 0, "translation": [10, 0, 0], "children": [1]},
            {"name": "tail", "mesh": 0, "scale": [-2, 2, 2]}],
        "scenes": [{"nodes": [0]}], "scene": 0
    })
}

fn read(document: &Value) -> Result<Model, ModelError> {
    read_gltf(document.to_string().as_bytes(), "a.gltf")
}

#[test]
fn nodes_put_meshes_where_they_are_and_are_objects() {
    let model = read(&document()).unwrap();
    let objects: Vec<_> = model.parts.iter().map(|part| part.object.as_deref().unwrap()).collect();
    assert_eq!((objects, model.faces.len()), (vec!["cat", "tail"], 2));
    assert_eq!(model.parts[0].material.as_deref(), Some("fur"));
    assert_eq!(model.positions[..3], [[10.0, 0.0, 0.0], [11.0, 0.0, 0.0], [10.0, 1.0, 0.0]]);
    assert_eq!(model.positions[3..], [[10.0, 0.0, 0.0], [8.0, 0.0, 0.0], [10.0, 2.0, 0.0]]);
    // The corners of a mirrored triangle are reversed, so that it faces the same side.
    assert_eq!(model.faces[1].corners.map(|corner| corner.position), [3, 5, 4]);
    assert_eq!(model.uvs[..3], [[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]]);
    assert!(model.notes.is_empty());
}

/// A GLB file of a JSON and the bytes of its only buffer.
pub fn glb(json: &Value, mut buffer: Vec<u8>) -> Vec<u8> {
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    buffer.resize(buffer.len().next_multiple_of(4), 0);
    let mut bytes = b"glTF".to_vec();
    let whole = 12 + 8 + json.len() + 8 + buffer.len();
    bytes.extend([2, whole as u32, json.len() as u32].iter().flat_map(|number| number.to_le_bytes()));
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend((buffer.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(buffer);
    bytes
}

#[test]
fn a_binary_file_holds_the_same() {
    let mut json = document();
    json["buffers"][0].as_object_mut().unwrap().remove("uri");
    let bytes = glb(&json, buffer());
    assert_eq!(read_gltf(&bytes, "a.gltf").unwrap(), read(&document()).unwrap());
    for length in [12, 20, 200, bytes.len() - 1] {
        assert!(read_gltf(&bytes[..length], "a.glb").is_err(), "{length}");
    }
}

#[test]
fn strips_and_fans_are_triangles_and_lines_are_noted() {
    assert_eq!(triangles(Mode::TriangleStrip, &[0, 1, 2, 3]), [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(triangles(Mode::TriangleFan, &[0, 1, 2, 3]), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(triangles(Mode::Triangles, &[0, 1, 2, 3]), [[0, 1, 2]]);
    let mut lines = document();
    lines["meshes"][0]["primitives"]
        .as_array_mut()
        .unwrap()
        .push(json!({"attributes": {"POSITION": 0}, "mode": 1}));
    let model = read(&lines).unwrap();
    assert_eq!((model.faces.len(), model.notes.len()), (2, 1), "{:?}", model.notes);
}

#[test]
fn wrong_files_are_refused_in_one_line() {
    let changed = |change: &dyn Fn(&mut Value)| {
        let mut document = document();
        change(&mut document);
        let error = read(&document).unwrap_err().to_string();
        assert!(error.starts_with("a.gltf: found ") && !error.contains('\n') && error.len() < 400, "{error}");
        error
    };
    let far = changed(&|document| document["buffers"][0]["uri"] = json!("cat.bin"));
    assert!(
        far.contains("a buffer in another file")
            && far.ends_with("export the model as GLB, which is one file"),
        "{far}"
    );
    let many = changed(&|document| document["accessors"][0]["count"] = json!(4));
    assert!(many.contains("4 numbers that the buffers do not have"), "{many}");
    changed(&|document| document["accessors"][0]["count"] = json!(4_000_000_000u64));
    changed(&|document| document["accessors"][0]["byteOffset"] = json!(u64::MAX));
    changed(&|document| document["bufferViews"][0]["byteOffset"] = json!(u64::MAX));
    changed(&|document| document["bufferViews"][0]["byteLength"] = json!(u64::MAX - 35));
    changed(&|document| document["bufferViews"][0]["byteStride"] = json!(4));
    changed(&|document| document["accessors"][0]["componentType"] = json!(5123));
    changed(&|document| document["accessors"][2]["componentType"] = json!(5126));
    changed(&|document| document["meshes"][0]["primitives"][0]["indices"] = json!(9));
    changed(&|document| document["meshes"][0]["primitives"][0]["mode"] = json!(0));
    changed(&|document| document["nodes"][1]["children"] = json!([0]));
    let packed = changed(&|document| document["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]));
    assert!(packed.contains("without compression"), "{packed}");
    let twice = changed(&|document| document["scenes"][0]["nodes"] = json!([0, 1]));
    assert!(twice.contains("node 1 in two places"), "{twice}");
    let few = |number: Value| {
        let few = changed(&|document| {
            document["accessors"][0]["sparse"] = json!({"count": 1, "indices": {"bufferView": 2, "componentType": 5123,
                "byteOffset": number}, "values": {"bufferView": 0}});
        });
        assert!(few.contains("3 numbers that the buffers do not have"), "{few}");
    };
    few(json!(7));
    few(json!(u64::MAX));
    let index = changed(&|document| {
        let mut bytes = buffer();
        bytes[64] = 3;
        document["buffers"][0]["uri"] = json!(format!("data:;base64,{}", base64::encode(bytes)));
    });
    assert!(index.contains("the vertex 3 of 3"), "{index}");
}
