//! Files: whole or not there.

use std::fs;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;
use thiserror::Error;

use super::Stopped;
use super::format::{Content, Format, endings, fitting};
use crate::export::stale_files;

/// Why a file was not written. Nothing is left behind, and what was there before still is.
#[derive(Debug, Error)]
pub enum ExportError {
    /// An ending that stands for no format.
    #[error("cannot write '{}': its name {}; allowed: .{}", path.display(), ending(path), allowed.join(", ."))]
    UnknownFormat {
        /// What was asked for.
        path: PathBuf,
        /// The endings that would do.
        allowed: Vec<&'static str>,
    },
    /// More px than the format can hold.
    #[error(
        "cannot write '{}': {}×{} px are more than {} can hold; allowed: {} px a side, or another format ({})",
        path.display(), size[0], size[1], format.name(), format.longest(), endings(Content::Colours)
    )]
    TooWide {
        /// What was asked for.
        path: PathBuf,
        /// Width and height, px.
        size: [usize; 2],
        /// The format.
        format: Format,
    },
    /// Something that the format cannot hold.
    #[error("cannot write '{}': {} holds no {what}; allowed: {allowed}", path.display(), format.name())]
    CannotHold {
        /// What was asked for.
        path: PathBuf,
        /// The format.
        format: Format,
        /// What it cannot hold.
        what: &'static str,
        /// What can.
        allowed: &'static str,
    },
    /// A folder has the name already.
    #[error("cannot write '{}': it is a folder; name a file in it, such as '{}'", path.display(), path.join("picture.png").display())]
    IsFolder {
        /// What was asked for.
        path: PathBuf,
    },
    /// A pipe, a device or the like has the name already.
    #[error("cannot write '{}': it is neither a file nor a folder; choose another name", path.display())]
    NotAFile {
        /// What was asked for.
        path: PathBuf,
    },
    /// There is no folder to write into.
    #[error("cannot write '{}': there is no folder '{}'; make it first, or choose another", path.display(), folder.display())]
    NoFolder {
        /// What was asked for.
        path: PathBuf,
        /// The folder that is missing.
        folder: PathBuf,
    },
    /// The file is there and must not be written.
    #[error("cannot write '{}': the file is there and read-only; make it writable, or choose another name", path.display())]
    ReadOnly {
        /// What was asked for.
        path: PathBuf,
    },
    /// The folder must not be written.
    #[error("cannot write '{}': writing in '{}' is not permitted; choose another folder", path.display(), folder.display())]
    NotPermitted {
        /// What was asked for.
        path: PathBuf,
        /// The folder.
        folder: PathBuf,
    },
    /// No room.
    #[error("cannot write '{}': the disk is full; make room, or choose another folder", path.display())]
    DiskFull {
        /// What was asked for.
        path: PathBuf,
    },
    /// Whatever else the operating system says.
    #[error("cannot write '{}': {source}", path.display())]
    Io {
        /// What was asked for.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The writer was told to stop.
    #[error("'{}' was not written: cancelled", path.display())]
    Cancelled {
        /// What was asked for.
        path: PathBuf,
    },
}

fn ending(path: &Path) -> String {
    match (Format::of(path), path.extension()) {
        (Some(format), _) => format!("asks for {}, which does not fit what is to be shown", format.name()),
        (None, Some(ending)) => {
            format!("ends in .{}, which is no format that dapple writes here", ending.display())
        }
        (None, None) => "has no ending that says in which format".to_owned(),
    }
}

/// Looks whether a picture of colours can be written to `path`, before the work is done: the name's ending (upper or
/// lower case), the folder, and what has the name already. Rights and room show only in [`save()`].
///
/// # Errors
/// What is wrong with the path, and the remedy.
pub fn check_target(path: &Path) -> Result<(), ExportError> {
    check_content(path, Content::Colours).map(drop)
}

/// The same for a picture that shows `content`; its format.
///
/// # Errors
/// What is wrong with the path, and the remedy.
pub fn check_content(path: &Path, content: Content) -> Result<Format, ExportError> {
    check_ending(path, &fitting(content))?;
    Ok(Format::of(path).unwrap_or(Format::Png))
}

/// The same for a file that may have one of the endings `allowed`.
///
/// # Errors
/// What is wrong with the path, and the remedy.
pub fn check_ending(path: &Path, allowed: &[&'static str]) -> Result<(), ExportError> {
    if path.is_dir() {
        return Err(ExportError::IsFolder { path: path.to_owned() });
    }
    if !allowed.iter().any(|ending| has_ending(path, ending)) {
        return Err(ExportError::UnknownFormat { path: path.to_owned(), allowed: allowed.to_vec() });
    }
    check_file(path)
}

/// Whether a name ends in `.ending`, in upper or lower case.
#[must_use]
pub fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}

/// The same for a file that is no picture: the folder, and what has the name already.
///
/// # Errors
/// What is wrong with the path, and the remedy.
pub fn check_file(path: &Path) -> Result<(), ExportError> {
    target_of(path).map(drop)
}

/// Makes a folder, and those above it, where they are missing.
///
/// # Errors
/// What went wrong, with the folder's name and the remedy.
pub fn make_folder(path: &Path) -> Result<(), ExportError> {
    fs::create_dir_all(path).map_err(|source| explain(path, &folder_of(path), source))
}

/// Writes the file `path` by `write`, which gets a buffered stream: into a file beside it that takes its name
/// when all is on the disk; what a killed process left of such is taken away. A file that was there is replaced and keeps its permissions; a new one gets
/// the usual ones (0666 less the umask). A symbolic link stays and what it leads to is replaced.
///
/// # Errors
/// What went wrong, with the file's name and the remedy.
pub fn save(path: &Path, write: impl FnOnce(&mut Begun) -> Result<(), Stopped>) -> Result<(), ExportError> {
    prepare(path, write)?.keep()
}

/// A file that is written but does not have its name yet. Dropped, it is gone.
#[derive(Debug)]
#[must_use = "the file goes unless it is kept"]
pub struct Prepared {
    path: PathBuf,
    target: PathBuf,
    beside: NamedTempFile,
}

/// As [`save()`], up to the point where the file takes its name: several files are there together, or none, where
/// all are prepared before the first is [kept](Prepared::keep).
///
/// # Errors
/// What went wrong, with the file's name and the remedy.
pub fn prepare(
    path: &Path,
    write: impl FnOnce(&mut Begun) -> Result<(), Stopped>,
) -> Result<Prepared, ExportError> {
    let mut begun = begin(path)?;
    match write(&mut begun) {
        Ok(()) => begun.finish(),
        Err(stopped) => Err(begun.stopped(stopped)),
    }
}

/// A file that is being written, buffered. Dropped, it is gone.
#[derive(Debug)]
pub struct Begun {
    path: PathBuf,
    target: PathBuf,
    folder: PathBuf,
    stream: BufWriter<NamedTempFile>,
}

/// Begins the file `path`, for whoever writes several at once; [`prepare()`] is simpler for one.
///
/// # Errors
/// What went wrong, with the file's name and the remedy.
pub fn begin(path: &Path) -> Result<Begun, ExportError> {
    let target = target_of(path)?;
    let folder = folder_of(&target);
    let beside = stale_files::new_file(&folder).map_err(|source| explain(path, &folder, source))?;
    Ok(Begun { path: path.to_owned(), target, folder, stream: BufWriter::with_capacity(BUFFER, beside) })
}

/// Bytes that are gathered before they go to the disk.
const BUFFER: usize = 1 << 20;

impl Begun {
    /// All is written.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn finish(self) -> Result<Prepared, ExportError> {
        let Self { path, target, folder, stream } = self;
        let io = |source| explain(&path, &folder, source);
        let beside = stream.into_inner().map_err(|error| io(error.into_error()))?;
        if let Ok(before) = fs::metadata(&target) {
            beside.as_file().set_permissions(before.permissions()).map_err(io)?;
        }
        // Some file systems tell only now that there is no room.
        beside.as_file().sync_all().map_err(io)?;
        Ok(Prepared { path, target, beside })
    }

    /// Why it was not written, with the file's name and the remedy.
    #[must_use]
    pub fn stopped(self, why: Stopped) -> ExportError {
        let Self { path, folder, stream, .. } = self;
        // What is still in the buffer need not go anywhere.
        let _ = stream.into_parts();
        match why {
            Stopped::Cancelled => ExportError::Cancelled { path },
            Stopped::Io(source) => explain(&path, &folder, source),
        }
    }
}

impl Write for Begun {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

impl Seek for Begun {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.stream.seek(to)
    }
}

impl Prepared {
    /// Gives the file its name.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), ExportError> {
        let Self { path, target, beside } = self;
        let named = beside.persist(&target).map(drop);
        named.map_err(|error| explain(&path, &folder_of(&target), error.error))
    }
}

/// The file to be replaced or made: `path`, or where it leads to.
fn target_of(path: &Path) -> Result<PathBuf, ExportError> {
    let folder = folder_of(path);
    if !folder.is_dir() {
        return Err(ExportError::NoFolder { path: path.to_owned(), folder });
    }
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => Err(ExportError::IsFolder { path: path.to_owned() }),
        Ok(there) if !there.is_file() => Err(ExportError::NotAFile { path: path.to_owned() }),
        Ok(there) if there.permissions().readonly() => Err(ExportError::ReadOnly { path: path.to_owned() }),
        Ok(_) => fs::canonicalize(path).map_err(|source| explain(path, &folder, source)),
        Err(_) if path.file_name().is_none() => Err(ExportError::NotAFile { path: path.to_owned() }),
        Err(_) => Ok(path.to_owned()),
    }
}

pub(super) fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// What went wrong with a file in `folder`, and the remedy.
pub(super) fn explain(path: &Path, folder: &Path, source: io::Error) -> ExportError {
    let path = path.to_owned();
    match source.kind() {
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            ExportError::NotPermitted { path, folder: folder.to_owned() }
        }
        io::ErrorKind::NotADirectory | io::ErrorKind::NotFound if !folder.is_dir() => {
            ExportError::NoFolder { path, folder: folder.to_owned() }
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => ExportError::DiskFull { path },
        _ => ExportError::Io { path, source },
    }
}

#[cfg(test)]
mod tests;
