//! The PLY format (Stanford, G. Turk 1994), as text or binary: vertices, polygons and triangle strips.
//!
//! It reads the positions, normals and texture coordinates of vertices, and the texture coordinates of the corners of faces
//! (`texcoord`). Other data of a file, such as colours, are skipped.

mod element;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{Encoding, Header};

use super::error::{ModelError, quoted, said};
use super::polygon::{MOST_CORNERS, triangulate};
use super::{Corner, Face, Model, Part};
use element::Element;

/// The remedy for a wrong file.
const REMEDY: &str = "export the model again; the file may be cut off";

/// Reads a model from the bytes of a PLY file; `name` is the file's, for messages.
///
/// # Errors
/// A file that does not follow the format, an index of nothing, a model without faces.
pub fn read_ply(bytes: &[u8], name: &str) -> Result<Model, ModelError> {
    let broken = |found: String, allowed: &str| ModelError::Broken {
        file: name.to_owned(),
        found,
        allowed: allowed.to_owned(),
        remedy: REMEDY,
    };
    // The first line of the library's message has the place; the others quote the file.
    let unread = |error: std::io::Error| {
        let why = said(error.to_string().lines().next().unwrap_or_default());
        broken(format!("what is no PLY ({why})"), "a header and the elements that it names")
    };
    let parser = Parser::<Element>::new();
    let (mut left, mut reader) =
        (bytes, Reader { model: Model { name: name.to_owned(), ..Model::default() }, ..Reader::default() });
    let header = parser.read_header(&mut left).map_err(unread)?;
    check(&header, left.len()).map_err(|found| broken(found, "as many as the file has bytes for"))?;
    for (element, definition) in &header.elements {
        let elements = parser.read_payload_for_element(&mut left, definition, &header).map_err(unread)?;
        match element.as_str() {
            "vertex" => reader.vertices = elements,
            "face" => reader.faces = elements,
            "tristrips" => reader.strips = elements,
            _ => {}
        }
    }
    let allowed = format!("indices of vertices, and 3 to {MOST_CORNERS} corners a face");
    reader.read().map_err(|found| broken(found, &allowed))?;
    if reader.model.faces.is_empty() {
        let found = format!("no faces, but {} vertices", reader.vertices.len());
        return Err(ModelError::NoFaces { file: name.to_owned(), found });
    }
    Ok(reader.model)
}

/// Refuses elements that cannot fit into the remaining bytes.
fn check(header: &Header, bytes: usize) -> Result<(), String> {
    let least = |definition: &ply_rs_bw::ply::ElementDef| match header.encoding {
        Encoding::Ascii => 1,
        _ => definition.properties.len().max(1),
    };
    let of_all = header.elements.values();
    match of_all.into_iter().find(|definition| definition.count.saturating_mul(least(definition)) > bytes) {
        Some(definition) => {
            Err(format!("{} elements {} in {bytes} bytes", definition.count, quoted(&definition.name)))
        }
        None => Ok(()),
    }
}

#[derive(Default)]
struct Reader {
    model: Model,
    vertices: Vec<Element>,
    faces: Vec<Element>,
    strips: Vec<Element>,
}

impl Reader {
    /// Reads the model.
    ///
    /// # Errors
    /// The problem.
    fn read(&mut self) -> Result<(), String> {
        let [has_normals, has_uvs] = {
            let first = self.vertices.first();
            [first.is_some_and(|first| first.normal.is_some()), first.is_some_and(|first| first.uv.is_some())]
        };
        self.model.parts.push(Part::default());
        for vertex in &self.vertices {
            let place = vertex.position.map(|value| value.unwrap_or(f64::NAN));
            self.model.positions.push(place);
            if has_normals {
                self.model.normals.push(vertex.normal.unwrap_or_default());
            }
            if has_uvs {
                self.model.uvs.push(vertex.uv.unwrap_or_default());
            }
        }
        let corner = |index: i64| {
            let position = u32::try_from(index).ok().filter(|index| (*index as usize) < self.vertices.len());
            let position =
                position.ok_or_else(|| format!("the vertex {index} of {}", self.vertices.len()))?;
            Ok(Corner { position, uv: has_uvs.then_some(position), normal: has_normals.then_some(position) })
        };
        for (at, face) in self.faces.iter().enumerate() {
            let mut corners =
                face.indices.iter().map(|index| corner(*index)).collect::<Result<Vec<_>, String>>()?;
            if corners.len() > MOST_CORNERS {
                return Err(format!("face {} of {} corners", at + 1, corners.len()));
            }
            if face.uvs.len() == 2 * corners.len() {
                for (corner, uv) in corners.iter_mut().zip(face.uvs.chunks_exact(2)) {
                    corner.uv = Some(self.model.uvs.len() as u32);
                    self.model.uvs.push([uv[0], uv[1]]);
                }
            }
            let places: Vec<[f64; 3]> =
                corners.iter().map(|corner| self.model.positions[corner.position as usize]).collect();
            // Fewer corners form a line or a point.
            if corners.len() >= 3 {
                let triangles = triangulate(&places).into_iter();
                let faces =
                    triangles.map(|triangle| Face { corners: triangle.map(|at| corners[at]), part: 0 });
                self.model.faces.extend(faces);
            }
        }
        for strip in &self.strips {
            for piece in strip.indices.split(|index| *index < 0) {
                for (at, &[a, b, c]) in piece.array_windows().enumerate() {
                    // Every second triangle has the opposite orientation.
                    let [a, b] = if at % 2 == 0 { [a, b] } else { [b, a] };
                    let corners = [corner(a)?, corner(b)?, corner(c)?];
                    self.model.faces.push(Face { corners, part: 0 });
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\n\
        property double z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const VERTICES: &str = "0 0 0 9\n1 0 0 9\n1 1 0.5 9\n0 1 0 9\n";

    fn error(text: &str) -> String {
        read_ply(text.as_bytes(), "a.ply").unwrap_err().to_string()
    }

    #[test]
    fn polygons_are_cut_into_triangles() {
        let text = format!("{HEADER}{VERTICES}4 0 1 2 3\n3 0 1 2\n");
        let model = read_ply(text.as_bytes(), "a.ply").unwrap();
        assert_eq!((model.positions.len(), model.faces.len()), (4, 3));
        assert_eq!(model.positions[2], [1.0, 1.0, 0.5]);
        let dos = read_ply(text.replace('\n', "\r\n").as_bytes(), "a.ply").unwrap();
        assert_eq!(dos.faces, model.faces);
    }

    #[test]
    fn binary_files_of_both_orders_hold_the_same() {
        let header = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
            property float ny\nproperty float nz\nproperty float s\nproperty float t\nelement tristrips 1\n\
            property list int int vertex_indices\nend_header\n";
        let vertex = |x: f32, y: f32| [x, y, 0.0, 0.0, 0.0, 1.0, x, y];
        let vertices = [vertex(0.0, 0.0), vertex(1.0, 0.0), vertex(0.0, 1.0)];
        let strip = [5i32, 0, 1, 2, -1, 0];
        let mut little = format!("ply\nformat binary_little_endian 1.0\n{header}").into_bytes();
        let mut big = format!("ply\nformat binary_big_endian 1.0\n{header}").into_bytes();
        for value in vertices.iter().flatten() {
            little.extend(value.to_le_bytes());
            big.extend(value.to_be_bytes());
        }
        for value in strip {
            little.extend(value.to_le_bytes());
            big.extend(value.to_be_bytes());
        }
        let [little, big] = [little, big].map(|bytes| read_ply(&bytes, "a.ply").unwrap());
        assert_eq!(little, big);
        assert_eq!((little.faces.len(), little.uvs[1], little.normals[2]), (1, [1.0, 0.0], [0.0, 0.0, 1.0]));
        assert_eq!(little.faces[0].corners[1], Corner { position: 1, uv: Some(1), normal: Some(1) });
    }

    #[test]
    fn texture_coordinates_of_corners_are_read() {
        let header = HEADER.replace("end_header", "property list uchar float texcoord\nend_header");
        let text = format!("{header}{VERTICES}3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0.5 1\n");
        let model = read_ply(text.as_bytes(), "a.ply").unwrap();
        assert_eq!(model.uvs[5], [0.5, 1.0]);
        assert_eq!(model.faces[1].corners.map(|corner| corner.uv), [Some(3), Some(4), Some(5)]);
    }

    #[test]
    fn wrong_files_are_refused() {
        let cases = [
            (format!("{HEADER}{VERTICES}3 0 1 4\n3 0 1 2\n"), "the vertex 4 of 4"),
            (format!("{HEADER}{VERTICES}3 0 1 2\n"), "Unexpected end of file"),
            (format!("{HEADER}0 0 zero 9\n"), "no PLY"),
            (format!("{HEADER}{VERTICES}2 0 1\n1 0\n"), "no faces, but 4 vertices"),
            (HEADER.replace("vertex 4", "vertex 4000000000"), "4000000000 elements 'vertex' in 0 bytes"),
            ("ply\nformat ascii 1.0\nelement vertex".to_owned(), "no PLY"),
        ];
        for (text, wanted) in cases {
            let error = error(&text);
            assert!(error.starts_with("a.ply: found ") && error.contains(wanted), "{error}");
            assert!(!error.contains('\n') && error.len() < 400, "{error}");
        }
    }
}
