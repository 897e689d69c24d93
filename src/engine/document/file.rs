//! Reading and writing `.dapple` files.

use crate::document::node::Node;
use crate::document::{Document, DocumentError, limits, migrate, reader, syntax, writer};
use crate::export::save;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

impl Document {
    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be read, or is not a valid document.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, DocumentError> {
        let path = path.as_ref();
        let file = path.display().to_string();
        if path.is_dir() {
            return Err(DocumentError::Folder { file });
        }
        let bytes = bytes(path).map_err(|source| DocumentError::Unreadable { file: file.clone(), source })?;
        if bytes.len() as u64 > limits::MAX_FILE {
            return Err(DocumentError::TooLarge { file, limit: limits::MAX_FILE });
        }
        let text = syntax::text(&bytes).map_err(|problem| problem.in_file(&file))?;
        Self::parse(text, &file)
    }

    /// Parses the text of a file; errors call it `source_name`.
    ///
    /// # Errors
    /// The text is not a valid document.
    pub fn parse(text: &str, source_name: &str) -> Result<Self, DocumentError> {
        let value = syntax::json(text).map_err(|problem| problem.in_file(source_name))?;
        let value = migrate::to_newest(value, source_name)?;
        reader::document(&Node::root(&value)).map_err(|problem| problem.in_file(source_name))
    }

    /// The text of its file: complete, easy to read, and the same for equal documents.
    #[must_use]
    pub fn to_json(&self) -> String {
        writer::text(&writer::value(self))
    }

    /// Writes a file. If that fails, an older file of this name is kept as it was.
    ///
    /// # Errors
    /// It is not valid (see [`Document::check`]), or the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), DocumentError> {
        let path = path.as_ref();
        self.check(&path.display().to_string())?;
        Ok(save(path, |out| Ok(out.write_all(self.to_json().as_bytes())?))?)
    }

    /// Checks a document that was put together in code by the rules for files; a NaN is reported as `null`.
    ///
    /// # Errors
    /// The first value that a file may not hold; the error calls the document `source_name`.
    pub fn check(&self, source_name: &str) -> Result<(), DocumentError> {
        let value = writer::value(self);
        reader::document(&Node::root(&value)).map(drop).map_err(|problem| problem.in_file(source_name))
    }
}

/// The file's bytes, at most one more than the limit.
fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(limits::MAX_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
