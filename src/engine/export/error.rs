//! The reasons for which a file was not written, for the user.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::format::{Content, Format, endings};

/// The reason why a file was not written. No incomplete file is left behind, and an existing file is unchanged.
#[derive(Debug, Error)]
pub enum ExportError {
    /// An unknown ending, or the ending of a format that does not fit.
    #[error("cannot write '{}': its name {}; allowed: .{}", path.display(), ending(path), allowed.join(", ."))]
    UnknownFormat {
        /// The requested path.
        path: PathBuf,
        /// The allowed endings.
        allowed: Vec<&'static str>,
    },
    /// A side is longer than the format can hold.
    #[error(
        "cannot write '{}': {}×{} px are more than {} can hold; allowed: {} px a side, or another format ({})",
        path.display(), size[0], size[1], format.name(), format.max_side(), endings(Content::Colours)
    )]
    TooWide {
        /// The requested path.
        path: PathBuf,
        /// Width and height, px.
        size: [usize; 2],
        /// The format.
        format: Format,
    },
    /// The format cannot hold some content.
    #[error("cannot write '{}': {} cannot hold {what}; allowed: {allowed}", path.display(), format.name())]
    CannotHold {
        /// The requested path.
        path: PathBuf,
        /// The format.
        format: Format,
        /// The content.
        what: &'static str,
        /// The formats that can hold the content.
        allowed: &'static str,
    },
    /// The path is a folder.
    #[error("cannot write '{}': it is a folder; name a file in it, such as '{}'", path.display(), path.join("picture.png").display())]
    IsFolder {
        /// The requested path.
        path: PathBuf,
    },
    /// The path is a pipe, a device or the like.
    #[error("cannot write '{}': it is neither a file nor a folder; choose another name", path.display())]
    NotAFile {
        /// The requested path.
        path: PathBuf,
    },
    /// The folder to write into does not exist.
    #[error("cannot write '{}': folder '{}' does not exist; create it first, or choose another", path.display(), folder.display())]
    NoFolder {
        /// The requested path.
        path: PathBuf,
        /// The missing folder.
        folder: PathBuf,
    },
    /// The file exists and is read-only.
    #[error("cannot write '{}': the file exists and is read-only; make it writable, or choose another name", path.display())]
    ReadOnly {
        /// The requested path.
        path: PathBuf,
    },
    /// Writing in the folder is not permitted.
    #[error("cannot write '{}': writing in '{}' is not permitted; choose another folder", path.display(), folder.display())]
    NotPermitted {
        /// The requested path.
        path: PathBuf,
        /// The folder.
        folder: PathBuf,
    },
    /// The disk is full.
    #[error("cannot write '{}': the disk is full; free some space, or choose another folder", path.display())]
    DiskFull {
        /// The requested path.
        path: PathBuf,
    },
    /// Any other error of the operating system.
    #[error("cannot write '{}': {source}", path.display())]
    Io {
        /// The requested path.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// The writer was cancelled.
    #[error("'{}' was not written: cancelled", path.display())]
    Cancelled {
        /// The requested path.
        path: PathBuf,
    },
}

fn ending(path: &Path) -> String {
    match (Format::from_path(path), path.extension()) {
        (Some(format), _) => format!("means {}, which cannot hold this content", format.name()),
        (None, Some(ending)) => {
            format!("ends in .{}, which is not a format that dapple writes here", ending.display())
        }
        (None, None) => "has no ending that names the format".to_owned(),
    }
}
