//! `--set`: values that replace those in the documents of a command.

use std::path::Path;

use super::Error;
use crate::document::{Document, Extent, Setting};
use crate::files::{self, ReadFile};

/// Values that replace those in a document.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct Settings {
    /// Values that are put into the document before it is checked.
    // A separate text, because in documentation the brackets of a place would be links.
    #[arg(
        long = "set",
        value_name = "PLACE=VALUE",
        help = "Put a value into the document before it is checked: PLACE=VALUE, such as layers[0].options.ragged=.2, \
                layers[0].system=stripes or layers[0].colours=#f4e3c1,#3b2314; may be given several times"
    )]
    pub set: Vec<Setting>,
}

impl Settings {
    /// Reads a document.
    ///
    /// # Errors
    /// It cannot be read, or a value does not fit.
    pub fn read(&self, path: &Path) -> Result<Document, Error> {
        self.applied(Document::read(path)?, path)
    }

    /// Reads a document, or a PNG that holds one.
    ///
    /// # Errors
    /// Those of [`Self::read`].
    pub fn open(&self, path: &Path) -> Result<(Document, Extent), Error> {
        let (document, extent) = files::open(path)?;
        Ok((self.applied(document, path)?, extent))
    }

    /// The document of a file with the values put in. Height pictures beside the document are read again, because a
    /// value may name others.
    fn applied(&self, document: Document, path: &Path) -> Result<Document, Error> {
        let mut document = document.with_settings(&self.set, &files::source(path))?;
        if !self.set.is_empty() {
            files::read_heights(&mut document, path);
        }
        Ok(document)
    }
}
