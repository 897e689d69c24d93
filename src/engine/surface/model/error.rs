//! Errors of models: the file, the place, what was found, what is allowed, and the remedy.

use std::collections::BTreeSet;

use thiserror::Error;

/// Most characters of a wrong value in a message.
const SHOWN: usize = 40;
/// Most characters of a library's message in a message: it may quote the file.
const SAID: usize = 200;
/// Most names of parts in a message.
const LISTED: usize = 20;

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
}

/// The reason why a model cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ModelError {
    /// A file of another format.
    #[error(
        "{file}: found {found}; allowed: an OBJ, PLY, STL, glTF or GLB file; open it in a modeller, such as Blender, and export it as GLB or OBJ"
    )]
    OtherFormat {
        /// The file.
        file: String,
        /// The kind of the file.
        found: &'static str,
    },
    /// A line that does not follow the format.
    #[error("{}, line {}: found {found}; allowed: {allowed}; {remedy}", place.file, place.line)]
    Line {
        /// The place.
        place: Place,
        /// The value that was found.
        found: String,
        /// The allowed values.
        allowed: String,
        /// The remedy.
        remedy: &'static str,
    },
    /// A file that does not follow its format.
    #[error("{file}: found {found}; allowed: {allowed}; {remedy}")]
    Broken {
        /// The file.
        file: String,
        /// The value that was found, and its place.
        found: String,
        /// The allowed values.
        allowed: String,
        /// The remedy.
        remedy: &'static str,
    },
    /// A file without triangles.
    #[error(
        "{file}: found {found}; allowed: at least one triangle or polygon; export the model with its faces"
    )]
    NoFaces {
        /// The file.
        file: String,
        /// The contents of the file.
        found: String,
    },
    /// A name that no part has.
    #[error(
        "{file}: found no group, object or material '{name}'; allowed: {allowed}; change `only` in the document"
    )]
    NoPart {
        /// The file or the built-in body.
        file: String,
        /// The name.
        name: String,
        /// The names of the parts.
        allowed: String,
    },
}

impl ModelError {
    pub(super) fn no_part(file: &str, name: &str, names: &BTreeSet<&str>) -> Self {
        let mut listed: Vec<String> = names.iter().take(LISTED).map(|name| format!("'{name}'")).collect();
        if names.len() > LISTED {
            listed.push(format!("and {} more", names.len() - LISTED));
        }
        let allowed =
            if names.is_empty() { "none, because it has no names".to_owned() } else { listed.join(", ") };
        Self::NoPart { file: file.to_owned(), name: name.to_owned(), allowed }
    }
}

/// A value in the form of a message: its beginning, without invisible characters.
pub(super) fn quoted(word: &str) -> String {
    format!("'{}'", beginning(word, SHOWN))
}

/// A library's message in the form of a message: its beginning, in one line.
pub(super) fn said(text: &str) -> String {
    beginning(&text.split_ascii_whitespace().collect::<Vec<_>>().join(" "), SAID)
}

fn beginning(text: &str, most: usize) -> String {
    let mut shown: String =
        text.chars().map(|letter| if letter.is_control() { '\u{fffd}' } else { letter }).take(most).collect();
    if text.chars().count() > most {
        shown.push('…');
    }
    shown
}
