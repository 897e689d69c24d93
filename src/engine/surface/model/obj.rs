//! The OBJ format (Wavefront, version 3.0): positions, texture coordinates, normals, faces, groups, objects and materials.
//!
//! A reader of our own: the existing crates neither give the line of an error nor cut polygons that are not convex. Colours after
//! positions are skipped; curves and free-form surfaces are skipped with a note.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::error::{ModelError, Place, quoted};
use super::polygon::{MOST_CORNERS, triangulate};
use super::{Corner, Face, Model, Part};

/// Statements that have no meaning here: files of materials, smoothing, and display options.
const PASSED_OVER: [&str; 11] = [
    "mtllib",
    "s",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "maplib",
    "usemap",
];
/// Statements that are not read, with a note.
const NOT_READ: [&str; 19] = [
    "l", "p", "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
    "sp", "end", "con", "call", "csh",
];

/// Reads a model from the bytes of an OBJ file; `name` is the file's, for messages.
///
/// # Errors
/// A line that does not follow the format, an index of nothing, a model without faces.
pub fn read_obj(bytes: &[u8], name: &str) -> Result<Model, ModelError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader =
        Reader { model: Model { name: name.to_owned(), ..Model::default() }, ..Reader::default() };
    let mut lines = bytes.split(|byte| *byte == b'\n').enumerate();
    while let Some((at, line)) = lines.next() {
        reader.line = at + 1;
        let mut line = Cow::Borrowed(line.trim_ascii_end());
        while line.ends_with(b"\\") {
            let next = lines.next().map_or(&b""[..], |(_, line)| line.trim_ascii_end());
            let joined = line.to_mut();
            joined.pop();
            joined.push(b' ');
            joined.extend(next);
        }
        reader.read(&String::from_utf8_lossy(&line))?;
    }
    reader.finish()
}

/// The corners of a polygon in the form of the file: indices from 1, with negative ones resolved; 0 = none.
struct Polygon {
    line: usize,
    part: u32,
    corners: Vec<[i64; 3]>,
}

#[derive(Default)]
struct Reader {
    model: Model,
    line: usize,
    polygons: Vec<Polygon>,
    parts: BTreeMap<Part, u32>,
    now: Part,
    /// Number of occurrences of each statement that is not read.
    not_read: BTreeMap<String, usize>,
    /// Number of faces of fewer than three corners.
    too_small: usize,
}

impl Reader {
    fn error(
        &self,
        line: usize,
        found: String,
        allowed: impl Into<String>,
        remedy: &'static str,
    ) -> ModelError {
        let place = Place { file: self.model.name.clone(), line };
        ModelError::Line { place, found, allowed: allowed.into(), remedy }
    }

    fn read(&mut self, line: &str) -> Result<(), ModelError> {
        // A comment begins at the start of a word: names of materials may contain the sign.
        let mut words = line.split_ascii_whitespace().take_while(|word| !word.starts_with('#'));
        let Some(statement) = words.next() else { return Ok(()) };
        let words: Vec<&str> = words.collect();
        let name = || (!words.is_empty()).then(|| words.join(" "));
        match statement {
            "v" => {
                let position = self.numbers(statement, &words)?;
                self.model.positions.push(position);
            }
            "vn" => {
                let normal = self.numbers(statement, &words)?;
                self.model.normals.push(normal);
            }
            "vt" => {
                // The second coordinate may be left out.
                let [u] = self.numbers(statement, &words)?;
                let [v] = if words.len() > 1 { self.numbers(statement, &words[1..])? } else { [0.0] };
                self.model.uvs.push([u, v]);
            }
            // `fo` is an obsolete name for it.
            "f" | "fo" => self.face(&words)?,
            "g" => self.now.groups = words.iter().map(|&word| word.to_owned()).collect(),
            "o" => self.now.object = name(),
            "usemtl" => self.now.material = name(),
            _ if PASSED_OVER.contains(&statement) => {}
            _ if NOT_READ.contains(&statement) => {
                *self.not_read.entry(statement.to_owned()).or_default() += 1;
            }
            _ => {
                let known = "v, vt, vn, f, g, o, usemtl and the other statements of the OBJ format";
                let remedy = "export the model again, or remove the line";
                return Err(self.error(
                    self.line,
                    format!("the statement {}", quoted(statement)),
                    known,
                    remedy,
                ));
            }
        }
        Ok(())
    }

    /// The first N words as numbers.
    fn numbers<const N: usize>(&self, statement: &str, words: &[&str]) -> Result<[f64; N], ModelError> {
        if words.len() < N {
            let found = format!("{} numbers after {statement}", words.len());
            return Err(self.error(self.line, found, format!("{N} numbers"), "export the model again"));
        }
        let mut numbers = [0.0; N];
        for (number, word) in numbers.iter_mut().zip(words) {
            *number = word.parse().map_err(|_| {
                let found = format!("{} after {statement}", quoted(word));
                let remedy =
                    if word.contains(',') { "write a decimal point" } else { "export the model again" };
                self.error(self.line, found, "numbers such as 0.25 or -1e-3", remedy)
            })?;
        }
        Ok(numbers)
    }

    fn face(&mut self, words: &[&str]) -> Result<(), ModelError> {
        if words.len() < 3 {
            self.too_small += 1;
            return Ok(());
        }
        if words.len() > MOST_CORNERS {
            let found = format!("a face of {} corners", words.len());
            let remedy = "triangulate the model before you export it";
            return Err(self.error(self.line, found, format!("3 to {MOST_CORNERS} corners"), remedy));
        }
        let corners = words.iter().map(|word| self.corner(word)).collect::<Result<_, _>>()?;
        let next = self.parts.len() as u32;
        let part = match self.parts.get(&self.now) {
            Some(part) => *part,
            None => *self.parts.entry(self.now.clone()).or_insert(next),
        };
        self.polygons.push(Polygon { line: self.line, part, corners });
        Ok(())
    }

    /// `position`, `position/uv`, `position//normal` or `position/uv/normal`.
    fn corner(&self, word: &str) -> Result<[i64; 3], ModelError> {
        let counts = self.counts();
        let index = |(at, text): (usize, &str)| match text.parse::<i64>() {
            _ if text.is_empty() && at > 0 => Some(0),
            Ok(0) | Err(_) => None,
            // Negative indices count back from the data read so far.
            Ok(index) if index < 0 => {
                counts.get(at).map(|count| count + 1 + index).filter(|index| *index > 0)
            }
            Ok(index) => Some(index),
        };
        let found: Option<Vec<i64>> = word.split('/').enumerate().map(index).collect();
        match found.as_deref() {
            Some(&[position]) => Ok([position, 0, 0]),
            Some(&[position, uv]) => Ok([position, uv, 0]),
            Some(&[position, uv, normal]) => Ok([position, uv, normal]),
            _ => Err(self.wrong_index(self.line, format!("the corner {}", quoted(word)))),
        }
    }

    fn counts(&self) -> [i64; 3] {
        [self.model.positions.len(), self.model.uvs.len(), self.model.normals.len()].map(|count| count as i64)
    }

    fn wrong_index(&self, line: usize, found: String) -> ModelError {
        let [positions, uvs, normals] = self.counts();
        let allowed = format!(
            "corners such as 1, 1/2, 1//3 or 1/2/3, of 1 to {positions} positions, {uvs} texture coordinates and \
             {normals} normals, or negative numbers that count back from the last one"
        );
        self.error(line, found, allowed, "export the model again; the file may be cut off")
    }

    /// Cuts the polygons after all positions are known: a file may have faces before their vertices.
    fn finish(mut self) -> Result<Model, ModelError> {
        for polygon in std::mem::take(&mut self.polygons) {
            let corners = polygon.corners.iter().map(|corner| self.resolved(*corner, polygon.line));
            let corners: Vec<Corner> = corners.collect::<Result<_, _>>()?;
            let place = |corner: &Corner| self.model.positions[corner.position as usize];
            let triangles = triangulate(&corners.iter().map(place).collect::<Vec<_>>());
            let faces = triangles
                .into_iter()
                .map(|triangle| Face { corners: triangle.map(|at| corners[at]), part: polygon.part });
            self.model.faces.extend(faces);
        }
        let mut parts: Vec<(Part, u32)> = std::mem::take(&mut self.parts).into_iter().collect();
        parts.sort_unstable_by_key(|(_, at)| *at);
        self.model.parts = parts.into_iter().map(|(part, _)| part).collect();
        self.model.notes = self.notes();
        if self.model.faces.is_empty() {
            let others =
                self.not_read.keys().map(|statement| format!(" and lines that begin with {statement}"));
            let found = format!("{} positions{}", self.model.positions.len(), others.collect::<String>());
            return Err(ModelError::NoFaces {
                file: self.model.name,
                found: format!("no faces, but {found}"),
            });
        }
        Ok(self.model)
    }

    fn resolved(&self, corner: [i64; 3], line: usize) -> Result<Corner, ModelError> {
        let counts = self.counts();
        for (at, what) in ["position", "texture coordinate", "normal"].into_iter().enumerate() {
            if corner[at] > counts[at].min(i64::from(u32::MAX)) {
                return Err(self.wrong_index(line, format!("{what} {}", corner[at])));
            }
        }
        let index = |at: usize| u32::try_from(corner[at] - 1).ok();
        // Not 0: `corner` has refused it.
        Ok(Corner { position: index(0).unwrap_or(0), uv: index(1), normal: index(2) })
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.too_small > 0 {
            notes.push(format!(
                "{}: {} faces of fewer than 3 corners were left out.",
                self.model.name, self.too_small
            ));
        }
        if !self.not_read.is_empty() {
            let counted = self.not_read.iter().map(|(statement, count)| format!("{statement} ({count})"));
            let listed = counted.collect::<Vec<_>>().join(", ");
            let note =
                format!("{}: lines, points and curved surfaces are not read: {listed}.", self.model.name);
            notes.push(note);
        }
        notes
    }
}

#[cfg(test)]
mod tests;
