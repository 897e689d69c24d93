//! The text of a recovery file: a first line that names the format, a header in JSON, and the document.
//!
//! ```text
//! dapple recovery 2
//! {"when":1732200000123,"file":"/home/me/tiger.dapple","name":"tiger.dapple"}
//!
//! {"format": "dapple", …
//! ```
//!
//! `when` is milliseconds since 1970; `file` is left out where the document was never saved; `file` and `name` are
//! written as in [`path_encoding`].

use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::editor::path_encoding;
use crate::machine::clock::{SystemTime, UNIX_EPOCH};

/// An unsaved document, backed up in case of a crash.
#[derive(Clone, Debug)]
pub struct Backup {
    /// The document.
    pub document: Document,
    /// The file it was read from or saved to.
    pub path: Option<PathBuf>,
    /// The name shown to the user.
    pub name: String,
}

const FORMAT: &str = "dapple recovery ";
const VERSION: &str = "2";

#[derive(Debug, Serialize, Deserialize)]
struct Header {
    /// Milliseconds since 1970.
    when: u64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    #[serde(default)]
    name: String,
}

/// The text of the file.
pub(super) fn write(backup: &Backup, when: SystemTime) -> String {
    let absolute = |path: &PathBuf| std::path::absolute(path).unwrap_or_else(|_| path.clone());
    let header = Header {
        when: when.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_millis() as u64),
        file: backup.path.as_ref().map(|path| path_encoding::encode(&absolute(path))),
        name: path_encoding::encode(Path::new(&backup.name)),
    };
    let header = serde_json::to_string(&header).unwrap_or_default();
    format!("{FORMAT}{VERSION}\n{header}\n\n{}", backup.document.to_json())
}

/// The content of a file, and the time at which it was written.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn read(text: &str) -> Result<(Backup, SystemTime), String> {
    let (head, document) = text.split_once("\n\n").ok_or("it ends too early")?;
    let (format, lines) = head.split_once('\n').unwrap_or((head, ""));
    let version = format.strip_prefix(FORMAT).ok_or("it does not begin as a recovery file")?;
    if version != VERSION {
        return Err(format!("its version is {version}, and this dapple reads version {VERSION}"));
    }
    let header: Header = serde_json::from_str(lines).map_err(|error| format!("its header: {error}"))?;
    let document = Document::parse(document, "the unsaved document").map_err(|error| error.to_string())?;
    let name = path_encoding::decode(&header.name).to_string_lossy().into_owned();
    let path = header.file.as_deref().map(path_encoding::decode);
    // A time that the clock cannot represent must not make the document unreadable.
    let when = UNIX_EPOCH.checked_add(Duration::from_millis(header.when)).unwrap_or(UNIX_EPOCH);
    Ok((Backup { document, path, name }, when))
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: &str = r#"{"format": "dapple", "version": 1, "size": [96, 96], "layers": [{"strokes": [
        {"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30}]}]}"#;

    #[test]
    fn a_file_is_read_with_keys_that_are_unknown() {
        let header = r#"{"mood":"good","when":1732200000123,"file":"/home/a/%FF.dapple","name":"a"}"#;
        let (backup, _) = read(&format!("dapple recovery 2\n{header}\n\n{DOCUMENT}")).unwrap();
        assert_eq!(path_encoding::encode(backup.path.as_deref().unwrap()), "/home/a/%FF.dapple");
    }

    #[test]
    fn what_is_written_is_read_again() {
        let document = Document::parse(DOCUMENT, "").unwrap();
        for path in [None, Some(PathBuf::from("/a b/\"%\n.dapple"))] {
            let backup = Backup { document: document.clone(), path, name: "\"new\"\n%".to_owned() };
            let when = UNIX_EPOCH + Duration::from_millis(1_732_200_000_123);
            let (again, time) = read(&write(&backup, when)).unwrap();
            assert_eq!((again.document, again.path, again.name), (backup.document, backup.path, backup.name));
            assert_eq!(time, when);
        }
    }

    #[test]
    fn damaged_files_are_reported_with_the_reason() {
        for (text, said) in [
            ("dapple recovery 2", "ends too early"),
            ("dapple recovery 3\n{}\n\n{}", "version is 3"),
            ("{}\n\n{}", "begin"),
            ("dapple recovery 2\n{\"when\":-1}\n\n{}", "header"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(said), "{text:?}: {error}");
        }
    }
}
