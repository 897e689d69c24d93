//! Pictures → bytes, and bytes → complete files.
//!
//! [`picture`] writes rows in a [`Format`]: [`png`], [`tiff`], [`exr`], JPEG or WebP. [`png_text`] reads the texts in a PNG.
//! [`gray_png`] holds gray pictures that travel in documents.
//! [`outline`] draws the outlines of marks as SVG and DXF. [`maps`] computes heights, normals and occlusion of patterns;
//! [`material`] and [`gltf`] write them as engines expect. [`motion`] writes films. [`downscale()`] makes a small picture of a
//! large one. [`save()`] writes a stream into a temporary file beside the target and renames it at the end, so an error or a
//! cancelled run leaves no incomplete picture and keeps the file that was there before.

mod abandon;
mod downscale;
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
mod save;
mod stale_files;
mod temporary_folder;
pub mod tiff;
pub mod web;

pub use abandon::abandon;
pub use downscale::{downscale, srgb_from_linear};
pub use format::{Content, Format};
pub use save::{
    ExportError, Prepared, Unfinished, begin, check_content, check_ending, check_file, check_target,
    has_ending, keep_all, make_folder, prepare, save,
};
pub use temporary_folder::TemporaryFolder;

/// Why a writer stopped early.
#[derive(Debug, thiserror::Error)]
pub enum Stopped {
    /// The bytes could not be written.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The caller cancelled.
    #[error("cancelled")]
    Cancelled,
}
