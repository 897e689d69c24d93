//! Pictures → bytes.
//!
//! [`picture`] writes rows in a [`Format`]: [`png`], [`tiff`], [`exr`], JPEG or WebP. [`png_text`] reads the texts in a PNG.
//! [`gray_png`] holds gray pictures that travel in documents.
//! [`outline`] draws the outlines of marks as SVG and DXF. [`maps`] computes heights, normals and occlusion of patterns;
//! [`material`] and [`gltf`] write them as engines expect. [`motion`] writes films. [`body`] draws and writes models.
//! [`downscale()`] makes a small picture of a large one. All of them write to any stream; [`ExportError`] tells the user why a file
//! was not written.

pub mod bake;
pub mod body;
mod downscale;
mod error;
pub mod exr;
mod format;
pub mod gltf;
pub mod gray_png;
pub mod maps;
pub mod material;
pub mod motion;
pub mod outline;
pub mod picture;
pub mod png;
pub mod png_text;
pub mod tiff;
pub mod web;

pub use downscale::{downscale, srgb_from_linear};
pub use error::ExportError;
pub use format::{Content, Format, has_ending};

/// The reason why a writer stopped early.
#[derive(Debug, thiserror::Error)]
pub enum Stopped {
    /// The bytes could not be written.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The caller cancelled.
    #[error("cancelled")]
    Cancelled,
}
