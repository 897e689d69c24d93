//! A folder of PNG files: `frame-0001.png`, …

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use tempfile::TempDir;

use super::{Film, PreparedFilm, Show};
use crate::export::abandon::naming;
use crate::export::save::{explain, folder_of};
use crate::export::{ExportError, Stopped, check_file, png, stale_files};

/// Checks whether frames can be written into a folder `path`: it must not exist, or be an empty folder.
///
/// # Errors
/// The problem with the path, and the remedy.
pub fn check(path: &Path) -> Result<(), ExportError> {
    if !path.is_dir() {
        check_file(path)?;
        return match path.exists() {
            true => Err(io_error(path, io::Error::other("a file has this name; choose another"))),
            false => Ok(()),
        };
    }
    let mut inside = fs::read_dir(path).map_err(|source| io_error(path, source))?;
    match inside.next() {
        None => Ok(()),
        Some(_) => {
            let reason =
                "the folder is not empty, and frames of two films would mix; empty it, or name a new one";
            Err(io_error(path, io::Error::other(reason)))
        }
    }
}

/// Writes the frames that `play` passes to its argument into a temporary folder beside `path`.
pub fn write(
    path: &Path,
    film: &Film,
    play: impl FnOnce(Show) -> Result<(), Stopped>,
) -> Result<PreparedFilm, ExportError> {
    let parent = folder_of(path);
    let (beside, lock) = stale_files::new_folder(&parent).map_err(|source| explain(path, &parent, source))?;
    let digits = film.frames.to_string().len().max(4);
    let mut index = 0;
    let played = play(&mut |rgb| {
        index += 1;
        let file = File::create(beside.path().join(format!("frame-{index:0digits$}.png")))?;
        let mut out = BufWriter::new(&file);
        png::rgb8(&mut out, film.size, None, rgb)?;
        out.flush()?;
        Ok(file.sync_all()?)
    });
    match played {
        Ok(()) => Ok(PreparedFilm::Folder { beside, target: path.to_owned(), _lock: lock }),
        Err(Stopped::Cancelled) => Err(ExportError::Cancelled { path: path.to_owned() }),
        Err(Stopped::Io(source)) => Err(explain(path, &parent, source)),
    }
}

/// Renames the folder to its final name.
pub fn keep(beside: TempDir, target: &Path) -> Result<(), ExportError> {
    naming(|| {
        // Replaces an empty folder, if permitted.
        let _ = fs::remove_dir(target);
        fs::rename(beside.path(), target)
    })
    .map_err(|source| explain(target, &folder_of(target), source))?;
    // It has been moved: nothing is left to delete.
    let _ = beside.keep();
    Ok(())
}

fn io_error(path: &Path, source: io::Error) -> ExportError {
    ExportError::Io { path: path.to_owned(), source }
}
