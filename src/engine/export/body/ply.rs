//! Models with colours by vertex, as PLY (Turk 1994), binary, little-endian.

use std::io::Write;

use super::paint::Coloured;
use super::vector::unit;
use crate::export::{Stopped, srgb_from_linear};
use crate::surface::Mesh;

/// Writes a `.ply`. The parts become one mesh, because the format has no parts. Properties that only some of the parts have are
/// filled: normals with 0, texture coordinates with 0, colours with white. Colours are 8-bit sRGB, which other programs expect.
///
/// # Errors
/// The bytes cannot be written.
pub fn ply(mut out: impl Write, parts: &[Coloured]) -> Result<(), Stopped> {
    let count = |of: fn(&Mesh) -> usize| parts.iter().map(|part| of(part.mesh)).sum::<usize>();
    let has_normals = parts.iter().any(|part| !part.normals.is_empty());
    let has_uvs = parts.iter().any(|part| !part.uvs.is_empty());
    let has_colours = parts.iter().any(|part| !part.colours.is_empty());
    let mut head = format!(
        "ply\nformat binary_little_endian 1.0\ncomment dapple {}\nelement vertex {}\n",
        env!("CARGO_PKG_VERSION"),
        count(|mesh| mesh.positions.len())
    );
    for (is_there, kind, names) in [
        (true, "float", &["x", "y", "z"][..]),
        (has_normals, "float", &["nx", "ny", "nz"]),
        (has_uvs, "float", &["s", "t"]),
        (has_colours, "uchar", &["red", "green", "blue"]),
    ] {
        let properties = names.iter().filter(|_| is_there).map(|name| format!("property {kind} {name}\n"));
        head.extend(properties);
    }
    head += &format!(
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        count(|mesh| mesh.faces.len())
    );
    let mut bytes = head.into_bytes();
    for part in parts {
        for vertex in 0..part.mesh.positions.len() {
            push(&mut bytes, part.mesh.positions[vertex]);
            if has_normals {
                push(&mut bytes, part.normals.get(vertex).map_or([0.0; 3], |normal| unit(*normal)));
            }
            if has_uvs {
                push(&mut bytes, part.uvs.get(vertex).copied().unwrap_or_default());
            }
            if has_colours {
                let colour = part.colours.get(vertex).copied().unwrap_or([1.0; 3]);
                bytes.extend(colour.map(|light| (255.0 * srgb_from_linear(f64::from(light))).round() as u8));
            }
        }
    }
    let mut start = 0;
    for part in parts {
        for face in &part.mesh.faces {
            bytes.push(3);
            bytes.extend(face.iter().flat_map(|vertex| (start + vertex).to_le_bytes()));
        }
        start += part.mesh.positions.len() as u32;
    }
    Ok(out.write_all(&bytes)?)
}

fn push<const N: usize>(bytes: &mut Vec<u8>, values: [f64; N]) {
    bytes.extend(values.iter().flat_map(|value| (*value as f32).to_le_bytes()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_head_lists_the_properties_and_parts_become_one_mesh() {
        let mesh = Mesh {
            positions: vec![[0.0, 1.0, 2.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
            faces: vec![[0, 1, 2]],
        };
        let normals = [[0.0, 0.0, 3.0]; 3];
        let colours = [[1.0, 0.0, 0.5], [0.0; 3], [0.0; 3]];
        let first = Coloured {
            name: "a",
            material: "",
            mesh: &mesh,
            normals: &[],
            uvs: &[],
            tangents: &[],
            colours: &colours,
        };
        let second = Coloured { normals: &normals, colours: &[], ..first };
        let mut bytes = Vec::new();
        ply(&mut bytes, &[first, second]).unwrap();
        let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
        let head = std::str::from_utf8(&bytes[..end]).unwrap();
        for line in ["element vertex 6", "element face 2", "property uchar blue", "property float nz"] {
            assert!(head.lines().any(|found| found == line), "{head}");
        }
        assert!(!head.contains("property float s"));
        let body = &bytes[end..];
        assert_eq!(body.len(), 6 * (12 + 12 + 3) + 2 * 13);
        let float = |at: usize| f32::from_le_bytes(body[at..at + 4].try_into().unwrap());
        assert_eq!([float(0), float(4), float(8), float(20)], [0.0, 1.0, 2.0, 0.0]);
        // Half the light is 188 in sRGB.
        assert_eq!(body[24..27], [255, 0, 188]);
        assert_eq!((float(3 * 27 + 20), &body[3 * 27 + 24..4 * 27]), (1.0, &[255; 3][..]));
        let faces = &body[6 * 27..];
        assert_eq!((faces[0], faces[13], faces[14], faces[18]), (3, 3, 3, 4));
    }
}
