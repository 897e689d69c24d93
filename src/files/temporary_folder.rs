//! A folder for temporary files.

use std::io;
use std::path::Path;

use super::abandon::created;
use crate::machine::temporary::{Builder, TempDir};

/// A new folder among the system's temporary files. Dropping it deletes it with its contents.
#[derive(Debug)]
pub struct TemporaryFolder(TempDir);

impl TemporaryFolder {
    /// Creates the folder.
    ///
    /// # Errors
    /// The folder cannot be created.
    pub fn new() -> io::Result<Self> {
        let create = || Builder::new().prefix("dapple-").tempdir();
        created(create, |folder| folder.path().to_owned()).map(Self)
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}
