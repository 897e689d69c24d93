//! What can be wrong with a model: the file, the place, what was found, what is allowed, and what to do.

use std::collections::BTreeSet;

use thiserror::Error;

/// How many characters of a wrong value a message shows.
const SHOWN: usize = 40;
/// How many characters of what a library says of a file a message shows: it may quote the file.
const SAID: usize = 200;
/// How many names of parts a message lists.
const LISTED: usize = 20;

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
}

/// Why a model cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ModelError {
    /// A file of another format.
    #[error(
        "{file}: found {found}; allowed: an OBJ, PLY, STL, glTF or GLB file; open it in a modeller, such as Blender, and export it as GLB or OBJ"
    )]
    OtherFormat {
        /// The file.
        file: String,
        /// What it is.
        found: &'static str,
    },
    /// A line that is not as the format wants it.
    #[error("{}, line {}: found {found}; allowed: {allowed}; {remedy}", place.file, place.line)]
    Line {
        /// Where.
        place: Place,
        /// What was found.
        found: String,
        /// What is allowed.
        allowed: String,
        /// What to do.
        remedy: &'static str,
    },
    /// A file that is not as its format wants it.
    #[error("{file}: found {found}; allowed: {allowed}; {remedy}")]
    Broken {
        /// The file.
        file: String,
        /// What was found, and where.
        found: String,
        /// What is allowed.
        allowed: String,
        /// What to do.
        remedy: &'static str,
    },
    /// Nothing to grow on.
    #[error(
        "{file}: found {found}; allowed: at least one triangle or polygon; export the model with its faces"
    )]
    NoFaces {
        /// The file.
        file: String,
        /// What there is instead.
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
        /// The names that there are.
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

/// A value as a message shows it: its beginning, without characters that cannot be seen.
pub(super) fn quoted(word: &str) -> String {
    format!("'{}'", beginning(word, SHOWN))
}

/// What a library says of a file, as a message shows it: its beginning, in one line.
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
