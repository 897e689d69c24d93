//! Pictures → bytes, and bytes → files that are whole or not there.
//!
//! [`picture`] writes rows in the [`Format`] that a name asks for: [`png`], [`tiff`], [`exr`], JPEG and WebP. [`texts`]
//! reads what stands in a PNG beside its px. [`maps`] makes heights, normals and occlusion of patterns; [`material`] and
//! [`gltf`] write them as engines expect. [`shrink()`] makes a small picture of a large one. [`save()`] puts a stream into
//! a file: it writes beside the target and renames at the end, so that neither an error nor a cancelled run leaves half
//! a picture, nor harms the one that was there before.

pub mod exr;
mod format;
pub mod gltf;
pub mod maps;
pub mod material;
pub mod motion;
pub mod outline;
pub mod picture;
pub mod png;
mod save;
mod shrink;
mod stale_files;
mod temporary_folder;
pub mod texts;
pub mod tiff;
pub mod web;

pub use format::{Content, Format};
pub use save::{
    Begun, ExportError, Prepared, begin, check_content, check_ending, check_file, check_target, has_ending,
    make_folder, prepare, save,
};
pub use shrink::shrink;
pub use temporary_folder::Passing;

/// Why a writer stopped before its end.
#[derive(Debug, thiserror::Error)]
pub enum Stopped {
    /// The bytes could not be written.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// Whoever gives the rows does not want to go on.
    #[error("cancelled")]
    Cancelled,
}
