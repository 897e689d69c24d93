//! Files of the system.

use std::path::Path;

pub use std::fs::*;

/// Whether there is something at `path`.
#[must_use]
pub fn exists(path: impl AsRef<Path>) -> bool {
    path.as_ref().exists()
}

/// Whether a folder is at `path`.
#[must_use]
pub fn is_dir(path: impl AsRef<Path>) -> bool {
    path.as_ref().is_dir()
}
