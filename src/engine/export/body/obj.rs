//! Models as Wavefront OBJ, with a material library (MTL) that names pictures.

use std::io::Write;

use super::paint::Coloured;
use super::skin::{Skin, SkinPicture};
use super::vector::unit;
use crate::export::Stopped;

/// Writes an `.obj` with an object for each part, whose materials are in the file `library` beside it. Colours by vertex are left out: the
/// format has none.
///
/// # Errors
/// The bytes cannot be written.
pub fn obj(mut out: impl Write, parts: &[Coloured], library: &str) -> Result<(), Stopped> {
    let mut text = format!("# dapple {}\nmtllib {library}\n", env!("CARGO_PKG_VERSION"));
    // Counted from 1.
    let [mut first, mut first_uv, mut first_normal] = [1; 3];
    for part in parts.iter().filter(|part| !part.mesh.faces.is_empty()) {
        text += &format!("o {}\n", one_line(part.name));
        for place in &part.mesh.positions {
            line(&mut text, "v", place);
        }
        part.uvs.iter().for_each(|uv| line(&mut text, "vt", uv));
        part.normals.iter().for_each(|normal| line(&mut text, "vn", &unit(*normal)));
        if !part.material.is_empty() {
            text += &format!("usemtl {}\n", one_line(part.material));
        }
        for face in &part.mesh.faces {
            text.push('f');
            for vertex in face.map(|vertex| vertex as usize) {
                let own = |is_there: bool, first: usize| match is_there {
                    true => (first + vertex).to_string(),
                    false => String::new(),
                };
                let (uv, normal) =
                    (own(!part.uvs.is_empty(), first_uv), own(!part.normals.is_empty(), first_normal));
                let corner = format!(" {}/{uv}/{normal}", first + vertex);
                text += corner.trim_end_matches('/');
            }
            text.push('\n');
        }
        first += part.mesh.positions.len();
        first_uv += part.uvs.len();
        first_normal += part.normals.len();
        out.write_all(text.as_bytes())?;
        text.clear();
    }
    Ok(out.write_all(text.as_bytes())?)
}

/// Writes the `.mtl` of these parts. The material that the `skin` names has its pictures, which must lie beside; `roughness` is the name
/// of the file of its roughness. All others are a rough white.
///
/// # Errors
/// The bytes cannot be written.
pub fn mtl(mut out: impl Write, parts: &[Coloured], skin: &Skin, roughness: &str) -> Result<(), Stopped> {
    let mut names: Vec<&str> = Vec::new();
    for part in parts.iter().filter(|part| !part.mesh.faces.is_empty() && !part.material.is_empty()) {
        if !names.contains(&part.material) {
            names.push(part.material);
        }
    }
    let mut text = format!("# dapple {}\n", env!("CARGO_PKG_VERSION"));
    for name in names {
        text += &format!("newmtl {}\nKd 0.8 0.8 0.8\nKs 0.04 0.04 0.04\nillum 2\n", one_line(name));
        if name == skin.material {
            let file = |picture| match picture {
                SkinPicture::Beside(name) => name,
                SkinPicture::Inside(_) => "",
            };
            let (colours, normals) = (file(skin.base_colour), file(skin.normal));
            // `norm` and `map_Pr` are those of the PBR extension of the format. Blender 5.0 reads `map_Pr`, but normals only as `map_Bump`,
            // of the strength `-bm`, which is 0 by default; readers that take `map_Bump` for heights prefer `norm`.
            text +=
                &format!("map_Kd {colours}\nmap_Bump -bm 1 {normals}\nnorm {normals}\nmap_Pr {roughness}\n");
            if skin.transparent {
                text += &format!("map_d {colours}\n");
            }
        }
    }
    Ok(out.write_all(text.as_bytes())?)
}

fn line<const N: usize>(text: &mut String, kind: &str, values: &[f64; N]) {
    text.push_str(kind);
    for value in values {
        let value = *value as f32;
        *text += &format!(" {}", if value.is_finite() { value } else { 0.0 });
    }
    text.push('\n');
}

/// A name, which ends with its line.
fn one_line(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Mesh, read_model};

    #[test]
    fn our_reader_finds_the_parts_and_the_pictures_again() {
        let positions = vec![[0.1, 0.0, -3.5], [1.0, 0.0, 0.0], [0.0, 1e-7, 2e6]];
        let mesh = Mesh { positions, faces: vec![[0, 1, 2]] };
        let plain = Coloured {
            name: "left eye",
            material: "",
            mesh: &mesh,
            normals: &[],
            uvs: &[],
            tangents: &[],
            colours: &[],
        };
        let rich = Coloured {
            name: "skin",
            material: "grown",
            uvs: &[[0.0, 0.25], [1.0, 0.0], [0.5, 1.0]],
            normals: &[[0.0, 0.0, 1.0]; 3],
            ..plain
        };
        let mut bytes = Vec::new();
        obj(&mut bytes, &[plain, rich, Coloured { normals: &[], ..rich }], "a.mtl").unwrap();
        let read = read_model(&bytes, "a.obj").unwrap();
        assert_eq!(read.positions[..3].len() * 3, read.positions.len());
        assert!((read.positions[8][2] - 2e6).abs() < 1.0 && (read.positions[8][1] - 1e-7).abs() < 1e-12);
        assert_eq!(read.uvs[..3], [[0.0, 0.25], [1.0, 0.0], [0.5, 1.0]]);
        assert_eq!(
            read.faces[1].corners.map(|corner| (corner.uv, corner.normal)),
            [(Some(0), Some(0)), (Some(1), Some(1)), (Some(2), Some(2))]
        );
        assert_eq!(read.faces[2].corners[1].uv, Some(4));
        assert_eq!(read.parts[0].object.as_deref(), Some("left_eye"));
        let skin = Skin {
            material: "grown",
            base_colour: SkinPicture::Beside("c.png"),
            normal: SkinPicture::Beside("n.png"),
            orm: SkinPicture::Beside("o.png"),
            anisotropy: None,
            transparent: false,
        };
        let mut bytes = Vec::new();
        mtl(&mut bytes, &[plain, rich], &skin, "r.png").unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(text.matches("newmtl").count(), 1);
        assert!(text.contains("map_Kd c.png\nmap_Bump -bm 1 n.png\nnorm n.png\nmap_Pr r.png\n"), "{text}");
    }
}
