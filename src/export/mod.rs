//! Pictures → bytes, and bytes → files that are whole or not there.
//!
//! [`shrink()`] makes a small picture of a large one. [`png`] turns rows into a PNG stream. [`save()`] puts a stream into a file: it writes beside the target and
//! renames at the end, so that neither an error nor a cancelled run leaves half a picture, nor harms the one
//! that was there before.

pub mod motion;
pub mod outline;
pub mod png;
mod save;
mod shrink;

pub use save::{
    ExportError, FORMATS, Prepared, check_ending, check_file, check_target, has_ending, prepare, save,
};
pub use shrink::shrink;

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
