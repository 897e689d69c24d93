//! Writes an error with its causes on one line, and errors of the operating system in plain words.

use std::error::Error;
use std::io::{self, ErrorKind};

/// The message of an error and those of its causes, on one line.
#[must_use]
pub fn with_causes(error: &dyn Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let message = error.to_string();
        let words = error.downcast_ref::<io::Error>().map_or_else(|| message.clone(), io_in_words);
        text = match text.strip_suffix(&message) {
            // Transparent errors repeat the message of their cause.
            Some(before) => format!("{before}{words}"),
            None => format!("{text}: {words}"),
        };
        cause = error.source();
    }
    text
}

/// The message of an operating-system error, in words that are the same on every system.
#[must_use]
pub fn io_in_words(error: &io::Error) -> String {
    let words = match error.kind() {
        // An error that carries a message says more than its kind.
        _ if error.get_ref().is_some() => return error.to_string(),
        ErrorKind::NotFound => "file or folder not found",
        ErrorKind::PermissionDenied => "no permission",
        ErrorKind::AlreadyExists => "it already exists",
        ErrorKind::IsADirectory => "it is a folder",
        ErrorKind::NotADirectory => "a part of its path is no folder",
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::ReadOnlyFilesystem => "the disk cannot be written to",
        _ => {
            let said = error.to_string();
            return said.split(" (os error").next().unwrap_or(&said).to_owned();
        }
    };
    words.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, thiserror::Error)]
    #[error("a.png: cannot be read")]
    struct Told(#[source] io::Error);

    #[derive(Debug, thiserror::Error)]
    #[error("a.png: {0}")]
    struct Repeated(#[source] io::Error);

    #[test]
    fn errors_of_the_system_are_in_words() {
        let missing = || std::fs::read("no such folder/a.png").unwrap_err();
        assert_eq!(with_causes(&Told(missing())), "a.png: cannot be read: file or folder not found");
        assert_eq!(with_causes(&Repeated(missing())), "a.png: file or folder not found");
        assert_eq!(with_causes(&Told(io::Error::other("disk full"))), "a.png: cannot be read: disk full");
        let other = io::Error::from_raw_os_error(4);
        assert!(!io_in_words(&other).contains("os error"), "{other}");
    }
}
