//! Writes films to files: of a growth, or of the change of one document into another. A film is a file, or a folder of
//! `frame-0001.png`, …

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::abandon::naming;
use super::input::is_standard_output;
use super::save::{Prepared, check_ending, check_file, explain, folder_of, prepare};
use super::stale_files;
use crate::document::Document;
use crate::export::motion::{FORMATS, Film, Kind, Show, apng, gif};
use crate::export::{ExportError, Stopped, has_ending, png};
use crate::machine::fs::{self, File};
use crate::machine::temporary::TempDir;
use crate::synth::render::clip::{Clip, ClipError};
use crate::synth::render::film::{FilmError, Scene, Takes};
use crate::synth::render::morph::Morph;
use crate::synth::{GrowError, Watch};

/// The format of the film `path`: by the ending .gif, .png or .apng; a folder if it has no ending.
///
/// # Errors
/// Another ending; the problem with the path, and the remedy.
pub fn film_kind(path: &Path) -> Result<Kind, ExportError> {
    if is_standard_output(path) {
        return Ok(Kind::Gif);
    }
    if path.extension().is_none() {
        return check_folder(path).map(|()| Kind::Folder);
    }
    check_ending(path, &FORMATS)?;
    check_file(path)?;
    Ok(if has_ending(path, "gif") { Kind::Gif } else { Kind::Apng })
}

/// A complete film under a temporary name. Dropping it deletes it.
#[derive(Debug)]
#[must_use = "the film is deleted unless it is kept"]
pub enum PreparedFilm {
    /// In one file.
    File(Prepared),
    /// In a folder.
    Folder {
        /// The temporary folder, beside the final path.
        beside: TempDir,
        /// Its final path.
        target: PathBuf,
        /// Other processes do not remove the folder while this lock is held.
        _lock: Option<File>,
    },
}

impl PreparedFilm {
    /// Renames the film to its final name.
    ///
    /// # Errors
    /// The problem, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), ExportError> {
        match self {
            Self::File(file) => file.keep(),
            Self::Folder { beside, target, _lock } => keep_folder(beside, &target),
        }
    }
}

/// Writes a film to `path`: `play` passes all its frames, one after the other, to its argument.
///
/// # Errors
/// The problem, with the file's name and the remedy; the error of `play`.
pub fn write_film(
    path: &Path,
    kind: Kind,
    film: &Film,
    play: impl FnOnce(Show) -> Result<(), Stopped>,
) -> Result<PreparedFilm, ExportError> {
    match kind {
        Kind::Gif => prepare(path, |out| gif::write(out, film, play)).map(PreparedFilm::File),
        Kind::Apng => prepare(path, |out| apng::write(out, film, play)).map(PreparedFilm::File),
        Kind::Folder => write_folder(path, film, play),
    }
}

/// Films in files.
pub trait SaveFilm {
    /// Films a growth into a temporary file. It is grown twice: once to measure how much each moment changes.
    ///
    /// # Errors
    /// [`ClipError`].
    fn film_growth(&self, scene: &Scene, path: &Path, kind: Kind) -> Result<(PreparedFilm, Film), ClipError>;

    /// Films how the first of these documents becomes the other, into a temporary file.
    ///
    /// # Errors
    /// [`ClipError`].
    fn film_change(
        &self,
        documents: [&Document; 2],
        morph: &Morph,
        path: &Path,
        kind: Kind,
        watch: &Watch,
    ) -> Result<(PreparedFilm, Film), ClipError>;
}

impl SaveFilm for Clip {
    fn film_growth(&self, scene: &Scene, path: &Path, kind: Kind) -> Result<(PreparedFilm, Film), ClipError> {
        let takes = Takes::record(scene, self.frames(kind)?)?;
        let film = self.film(&[scene.document], takes.frames());
        let prepared = written(path, kind, &film, &|show| takes.play(scene, film.size, show))?;
        Ok((prepared, film))
    }

    fn film_change(
        &self,
        documents: [&Document; 2],
        morph: &Morph,
        path: &Path,
        kind: Kind,
        watch: &Watch,
    ) -> Result<(PreparedFilm, Film), ClipError> {
        let frames = self.frames(kind)?;
        let film = self.film(&documents, frames);
        let play = |show: Show| morph.clone().play(frames, film.size, watch, show);
        Ok((written(path, kind, &film, &play)?, film))
    }
}

/// Shows all frames in order.
type Play<'a> = &'a dyn Fn(Show) -> Result<(), FilmError>;

/// Writes the film to a temporary file.
fn written(path: &Path, kind: Kind, film: &Film, play: Play) -> Result<PreparedFilm, ClipError> {
    let mut failed: Option<GrowError> = None;
    let written = write_film(path, kind, film, |show| match play(show) {
        Ok(()) => Ok(()),
        Err(FilmError::Stopped(stopped)) => Err(stopped),
        Err(FilmError::Grow(error)) => {
            failed = Some(error);
            Err(Stopped::Cancelled)
        }
    });
    match failed {
        Some(error) => Err(error.into()),
        None => Ok(written?),
    }
}

/// Checks whether frames can be written into a folder `path`: it must not exist, or be an empty folder.
///
/// # Errors
/// The problem with the path, and the remedy.
fn check_folder(path: &Path) -> Result<(), ExportError> {
    if !fs::is_dir(path) {
        check_file(path)?;
        return match fs::exists(path) {
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
fn write_folder(
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
fn keep_folder(beside: TempDir, target: &Path) -> Result<(), ExportError> {
    naming(|| {
        // Replaces an empty folder, if permitted.
        let _ = fs::remove_dir(target);
        fs::rename(beside.path(), target)
    })
    .map_err(|source| explain(target, &folder_of(target), source))?;
    // The folder has been moved, so there is nothing to delete.
    let _ = beside.keep();
    Ok(())
}

fn io_error(path: &Path, source: io::Error) -> ExportError {
    ExportError::Io { path: path.to_owned(), source }
}
