//! Temporary files and folders, which are deleted when they are dropped.

use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use super::fs::{self, File, OpenOptions, Permissions};

/// The folder for temporary folders that need no special place.
const FOLDER: &str = "/temporary";

/// The form of the name of a temporary file or folder.
#[derive(Debug, Default)]
pub struct Builder<'a, 'b> {
    prefix: &'a str,
    suffix: &'b str,
}

impl<'a, 'b> Builder<'a, 'b> {
    /// A name of numbers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the beginning of the name.
    pub fn prefix(&mut self, prefix: &'a str) -> &mut Self {
        self.prefix = prefix;
        self
    }

    /// Sets the end of the name.
    pub fn suffix(&mut self, suffix: &'b str) -> &mut Self {
        self.suffix = suffix;
        self
    }

    /// Does nothing: every file may be read and written.
    pub fn permissions(&mut self, _: Permissions) -> &mut Self {
        self
    }

    fn name(&self) -> String {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        format!("{}{}{}", self.prefix, NUMBER.fetch_add(1, Ordering::Relaxed), self.suffix)
    }

    /// Creates a temporary file in `folder`.
    ///
    /// # Errors
    /// The folder is missing.
    pub fn tempfile_in(&self, folder: impl AsRef<Path>) -> io::Result<NamedTempFile> {
        let path = folder.as_ref().join(self.name());
        let file = OpenOptions::new().write(true).create_new(true).open(&path)?;
        Ok(NamedTempFile { file, path: Beside(path) })
    }

    /// Creates a temporary folder in `parent`.
    ///
    /// # Errors
    /// The parent is missing.
    pub fn tempdir_in(&self, parent: impl AsRef<Path>) -> io::Result<TempDir> {
        let path = parent.as_ref().join(self.name());
        fs::create_dir(&path)?;
        Ok(TempDir(Beside(path)))
    }

    /// Creates a temporary folder.
    ///
    /// # Errors
    /// None.
    pub fn tempdir(&self) -> io::Result<TempDir> {
        fs::create_dir_all(FOLDER)?;
        self.tempdir_in(FOLDER)
    }
}

/// A path whose file or folder is deleted when this is dropped.
#[derive(Debug)]
struct Beside(PathBuf);

impl Beside {
    /// Returns the path; the file or folder is no longer deleted.
    fn keep(mut self) -> PathBuf {
        std::mem::take(&mut self.0)
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        if self.0 != Path::new("") {
            let _ = fs::remove_file(&self.0).or_else(|_| fs::remove_dir_all(&self.0));
        }
    }
}

/// A temporary folder.
#[derive(Debug)]
pub struct TempDir(Beside);

impl TempDir {
    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0.0
    }

    /// Returns its path; the folder is no longer deleted.
    #[must_use]
    pub fn keep(self) -> PathBuf {
        self.0.keep()
    }
}

/// A temporary file.
#[derive(Debug)]
pub struct NamedTempFile {
    file: File,
    path: Beside,
}

/// A temporary file that could not be renamed.
#[derive(Debug)]
pub struct PersistError {
    /// The reason.
    pub error: io::Error,
}

impl NamedTempFile {
    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path.0
    }

    /// The file.
    #[must_use]
    pub fn as_file(&self) -> &File {
        &self.file
    }

    /// Renames the file; it is no longer deleted.
    ///
    /// # Errors
    /// A folder has that name, or the folder is missing.
    pub fn persist(self, target: impl AsRef<Path>) -> Result<File, PersistError> {
        fs::rename(&self.path.0, target).map_err(|error| PersistError { error })?;
        let _ = self.path.keep();
        Ok(self.file)
    }
}

impl Read for NamedTempFile {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.file.read(bytes)
    }
}

impl Write for NamedTempFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for NamedTempFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}
