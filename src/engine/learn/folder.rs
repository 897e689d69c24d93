//! A folder of training sets; the caller implements the access to files.

use std::io;
use std::path::Path;

/// A folder of training sets.
pub trait Folder: Send + Sync {
    /// Its name in messages: its path.
    fn path(&self) -> &Path;

    /// The names of its files, in any order.
    ///
    /// # Errors
    /// It cannot be read.
    fn names(&self) -> io::Result<Vec<String>>;

    /// The bytes of one of its files; `None` if there is none of this name.
    ///
    /// # Errors
    /// It cannot be read.
    fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>>;
}
