//! The STL format: triangles without shared vertices, as text or binary.
//!
//! A reader of our own: the existing crate stops at the end of the first solid of a text, and does not give the line of an error.
//! Normals are not read, as they follow from the corners. Corners at one place become one vertex.

use std::collections::HashMap;

use super::error::{ModelError, Place, quoted};
use super::{Corner, Face, Model, Part};

/// Bytes before the triangles of a binary file: a text of 80, and their number.
const HEADER: usize = 84;
/// Bytes of a triangle: a normal, three corners, two of attributes.
const TRIANGLE: usize = 50;

/// Whether a file is an STL file: it begins with the keyword of the text format, or its length agrees with its number of triangles.
pub fn is_stl(bytes: &[u8]) -> bool {
    let first = bytes.trim_ascii_start().split(u8::is_ascii_whitespace).next();
    first.is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) || is_binary(bytes)
}

/// Whether the length fits the number of triangles; some programs add bytes at the end.
fn is_binary(bytes: &[u8]) -> bool {
    let Some((_, rest)) = bytes.split_at_checked(80) else { return false };
    let Some((count, triangles)) = rest.split_first_chunk() else { return false };
    let wanted = TRIANGLE as u64 * u64::from(u32::from_le_bytes(*count));
    let longer = (triangles.len() as u64).checked_sub(wanted);
    wanted > 0 && longer.is_some_and(|longer| longer < TRIANGLE as u64) && !is_text(bytes)
}

/// Whether the file contains the text of a facet; the header of a binary file may begin with the keyword, too.
fn is_text(bytes: &[u8]) -> bool {
    let beginning = &bytes[..bytes.len().min(4096)];
    !beginning.contains(&0) && beginning.windows(5).any(|word| word.eq_ignore_ascii_case(b"facet"))
}

/// Reads a model from the bytes of an STL file; `name` is the file's, for messages.
///
/// # Errors
/// A line that does not follow the format, a file that is cut off, a model without triangles.
pub fn read_stl(bytes: &[u8], name: &str) -> Result<Model, ModelError> {
    let mut reader =
        Reader { model: Model { name: name.to_owned(), ..Model::default() }, ..Reader::default() };
    if is_text(bytes) {
        reader.text(&String::from_utf8_lossy(bytes))?;
    } else {
        reader.binary(bytes)?;
    }
    if reader.model.faces.is_empty() {
        return Err(ModelError::NoFaces { file: name.to_owned(), found: "no triangles".to_owned() });
    }
    Ok(reader.model)
}

#[derive(Default)]
struct Reader {
    model: Model,
    /// The vertex at each place.
    vertices: HashMap<[u64; 3], u32>,
}

impl Reader {
    fn binary(&mut self, bytes: &[u8]) -> Result<(), ModelError> {
        let count =
            bytes.get(80..HEADER).and_then(|count| count.try_into().ok()).map_or(0, u32::from_le_bytes);
        let triangles = bytes.get(HEADER..).unwrap_or_default();
        if (triangles.len() as u64) < TRIANGLE as u64 * u64::from(count) {
            return Err(ModelError::Broken {
                file: self.model.name.clone(),
                found: format!("{} bytes for {count} triangles", triangles.len()),
                allowed: format!("{TRIANGLE} bytes a triangle"),
                remedy: "export the model again; the file may be cut off",
            });
        }
        self.model.parts.push(Part::default());
        for triangle in triangles.chunks_exact(TRIANGLE).take(count as usize) {
            let number = |at: usize| {
                triangle[at..at + 4].try_into().map_or(f64::NAN, |bytes| f64::from(f32::from_le_bytes(bytes)))
            };
            self.face([12, 24, 36].map(|at| [0, 4, 8].map(|axis| number(at + axis))));
        }
        Ok(())
    }

    fn text(&mut self, text: &str) -> Result<(), ModelError> {
        let mut corners = Vec::new();
        for (at, line) in text.lines().enumerate() {
            let mut words = line.split_ascii_whitespace();
            let statement = words.next().unwrap_or_default().to_ascii_lowercase();
            match statement.as_str() {
                "solid" => {
                    let name: Vec<&str> = words.collect();
                    let object = (!name.is_empty()).then(|| name.join(" "));
                    self.model.parts.push(Part { object, ..Part::default() });
                }
                "vertex" => corners.push(self.position(at + 1, words)?),
                "endloop" => {
                    let Ok(triangle) = <[_; 3]>::try_from(std::mem::take(&mut corners)) else {
                        return Err(self.error(
                            at + 1,
                            "a loop of another number of corners".to_owned(),
                            "3 corners",
                        ));
                    };
                    self.face(triangle);
                }
                "" | "facet" | "outer" | "endfacet" | "endsolid" | "color" => {}
                other => {
                    let allowed = "solid, facet, outer loop, vertex, endloop, endfacet, endsolid";
                    return Err(self.error(at + 1, quoted(other), allowed));
                }
            }
        }
        if corners.is_empty() {
            return Ok(());
        }
        Err(self.error(text.lines().count(), "the end of the file within a triangle".to_owned(), "endloop"))
    }

    fn position<'a>(
        &self,
        line: usize,
        words: impl Iterator<Item = &'a str>,
    ) -> Result<[f64; 3], ModelError> {
        let words: Vec<&str> = words.collect();
        let numbers: Option<Vec<f64>> = words.iter().map(|word| word.parse().ok()).collect();
        numbers
            .and_then(|numbers| <[f64; 3]>::try_from(numbers).ok())
            .ok_or_else(|| self.error(line, quoted(&words.join(" ")), "three numbers after vertex"))
    }

    fn error(&self, line: usize, found: String, allowed: &str) -> ModelError {
        let place = Place { file: self.model.name.clone(), line };
        let remedy = "export the model again; the file may be cut off";
        ModelError::Line { place, found, allowed: allowed.to_owned(), remedy }
    }

    fn face(&mut self, corners: [[f64; 3]; 3]) {
        if self.model.parts.is_empty() {
            self.model.parts.push(Part::default());
        }
        let part = self.model.parts.len() as u32 - 1;
        let corners = corners.map(|at| {
            // Zeros of both signs are equal.
            let key = at.map(|value| (value + 0.0).to_bits());
            let next = self.model.positions.len() as u32;
            Corner::from(*self.vertices.entry(key).or_insert_with(|| {
                self.model.positions.push(at);
                next
            }))
        });
        self.model.faces.push(Face { corners, part });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACET: &str = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

    /// Two triangles of a square.
    fn square() -> Vec<u8> {
        let corners: [[f32; 3]; 6] =
            [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [-0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mut bytes = b"solid in its header".to_vec();
        bytes.resize(80, b' ');
        bytes.extend(2u32.to_le_bytes());
        for triangle in corners.chunks(3) {
            bytes.extend([0; 12]);
            bytes.extend(triangle.iter().flatten().flat_map(|value| value.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    #[test]
    fn corners_at_the_same_place_are_one_vertex() {
        let model = read_stl(&square(), "a.stl").unwrap();
        assert_eq!((model.positions.len(), model.faces.len(), model.parts.len()), (4, 2, 1));
        let vertices = |face: usize| model.faces[face].corners.map(|corner| corner.position);
        assert_eq!((vertices(0), vertices(1)), ([0, 1, 2], [0, 2, 3]));
    }

    #[test]
    fn each_solid_of_a_text_is_a_part() {
        let text = format!(
            "solid left ear\n{FACET}endsolid left ear\nSOLID tail\n{}endsolid\n",
            FACET.to_uppercase()
        );
        let model = read_stl(text.as_bytes(), "a.stl").unwrap();
        let names: Vec<_> = model.parts.iter().map(|part| part.object.clone().unwrap()).collect();
        assert_eq!((names, model.faces.len()), (vec!["left ear".to_owned(), "tail".to_owned()], 2));
        assert_eq!([0, 1].map(|face: usize| model.faces[face].part), [0, 1]);
    }

    #[test]
    fn wrong_files_are_refused_with_their_place() {
        let texts = [
            ("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 4: found '0 0'"),
            ("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", "line 5: found a loop"),
            ("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "line 4: found the end of the file"),
            ("solid\nfacet\nwing\n", "line 3: found 'wing'"),
            ("solid\nfacet\nendsolid\n", "found no triangles"),
        ];
        for (text, wanted) in texts {
            let error = read_stl(text.as_bytes(), "a.stl").unwrap_err().to_string();
            assert!(error.starts_with("a.stl") && error.contains(wanted), "{error}");
        }
        let cut = &square()[..150];
        let error = read_stl(cut, "a.stl").unwrap_err().to_string();
        assert!(error.contains("found 66 bytes for 2 triangles"), "{error}");
    }
}
