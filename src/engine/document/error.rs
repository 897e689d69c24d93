//! Errors in documents: one message with file, place, the text found, and the allowed values.

use crate::document::limits::{MAX_LINK, MAX_LINK_TEXT};
use crate::export::ExportError;
use crate::export::png_text::Damaged;
use crate::photo::Foreign;
use crate::surface::ModelError;
use std::{fmt, io};

/// A wrong value in a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The JSON path of the value, such as `layers[0].strokes[3].radii[1]`.
    pub place: String,
    /// The text or value that was found.
    pub found: String,
    /// The allowed values.
    pub allowed: String,
}

impl Problem {
    /// A problem at a JSON path.
    pub fn new(place: impl Into<String>, found: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self { place: place.into(), found: found.into(), allowed: allowed.into() }
    }

    /// Turns it into an error of the document in `file`.
    #[must_use]
    pub fn in_file(self, file: &str) -> DocumentError {
        DocumentError::Content { file: file.to_owned(), problem: self }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: found {}; allowed: {}", self.place, self.found, self.allowed)
    }
}

/// The reason why a document could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum DocumentError {
    /// The file cannot be opened or read.
    #[error("{file}: cannot be read")]
    Unreadable {
        /// The file.
        file: String,
        /// The operating system's error.
        source: io::Error,
    },
    /// The path is a folder.
    #[error("{file}: found a folder; allowed: a .dapple file")]
    Folder {
        /// The folder.
        file: String,
    },
    /// The file is a picture without a document.
    #[error(
        "{file}: found a picture without a document; allowed: a .dapple file, or a PNG that dapple wrote with its \
         document in it"
    )]
    NoDocument {
        /// The file.
        file: String,
    },
    /// The file is of another format.
    #[error("{file}: found {what}, which is not read; allowed: a .dapple file, a PNG that dapple wrote, or a photograph (JPEG, PNG, WebP, TIFF, BMP, GIF) that is imported; {remedy}", what = found.what, remedy = found.remedy)]
    Foreign {
        /// The file.
        file: String,
        /// The kind of the file.
        found: Foreign,
    },
    /// The file is a PNG that cannot be read to its end.
    #[error("{file}: found a damaged picture; allowed: a .dapple file, or a whole PNG that dapple wrote")]
    Damaged {
        /// The file.
        file: String,
        /// The damage.
        source: Damaged,
    },
    /// The file is larger than any document.
    #[error("{file}: found a file of more than {limit} bytes; allowed: at most {limit} bytes")]
    TooLarge {
        /// The file.
        file: String,
        /// The size limit, bytes.
        limit: u64,
    },
    /// The file is not JSON in UTF-8.
    #[error("{file}: line {line}, column {column}: {problem}")]
    Syntax {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Character in the line, from 1.
        column: usize,
        /// The value that was found, and the allowed ones.
        problem: String,
    },
    /// The file is of a version that this program does not know yet.
    #[error(
        "{file}: version: found {version}, which is newer than this program; allowed: 1 to {known} \
         (a newer dapple reads it)"
    )]
    Newer {
        /// The file.
        file: String,
        /// Its version.
        version: u64,
        /// The newest version known here.
        known: u64,
    },
    /// Its model cannot be used.
    #[error("{file}: model: {reason}")]
    Model {
        /// The document's file.
        file: String,
        /// The reason.
        reason: ModelError,
    },
    /// A value is wrong.
    #[error("{file}: {problem}")]
    Content {
        /// The file.
        file: String,
        /// The place and the reason.
        problem: Problem,
    },
    /// The link in place of a file cannot be read.
    #[error(transparent)]
    Link(Box<LinkError>),
    /// The file cannot be written.
    #[error(transparent)]
    Unwritable(#[from] ExportError),
}

/// The reason why a link cannot be made or read.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// There is no document in it.
    #[error("found a text without \"#dapple1=\"; allowed: a link that dapple has made")]
    NoDocument,
    /// The link was written by a newer dapple.
    #[error("the link: version: found {version}; allowed: {known} (a newer dapple reads it)")]
    Newer {
        /// Its version.
        version: String,
        /// The newest version known here.
        known: &'static str,
    },
    /// The link has too many characters.
    #[error(
        "the link: found {found} characters; allowed: at most {MAX_LINK}; send the document as a file instead"
    )]
    TooLong {
        /// Number of characters.
        found: usize,
    },
    /// The link is not one that dapple has made.
    #[error(
        "the link is damaged or was cut off: {why}; copy the whole link, or ask for the document as a file"
    )]
    Damaged {
        /// The damage.
        why: String,
    },
    /// Its document is too large.
    #[error(
        "the link: found a document of more than {MAX_LINK_TEXT} bytes; allowed: at most {MAX_LINK_TEXT} bytes"
    )]
    TooLarge,
    /// Its document needs a file, which a link cannot hold.
    #[error(
        "the document grows on the model \"{file}\", a file that a link cannot hold; send the document and the model as files \
         instead"
    )]
    Model {
        /// The model.
        file: String,
    },
    /// Its document is wrong.
    #[error(transparent)]
    Document(#[from] DocumentError),
}
