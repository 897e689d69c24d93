//! A folder for files that are looked at and go.

use std::io;
use std::path::Path;

use tempfile::TempDir;

/// A folder of its own among the system's passing files. Dropped, it is gone with all that is in it.
#[derive(Debug)]
pub struct Passing(TempDir);

impl Passing {
    /// A new one.
    ///
    /// # Errors
    /// Where the system has no room for it.
    pub fn new() -> io::Result<Self> {
        tempfile::Builder::new().prefix("dapple-").tempdir().map(Self)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}
