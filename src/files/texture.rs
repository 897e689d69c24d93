//! Writes a texture to a file in one call.

use std::path::Path;

use super::pictures::SavePicture;
use super::save::save;
use crate::document::embedded::MAX_SCALE;
use crate::export::{ExportError, has_ending, outline};
use crate::synth::render::painting::Channel;
use crate::synth::{Grown, Watch};

/// Textures in files.
pub trait SaveTexture {
    /// Writes the complete texture to a file; if that fails, an older file of this name is kept.
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

    /// Writes the texture with `scale` times the px along each side: the texture is the same, but finer. A scale
    /// outside 1 to 64 is limited to that range.
    ///
    /// # Errors
    /// Those of [`SaveTexture::save`].
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
