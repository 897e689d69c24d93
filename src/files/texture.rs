//! From a growth to a file in one call.

use std::path::Path;

use super::pictures::SavePicture;
use super::save::save;
use crate::document::embedded::MAX_SCALE;
use crate::export::{ExportError, has_ending, outline};
use crate::synth::render::painting::Channel;
use crate::synth::{Grown, Watch};

/// Textures in files.
pub trait SaveTexture {
    /// Writes the texture to a file, or leaves what was there: never half of it.
    ///
    /// The ending of `path` says what is written: a picture (`.png`, `.tif`, `.exr`, `.jpg`, `.webp`) of the canvas' size,
    /// or outlines of the marks (`.svg`, `.dxf`) in mm by the document's dpi. A PNG holds the document, so that dapple
    /// reads it back.
    ///
    /// # Errors
    /// Another ending, a canvas that the format cannot hold, or a file that cannot be written.
    fn save(&self, path: impl AsRef<Path>) -> Result<(), ExportError> {
        self.save_scaled(path, 1)
    }

    /// Writes the texture with `scale` times the px along each side: the same texture, finer. A scale outside of 1 to 64 is taken
    /// as the nearest of these.
    ///
    /// # Errors
    /// As [`SaveTexture::save`].
    fn save_scaled(&self, path: impl AsRef<Path>, scale: u32) -> Result<(), ExportError>;
}

impl SaveTexture for Grown {
    fn save_scaled(&self, path: impl AsRef<Path>, scale: u32) -> Result<(), ExportError> {
        let (path, scale) = (path.as_ref(), scale.clamp(1, MAX_SCALE));
        if outline::FORMATS.iter().any(|ending| has_ending(path, ending)) {
            return save(path, |out| self.write_outlines(out, has_ending(path, "dxf"), scale));
        }
        let painting = self.painting(scale);
        painting.prepare(path, Channel::Texture, &self.style(scale), &Watch::NONE)?.keep()
    }
}
