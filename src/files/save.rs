//! Writes files completely or not at all.

use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::abandon::{create_folders, naming};
use super::input::is_standard_output;
use super::stale_files;
use crate::export::{Content, ExportError, Format, Stopped, has_ending};
use crate::machine::fs::{self, File};
use crate::machine::temporary::NamedTempFile;

/// Checks, before the work is done, whether a picture with this `content` can be written to `path`: the ending (upper
/// or lower case), the folder, and what exists at the path. Missing permissions and a full disk are noticed only by
/// [`save()`]. Returns the format. `-` stands for standard output: the complete file is copied there from a temporary
/// file.
///
/// # Errors
/// The problem with the path, and the remedy.
pub fn check_content(path: &Path, content: Content) -> Result<Format, ExportError> {
    check_ending(path, &content.endings())?;
    Ok(Format::from_path(path).unwrap_or(Format::Png))
}

/// Checks, before the work is done, whether a file with one of the endings `allowed` can be written to `path`.
///
/// # Errors
/// The problem with the path, and the remedy.
pub fn check_ending(path: &Path, allowed: &[&'static str]) -> Result<(), ExportError> {
    if is_standard_output(path) {
        return Ok(());
    }
    if fs::is_dir(path) {
        return Err(ExportError::IsFolder { path: path.to_owned() });
    }
    if !allowed.iter().any(|ending| has_ending(path, ending)) {
        return Err(ExportError::UnknownFormat { path: path.to_owned(), allowed: allowed.to_vec() });
    }
    check_file(path)
}

/// Checks the folder of any file, and what exists at the path.
///
/// # Errors
/// The problem with the path, and the remedy.
pub fn check_file(path: &Path) -> Result<(), ExportError> {
    target_of(path).map(drop)
}

/// Creates a folder and its missing parents.
///
/// # Errors
/// The problem, with the folder's name and the remedy.
pub fn make_folder(path: &Path) -> Result<(), ExportError> {
    create_folders(path).map_err(|source| explain(path, &folder_of(path), source))
}

/// Writes the file `path` by `write`, which gets a buffered stream into a temporary file beside it. Once all is on the disk, the
/// temporary file is renamed. Temporary files of killed processes are removed. An existing file is replaced and keeps its
/// permissions; a new one gets the usual ones (0666 without the umask). A symbolic link is kept and its target replaced.
///
/// # Errors
/// The problem, with the file's name and the remedy.
pub fn save(
    path: &Path,
    write: impl FnOnce(&mut Unfinished) -> Result<(), Stopped>,
) -> Result<(), ExportError> {
    prepare(path, write)?.keep()
}

/// A complete file under a temporary name. Dropping it deletes it.
#[derive(Debug)]
#[must_use = "the file is deleted unless it is kept"]
pub struct Prepared {
    path: PathBuf,
    target: PathBuf,
    beside: NamedTempFile,
}

/// Writes a file under a temporary name, in the way of [`save()`]. If several files are prepared before the first is
/// [kept](Prepared::keep), either all of them are written or none.
///
/// # Errors
/// The problem, with the file's name and the remedy.
pub fn prepare(
    path: &Path,
    write: impl FnOnce(&mut Unfinished) -> Result<(), Stopped>,
) -> Result<Prepared, ExportError> {
    let mut file = begin(path)?;
    match write(&mut file) {
        Ok(()) => file.finish(),
        Err(stopped) => Err(file.stopped(stopped)),
    }
}

/// A file that is being written, buffered. Dropping it deletes it.
#[derive(Debug)]
pub struct Unfinished {
    path: PathBuf,
    target: PathBuf,
    folder: PathBuf,
    stream: BufWriter<NamedTempFile>,
}

/// Starts to write the file `path`, for writing several files at once; for one file, [`prepare()`] is simpler.
///
/// # Errors
/// The problem, with the file's name and the remedy.
pub fn begin(path: &Path) -> Result<Unfinished, ExportError> {
    let target = target_of(path)?;
    let folder = if is_standard_output(&target) { std::env::temp_dir() } else { folder_of(&target) };
    let beside = stale_files::new_file(&folder).map_err(|source| explain(path, &folder, source))?;
    Ok(Unfinished { path: path.to_owned(), target, folder, stream: BufWriter::with_capacity(BUFFER, beside) })
}

/// Size of the write buffer, bytes.
const BUFFER: usize = 1 << 20;

impl Unfinished {
    /// Completes the file.
    ///
    /// # Errors
    /// The problem, with the file's name and the remedy.
    pub fn finish(self) -> Result<Prepared, ExportError> {
        let Self { path, target, folder, stream } = self;
        let io = |source| explain(&path, &folder, source);
        let beside = stream.into_inner().map_err(|error| io(error.into_error()))?;
        if !is_standard_output(&target)
            && let Ok(before) = fs::metadata(&target)
        {
            beside.as_file().set_permissions(before.permissions()).map_err(io)?;
        }
        // Some file systems report a full disk only here.
        beside.as_file().sync_all().map_err(io)?;
        Ok(Prepared { path, target, beside })
    }

    /// Deletes the file; returns the error with the file's name and the remedy.
    #[must_use]
    pub fn stopped(self, why: Stopped) -> ExportError {
        let Self { path, folder, stream, .. } = self;
        // The buffer is dropped without being written.
        let _ = stream.into_parts();
        match why {
            Stopped::Cancelled => ExportError::Cancelled { path },
            Stopped::Io(source) => explain(&path, &folder, source),
        }
    }
}

impl Write for Unfinished {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

impl Seek for Unfinished {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.stream.seek(to)
    }
}

impl Prepared {
    /// Renames the file to its final name.
    ///
    /// # Errors
    /// The problem, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), ExportError> {
        naming(|| self.renamed())
    }

    fn renamed(self) -> Result<(), ExportError> {
        let Self { path, target, beside } = self;
        if is_standard_output(&target) {
            let copied = File::open(beside.path()).and_then(|mut file| {
                let mut out = io::stdout().lock();
                io::copy(&mut file, &mut out)?;
                out.flush()
            });
            return copied.map_err(|source| ExportError::Io { path, source });
        }
        let named = beside.persist(&target).map(drop);
        named.map_err(|error| explain(&path, &folder_of(&target), error.error))
    }
}

/// Renames files that belong together to their final names. All of them are renamed, even where the process is told to
/// end.
pub fn keep_all(files: Vec<Prepared>) -> Result<(), ExportError> {
    naming(|| files.into_iter().try_for_each(Prepared::renamed))
}

/// The file to replace or create: `path`, or the target of the link.
fn target_of(path: &Path) -> Result<PathBuf, ExportError> {
    if is_standard_output(path) {
        return Ok(path.to_owned());
    }
    let folder = folder_of(path);
    if !fs::is_dir(&folder) {
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

/// The folder in which the file `path` is.
#[must_use]
pub fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// The error for a file in `folder`, with the remedy.
pub(super) fn explain(path: &Path, folder: &Path, source: io::Error) -> ExportError {
    let path = path.to_owned();
    match source.kind() {
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            ExportError::NotPermitted { path, folder: folder.to_owned() }
        }
        io::ErrorKind::NotADirectory | io::ErrorKind::NotFound if !fs::is_dir(folder) => {
            ExportError::NoFolder { path, folder: folder.to_owned() }
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => ExportError::DiskFull { path },
        _ => ExportError::Io { path, source },
    }
}

#[cfg(test)]
mod tests;
