//! Checks for commands that only grow flat canvases.

use std::path::Path;

use super::Error;
use crate::document::Document;
use crate::files;

/// Refuses a document on a model, for a command that only grows flat canvases.
///
/// # Errors
/// [`Error::Usage`] with the file, and the command that grows it.
pub fn check_flat(document: &Document, file: &Path, command: &str) -> Result<(), Error> {
    let file = files::source(file);
    match document.model {
        Some(_) => Err(Error::Usage(format!(
            "{file}: found a document on a model; {command} shows flat documents; allowed: dapple grow {file} -o OUT.png"
        ))),
        None => Ok(()),
    }
}
