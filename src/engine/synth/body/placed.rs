//! The model of a document in px of the sketch, prepared for growing.

use crate::document::{Body, BodySource, Document, DocumentError, Problem};
use crate::surface::{Mesh, Model, ModelError, Repairs, built_in, prepare, read_model};
use crate::synth::body::texture_coordinates::TextureCoordinates;

/// A model in px of the sketch.
pub struct Placed {
    /// The model as its file has it.
    pub model: Model,
    /// What is grown on: px, prepared.
    pub mesh: Mesh,
    /// What was mended.
    pub repairs: Repairs,
    /// From the coordinates of the file to px.
    pub scale: Scale,
    /// Its texture coordinates, where maps of the document need them.
    pub coordinates: Option<TextureCoordinates>,
}

/// Coordinates of a file ↔ px of the sketch about the middle of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The middle of the bounding box, in the file.
    pub middle: [f64; 3],
    /// px a unit of the file.
    pub px: f64,
}

impl Scale {
    /// px of a place of the file.
    #[must_use]
    pub fn to_px(self, at: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (at[i] - self.middle[i]) * self.px)
    }

    /// The place in the file.
    #[must_use]
    pub fn to_file(self, at: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| at[i] / self.px + self.middle[i])
    }
}

impl Placed {
    /// Reads the model of a document that messages call `source`; `bytes` are those of its file, which has them unless it is built
    /// in.
    ///
    /// # Errors
    /// It cannot be read, or has nothing to grow on: file, place, what was found, what is allowed.
    pub fn read(body: &Body, bytes: Option<&[u8]>, source: &str) -> Result<Self, DocumentError> {
        let unusable = |reason: ModelError| DocumentError::Model { file: source.to_owned(), reason };
        let model = match (&body.source, bytes) {
            (BodySource::BuiltIn(name), None) => built_in(name),
            (source, Some(bytes)) => Some(read_model(bytes, source.name()).map_err(unusable)?),
            (BodySource::File { .. }, None) => None,
        };
        let refused =
            |found: String, allowed: &str| Problem::new("model.file", found, allowed).in_file(source);
        let model = model.ok_or_else(|| {
            refused(format!("{}, which was not read", body.source), "a model beside the document")
        })?;
        let whole = model.mesh(&body.only).map_err(unusable)?;
        let [low, high] = model.bounds();
        let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let scale =
            Scale { middle: std::array::from_fn(|i| 0.5 * (low[i] + high[i])), px: body.px / longest };
        let positions = whole.positions.iter().map(|at| scale.to_px(*at)).collect();
        let (mesh, repairs) = prepare(&Mesh { positions, faces: whole.faces })
            .map_err(|error| refused(error.to_string(), "a model with triangles that have an area"))?;
        Ok(Self { model, mesh, repairs, scale, coordinates: None })
    }

    /// This model with the texture coordinates that the maps of a document need.
    ///
    /// # Errors
    /// It has none: the place in the document, and what is allowed.
    pub fn with_coordinates(self, document: &Document, source: &str) -> Result<Self, DocumentError> {
        let to_px = |at: [f64; 3]| self.scale.to_px(at);
        let coordinates = TextureCoordinates::needed(document, &self.model, &to_px, source)?;
        Ok(Self { coordinates, ..self })
    }

    /// What was left out of the file, understood otherwise, or mended: a sentence each.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        self.model.notes.iter().cloned().chain(self.repairs.notes()).collect()
    }
}
